#pragma once

#include <taut/material/elastomer.h>

namespace taut::material
{
/// The modulus (Pa) that networks relax to, that of the springs; of the
/// networks if there is no spring.
inline double get_lasting_modulus(const Elastomer& elastomer)
{
  double modulus = 0.;
  for (const Spring& spring : elastomer.springs)
    modulus += shear_modulus(spring);
  return modulus > 0. ? modulus : shear_modulus(elastomer);
}

/// What wrinkles cost, 2 delta G (Pa), relative to the lasting modulus G:
/// little enough not to matter.
inline double get_wrinkle_stiffness(const Elastomer& elastomer,
                                    const double delta = 1e-6)
{
  return 2. * delta * get_lasting_modulus(elastomer);
}

/// A material line (tangent vector) of the film.
template <class Number>
struct Line
{
  Number x, y;
};

template <class Number>
Number dot(const Line<Number>& a, const Line<Number>& b)
{
  return a.x * b.x + a.y * b.y;
}

/// a . T b.
template <class Number>
Number contract(const Line<Number>& a, const SymmetricTensor2<Number>& T,
                const Line<Number>& b)
{
  return a.x * b.x * T.xx + a.y * b.y * T.yy + (a.x * b.y + a.y * b.x) * T.xy;
}

/// Two lines, orthonormal in the metric C^-1: they become orthonormal in space
/// when raised by C. Wrinkles run along the second, w w^T = a first first^T.
template <class Number>
struct WrinkleDirections
{
  Line<Number> across, along;
};

template <class Number>
struct Wrinkles
{
  SymmetricTensor2<Number> metric; ///< C* = C + E
  /// Of wrinkles in one direction: E = amplitude across across^T.
  Number amplitude;
  WrinkleDirections<Number> directions;
  /// Along the wrinkles, principal true stress times J and what they cost
  /// (Pa).
  Number tension;
  Mask<Number> wrinkled; ///< in one direction
  Mask<Number> slack;    ///< wrinkled in both
  /// False where the wrinkled film widens without end or leaves the limits of
  /// its springs.
  Mask<Number> admissible;
  double stiffness; ///< 2 delta G (Pa)
};

template <class Number>
SymmetricTensor2<Number> choose(const Mask<Number>& condition,
                                const SymmetricTensor2<Number>& a,
                                const SymmetricTensor2<Number>& b)
{
  return {select(condition, a.xx, b.xx), select(condition, a.yy, b.yy),
          select(condition, a.xy, b.xy)};
}

template <class Number>
Line<Number> choose(const Mask<Number>& condition, const Line<Number>& a,
                    const Line<Number>& b)
{
  return {select(condition, a.x, b.x), select(condition, a.y, b.y)};
}

/// The three numbers of a tensor under a map of tensors.h.
template <class Number>
SymmetricTensor2<Number> multiply(const Matrix3<Number>& map,
                                  const SymmetricTensor2<Number>& a)
{
  const auto row = [&](const unsigned int i) -> Number
  { return map[i][0] * a.xx + map[i][1] * a.yy + map[i][2] * a.xy; };
  return {row(0), row(1), row(2)};
}

template <class Number>
Matrix3<Number> compute_inverse(const Matrix3<Number>& a)
{
  const auto cofactor = [&](const unsigned int i,
                            const unsigned int j) -> Number
  {
    const unsigned int r = (i + 1) % 3, s = (i + 2) % 3;
    const unsigned int p = (j + 1) % 3, q = (j + 2) % 3;
    return a[r][p] * a[s][q] - a[r][q] * a[s][p];
  };
  Matrix3<Number> result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      result[i][j] = cofactor(j, i);
  const Number factor = 1. / (a[0][0] * result[0][0] + a[0][1] * result[1][0] +
                              a[0][2] * result[2][0]);
  for (auto& row : result)
    for (Number& entry : row)
      entry = factor * entry;
  return result;
}

/// D + 2 delta G diag(2, 2, 1): the derivative of T by the half of E in
/// engineering components.
template <class Number>
Matrix3<Number> add_wrinkle_stiffness(const Matrix3<Number>& D,
                                      const double stiffness)
{
  Matrix3<Number> result = D;
  result[0][0] = D[0][0] + 2. * stiffness;
  result[1][1] = D[1][1] + 2. * stiffness;
  result[2][2] = D[2][2] + stiffness;
  return result;
}

/// T = S + 2 delta G (1 + E), twice the derivative of the minimised energy by
/// E.
template <class Number>
SymmetricTensor2<Number> compute_wrinkle_tension(
    const SymmetricTensor2<Number>& metric, const SymmetricTensor2<Number>& C,
    const SymmetricTensor2<Number>& S, const double stiffness)
{
  const Number factor(stiffness);
  return {S.xx + factor * (1. + (metric.xx - C.xx)),
          S.yy + factor * (1. + (metric.yy - C.yy)),
          S.xy + factor * (metric.xy - C.xy)};
}

/// The conditions on wrinkles in one direction, w_1 . T w_1 = 0 and
/// w_2 . T w_1 = 0 with w_1 across and w_2 along them, and their derivatives by
/// the amplitude a and the angle of w_1, E = a w_1 w_1^T.
template <class Number>
struct WrinkleEquations
{
  /// `T` from compute_wrinkle_tension.
  WrinkleEquations(const WrinkleDirections<Number>& directions,
                   const Number& amplitude, const SymmetricTensor2<Number>& T,
                   const Matrix3<Number>& D, double stiffness);

