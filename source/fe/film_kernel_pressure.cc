#include "film_kernel_detail.h"

namespace taut::fe
{
namespace
{
/// The two tangents dx/dxi, dx/deta at a point.
template <unsigned int n_nodes>
inline DeformationGradient make_tangents(const double* shape_gradients,
                                         const Lanes* x)
{
  DeformationGradient tangents;
  for (unsigned int d = 0; d < 3; ++d)
    tangents.f1[d] = tangents.f2[d] = Lanes(0.);
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (unsigned int d = 0; d < 3; ++d)
    {
      tangents.f1[d] += x[3 * a + d] * Lanes(shape_gradients[2 * a]);
      tangents.f2[d] += x[3 * a + d] * Lanes(shape_gradients[2 * a + 1]);
    }
  return tangents;
}

template <unsigned int n_nodes>
void compute_pressure_forces(const double* shape_values,
                             const double* shape_gradients,
                             const double* weights, const Lanes& active,
                             const Lanes* x, const double pressure, Lanes* f)
{
  for (unsigned int i = 0; i < 3 * n_nodes; ++i)
    f[i] = Lanes(0.);
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const auto tangents =
        make_tangents<n_nodes>(shape_gradients + 2 * n_nodes * q, x);
    const Vector normal = cross(tangents.f1, tangents.f2);
    const Lanes w = active * Lanes(pressure * weights[q]);
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int d = 0; d < 3; ++d)
        f[3 * a + d] += w * Lanes(shape_values[q * n_nodes + a]) * normal[d];
  }
}

/// The matrix of v -> t x v.
inline Lanes cross_matrix(const Vector& t, const unsigned int i,
                          const unsigned int j)
{
  if (i == j)
    return Lanes(0.);
  const unsigned int k = 3 - i - j;
  return (j + 1) % 3 == i ? t[k] : -t[k];
}

template <unsigned int n_nodes>
void add_pressure_stiffness(const double* shape_values,
                            const double* shape_gradients,
                            const double* weights, const Lanes& active,
                            const Lanes* x, const double pressure,
                            const bool symmetric, Lanes* K)
{
  constexpr unsigned int n = 3 * n_nodes;
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const double* gradients = shape_gradients + 2 * n_nodes * q;
    const double* values = shape_values + q * n_nodes;
    const auto tangents = make_tangents<n_nodes>(gradients, x);
    const Lanes w = active * Lanes(pressure * weights[q]);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
      {
        if (i == j)
          continue;
        // d(t1 x t2)/dx_b = [t1 x] dN_b/deta - [t2 x] dN_b/dxi.
        const Lanes c1 = w * cross_matrix(tangents.f1, i, j);
        const Lanes c2 = w * cross_matrix(tangents.f2, i, j);
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int b = 0; b < (symmetric ? a + 1 : n_nodes); ++b)
          {
            Lanes change = values[a] * (c1 * Lanes(gradients[2 * b + 1]) -
                                        c2 * Lanes(gradients[2 * b]));
            if (symmetric)
              // The transposed block (b j, a i); the cross matrix is skew.
              change = Lanes(0.5) *
                       (change - values[b] * (c1 * Lanes(gradients[2 * a + 1]) -
                                              c2 * Lanes(gradients[2 * a])));
            K[(3 * a + i) * n + 3 * b + j] -= change;
          }
      }
  }
}
} // namespace

void compute_pressure_forces(const unsigned int n_nodes,
                             const double* shape_values,
                             const double* shape_gradients,
                             const double* weights, const double* active,
                             const double* positions, const double pressure,
                             double* forces)
{
  with_nodes(n_nodes,
             [&](const auto n)
             {
               compute_pressure_forces<n>(
                   shape_values, shape_gradients, weights, *as_lanes(active),
                   as_lanes(positions), pressure, as_lanes(forces));
             });
}

void add_pressure_stiffness(const unsigned int n_nodes,
                            const double* shape_values,
                            const double* shape_gradients,
                            const double* weights, const double* active,
                            const double* positions, const double pressure,
                            const bool symmetric, double* stiffness)
{
  with_nodes(n_nodes,
             [&](const auto n)
             {
               add_pressure_stiffness<n>(shape_values, shape_gradients, weights,
                                         *as_lanes(active), as_lanes(positions),
                                         pressure, symmetric,
                                         as_lanes(stiffness));
             });
}
} // namespace taut::fe
