#include "beam_element_strain.h"

#include <taut/fe/vector3.h>

namespace taut::fe
{
namespace
{
// Places of x', q = (a, w) and q' = (a', w') among the 11 numbers.
constexpr unsigned int at_slope = 0, at_a = 3, at_w = 4, at_twist_a = 7,
                       at_twist_w = 8;

Vector3 get_vector(const Quaternion& q)
{
  return {q[1], q[2], q[3]};
}

double square(const Quaternion& q)
{
  return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
}

// A combination of strains is p/s with s = |q|^2 and the polynomial
//   p = (a^2 - w.w) n.x' + 2 (n.w)(w.x') - 2 a n.(w x x')
//       + 2 m.(a w' - a' w - w x w').

double compute_polynomial(const StrainCombination& combination,
                          const BeamPointState& state)
{
  const auto& [n, m] = combination;
  const auto& x = state.slope;
  const double a = state.q[0], twist_a = state.twist[0];
  const Vector3 w = get_vector(state.q), twist_w = get_vector(state.twist);
  return (a * a - dot(w, w)) * dot(n, x) + 2 * dot(n, w) * dot(w, x) -
         2 * a * dot(n, cross(w, x)) +
         2 * (a * dot(m, twist_w) - twist_a * dot(m, w) -
              dot(m, cross(w, twist_w)));
}

BeamGradient compute_polynomial_gradient(const StrainCombination& combination,
                                         const BeamPointState& state)
{
  const auto& [n, m] = combination;
  const auto& x = state.slope;
  const double a = state.q[0], twist_a = state.twist[0];
  const Vector3 w = get_vector(state.q), twist_w = get_vector(state.twist);
  const Vector3 n_w = cross(n, w), x_n = cross(x, n), m_w = cross(m, w);
  const Vector3 twist_m = cross(twist_w, m);
  const double nx = dot(n, x), nw = dot(n, w), wx = dot(w, x);
  const double rest = a * a - dot(w, w);
  BeamGradient g;
  g[at_a] = 2 * (a * nx - dot(w, x_n) + dot(m, twist_w));
  g[at_twist_a] = -2 * dot(m, w);
  for (unsigned int i = 0; i < 3; ++i)
  {
    g[at_slope + i] = rest * n[i] + 2 * (nw * w[i] - a * n_w[i]);
    g[at_w + i] = 2 * (wx * n[i] + nw * x[i] - nx * w[i] - a * x_n[i] -
                       twist_a * m[i] - twist_m[i]);
    g[at_twist_w + i] = 2 * (a * m[i] - m_w[i]);
  }
  return g;
}

/// (v x e_j)_i.
double get_cross_matrix(const Vector3& v, const unsigned int i,
                        const unsigned int j)
{
  if (i == j)
    return 0;
  const unsigned int k = 3 - i - j;
  return (i + 1) % 3 == k ? v[k] : -v[k];
}

void set_symmetric(BeamHessian& H, const unsigned int i, const unsigned int j,
                   const double value)
{
  H[i][j] = H[j][i] = value;
}

BeamHessian compute_polynomial_hessian(const StrainCombination& combination,
                                       const BeamPointState& state)
{
  const auto& [n, m] = combination;
  const auto& x = state.slope;
  const double a = state.q[0];
  const Vector3 w = get_vector(state.q);
  const Vector3 n_w = cross(n, w), x_n = cross(x, n);
  const double nx = dot(n, x), nw = dot(n, w);
  BeamHessian H{};
  H[at_a][at_a] = 2 * nx;
  for (unsigned int i = 0; i < 3; ++i)
  {
    set_symmetric(H, at_a, at_slope + i, 2 * (a * n[i] - n_w[i]));
    set_symmetric(H, at_a, at_w + i, -2 * x_n[i]);
    set_symmetric(H, at_a, at_twist_w + i, 2 * m[i]);
    set_symmetric(H, at_twist_a, at_w + i, -2 * m[i]);
    for (unsigned int j = 0; j < 3; ++j)
    {
      const double same = i == j ? 1 : 0;
      H[at_w + i][at_w + j] = 2 * (n[i] * x[j] + x[i] * n[j] - same * nx);
      set_symmetric(H, at_slope + i, at_w + j,
                    2 * (w[i] * n[j] - n[i] * w[j] + same * nw -
                         a * get_cross_matrix(n, i, j)));
      set_symmetric(H, at_twist_w + i, at_w + j,
                    -2 * get_cross_matrix(m, i, j));
    }
  }
  return H;
}
} // namespace

double compute_value(const StrainCombination& combination,
                     const BeamPointState& state)
{
  return compute_polynomial(combination, state) / square(state.q);
}

BeamGradient compute_gradient(const StrainCombination& combination,
                              const BeamPointState& state)
{
  const double inverse_s = 1 / square(state.q);
  const double ratio = compute_polynomial(combination, state) * inverse_s;
  BeamGradient g = compute_polynomial_gradient(combination, state);
  for (unsigned int i = 0; i < 4; ++i)
    g[at_a + i] -= 2 * ratio * state.q[i];
  for (double& component : g)
    component *= inverse_s;
  return g;
}

BeamHessian compute_hessian(const StrainCombination& combination,
                            const BeamPointState& state)
{
  // With r = p/s: s r_ij = p_ij - r_i s_j - s_i r_j - r s_ij.
  const double inverse_s = 1 / square(state.q);
  const double ratio = compute_polynomial(combination, state) * inverse_s;
  const BeamGradient g = compute_gradient(combination, state);
  BeamHessian H = compute_polynomial_hessian(combination, state);
  for (unsigned int i = 0; i < 4; ++i)
  {
    for (unsigned int j = 0; j < 11; ++j)
    {
      H[at_a + i][j] -= 2 * state.q[i] * g[j];
      H[j][at_a + i] -= 2 * state.q[i] * g[j];
    }
    H[at_a + i][at_a + i] -= 2 * ratio;
  }
  for (auto& row : H)
    for (double& component : row)
      component *= inverse_s;
  return H;
}
} // namespace taut::fe