  /// B M^-1 R of make_wrinkle_response.
  Matrix3<Number> make_response() const;

  Number across, mixed; ///< w_1 . T w_1 and w_2 . T w_1
  Number along;         ///< w_2 . T w_2
  /// Derivatives of the three by amplitude and angle.
  Number across_amplitude, across_angle, mixed_amplitude, mixed_angle;
  Number along_amplitude, along_angle;

private:
  /// What takes (S_xx, S_yy, S_xy) to the two conditions.
  SymmetricTensor2<Number> row_across_, row_mixed_;
  Number amplitude_;
};

template <class Number>
WrinkleEquations<Number>::WrinkleEquations(
    const WrinkleDirections<Number>& directions, const Number& amplitude,
    const SymmetricTensor2<Number>& T, const Matrix3<Number>& D,
    const double stiffness)
    : amplitude_(amplitude)
{
  const Line<Number>& v = directions.across;
  const Line<Number>& u = directions.along;
  const auto row = [](const Line<Number>& a, const Line<Number>& b)
  {
    return SymmetricTensor2<Number>{a.x * b.x, a.y * b.y,
                                    a.x * b.y + a.y * b.x};
  };
  const auto product = [](const SymmetricTensor2<Number>& a,
                          const SymmetricTensor2<Number>& b) -> Number
  { return a.xx * b.xx + a.yy * b.yy + a.xy * b.xy; };
  row_across_ = row(v, v);
  row_mixed_ = row(u, v);
  const auto row_along = row(u, u);
  // The half of v v^T in engineering components is (v_x^2/2, v_y^2/2, v_x v_y).
  const auto by_amplitude = multiply(D, row_across_);
  const auto by_angle = multiply(D, row_mixed_);
  const Number vv = dot(v, v), uv = dot(u, v), uu = dot(u, u);
  across = contract(v, T, v);
  mixed = contract(u, T, v);
  along = contract(u, T, u);
  across_amplitude =
      0.5 * product(row_across_, by_amplitude) + stiffness * vv * vv;
  mixed_amplitude =
      0.5 * product(row_mixed_, by_amplitude) + stiffness * vv * uv;
  across_angle =
      amplitude * (product(row_across_, by_angle) + 2. * stiffness * vv * uv) +
      2. * mixed;
  mixed_angle = amplitude * (product(row_mixed_, by_angle) +
                             stiffness * (vv * uu + uv * uv)) +
                along - across;
  along_amplitude =
      0.5 * product(row_along, by_amplitude) + stiffness * uv * uv;
  along_angle =
      amplitude * (product(row_along, by_angle) + 2. * stiffness * uv * uu) -
      2. * mixed;
}

template <class Number>
Matrix3<Number> WrinkleEquations<Number>::make_response() const
{
  const Number inverse =
      1. / (across_amplitude * mixed_angle - across_angle * mixed_amplitude);
  const auto solution = [&](const Number& r_across, const Number& r_mixed)
  {
    // Half of the amplitude's change, and a times the angle's.
    const Number half_amplitude =
        0.5 * inverse * (mixed_angle * r_across - across_angle * r_mixed);
    const Number angle =
        inverse * (across_amplitude * r_mixed - mixed_amplitude * r_across);
    const Number shear = amplitude_ * angle;
    return combine(half_amplitude, row_across_, shear, row_mixed_);
  };
  const auto xx = solution(row_across_.xx, row_mixed_.xx);
  const auto yy = solution(row_across_.yy, row_mixed_.yy);
  const auto xy = solution(row_across_.xy, row_mixed_.xy);
  return {{{{xx.xx, yy.xx, xy.xx}},
           {{xx.yy, yy.yy, xy.yy}},
           {{xx.xy, yy.xy, xy.xy}}}};
}
} // namespace taut::material
