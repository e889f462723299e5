#include "beam_element_quaternions.h"

#include <taut/base/rotation.h>

#include <cmath>

namespace taut::fe
{
namespace
{
/// |Q| of the four numbers.
double norm(const double* Q)
{
  return length(Quaternion{Q[0], Q[1], Q[2], Q[3]});
}
} // namespace

std::vector<double> normalise(const unsigned int n_nodes,
                              const double* unknowns)
{
  std::vector<double> unit(unknowns, unknowns + 7 * n_nodes);
  for (unsigned int a = 0; a < n_nodes; ++a)
  {
    const double inverse = 1 / norm(&unit[3 * n_nodes + 4 * a]);
    for (unsigned int i = 0; i < 4; ++i)
      unit[3 * n_nodes + 4 * a + i] *= inverse;
  }
  return unit;
}

void project(const unsigned int n_nodes, const std::vector<double>& unit,
             const double* unknowns, double* numbers, const std::size_t stride)
{
  for (unsigned int a = 0; a < n_nodes; ++a)
  {
    const unsigned int first = 3 * n_nodes + 4 * a;
    const double inverse = 1 / norm(unknowns + first);
    double along = 0;
    for (unsigned int i = 0; i < 4; ++i)
      along += unit[first + i] * numbers[(first + i) * stride];
    for (unsigned int i = 0; i < 4; ++i)
    {
      double& number = numbers[(first + i) * stride];
      number = inverse * (number - along * unit[first + i]);
    }
  }
}

void add_curvature(const unsigned int n_nodes, const std::vector<double>& unit,
                   const double* unknowns, const std::vector<double>& forces,
                   double* matrix)
{
  for (unsigned int a = 0; a < n_nodes; ++a)
  {
    const unsigned int first = 3 * n_nodes + 4 * a;
    const double* q = &unit[first];
    const double* g = &forces[first];
    const double scale = 1 / std::pow(norm(unknowns + first), 2);
    const double gq = g[0] * q[0] + g[1] * q[1] + g[2] * q[2] + g[3] * q[3];
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        matrix[(first + i) * 7 * n_nodes + first + j] -=
            scale * (q[i] * g[j] + g[i] * q[j] +
                     gq * ((i == j ? 1 : 0) - 3 * q[i] * q[j]));
  }
}
} // namespace taut::fe
