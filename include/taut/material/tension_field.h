#pragma once

#include <taut/material/tension_field_search.h>

// A film that wrinkles or goes slack instead of carrying compression. Its
// energy is the smallest that wrinkles finer than the film can reach,
//   W_r(C, A) = min over E >= 0 of W(C + E, A) + delta G (tr E + E : E/2),
// with G the modulus of the springs. The term with delta is what folding costs:
// it keeps a slack film from being without any stiffness and a film that is
// just not stressed from being called slack. Stresses, rates and charges are
// those at the metric C* = C + E of the wrinkled film.
namespace taut::material
{
/// Where the film is taut, if it is within the limits of its springs: there S
/// of the metric C itself (Pa) bears its wrinkles, S + 2 delta G > 0.
template <class Number>
Mask<Number> is_taut(const SymmetricTensor2<Number>& S, const double stiffness)
{
  const Number zero(0.);
  const SymmetricTensor2<Number> T = {S.xx + stiffness, S.yy + stiffness, S.xy};
  return is_less(zero, T.xx) & is_less(zero, compute_determinant(T));
}

/// The wrinkles of a film with metric C and S = stress(elastomer, C, ...) (Pa);
/// none where it is taut. `stiffness` from get_wrinkle_stiffness. A film may be
/// pressed beyond the limits of its springs as long as it is within them when
/// wrinkled.
template <class Number>
[[gnu::flatten, gnu::noinline]] Wrinkles<Number>
find_wrinkles(const Elastomer& elastomer, const SymmetricTensor2<Number>& C,
              InternalVariables<Number> A, const Field& field,
              const SymmetricTensor2<Number>& S, const double stiffness)
{
  WrinkleSearch<Number> search(elastomer, C, A, field, stiffness);
  const Mask<Number> within = is_within_limits(elastomer, C, A, field);
  const Mask<Number> taut = is_taut(S, stiffness) & within;
  Wrinkles<Number> wrinkles = search.find_one_direction(S, !taut, within);
  // Both directions where tension is lost along the wrinkles as well, or
  // wrinkles across one direction alone have no end.
  const Mask<Number> slackens =
      is_less(wrinkles.tension, Number(0.)) | (!wrinkles.admissible);
  const Mask<Number> in_both = slackens & (!taut);
  if (any(in_both))
    search.find_both_directions(in_both, wrinkles);
  wrinkles.metric = choose(taut, C, wrinkles.metric);
  wrinkles.amplitude = select(taut, Number(0.), wrinkles.amplitude);
  wrinkles.wrinkled = !(taut | wrinkles.slack);
  wrinkles.admissible = taut | wrinkles.admissible;
  wrinkles.stiffness = stiffness;
  return wrinkles;
}

/// E = C* - C.
template <class Number>
SymmetricTensor2<Number>
compute_wrinkle_strain(const Wrinkles<Number>& wrinkles,
                       const SymmetricTensor2<Number>& C)
{
  return add_scaled(wrinkles.metric, Number(-1.), C);
}

/// S* of the film with its wrinkles in Pa, S that without them. The conditions
/// on wrinkles leave only the tension along them: T = S* + 2 delta G (1 + E) is
/// tension (C^-1 u) (C^-1 u)^T with u along them, or 0 where the film is slack.
template <class Number>
SymmetricTensor2<Number>
compute_wrinkled_stress(const Wrinkles<Number>& wrinkles,
                        const SymmetricTensor2<Number>& C,
                        const SymmetricTensor2<Number>& S)
{
  const Line<Number>& u = wrinkles.directions.along;
  const SymmetricTensor2<Number> inverse = compute_inverse(C);
  const Number x = inverse.xx * u.x + inverse.xy * u.y;
  const Number y = inverse.xy * u.x + inverse.yy * u.y;
  const Number pull = select(wrinkles.slack, Number(0.), wrinkles.tension);
  const SymmetricTensor2<Number> T = {pull * x * x, pull * y * y, pull * x * y};
  const SymmetricTensor2<Number> cost = compute_wrinkle_tension(
      wrinkles.metric, C, {Number(0.), Number(0.), Number(0.)},
      wrinkles.stiffness);
  return choose(wrinkles.wrinkled | wrinkles.slack,
                add_scaled(T, Number(-1.), cost), S);
}

/// delta G (tr E + E : E/2) in J/m^3, the energy that W_r has beside W(C*).
template <class Number>
Number compute_wrinkle_energy(const Wrinkles<Number>& wrinkles,
                              const SymmetricTensor2<Number>& C)
{
  const SymmetricTensor2<Number> E = compute_wrinkle_strain(wrinkles, C);
  return (0.5 * wrinkles.stiffness) * (E.xx + E.yy + 0.5 * contract(E, E));
}

/// How the wrinkles follow: when the stress S* at fixed E changes by dS, the
/// half of dE is, in engineering components, -N dS with
///   wrinkled: N = B M^-1 R, the two conditions on w differentiated,
///   slack: N = (D + L)^-1, L = 2 delta G diag(2, 2, 1), taut: N = 0.
/// S and D belong to C*; D may have condensed networks.
template <class Number>
[[gnu::flatten, gnu::noinline]] Matrix3<Number> make_wrinkle_response(
    const Wrinkles<Number>& wrinkles, const SymmetricTensor2<Number>& C,
    const SymmetricTensor2<Number>& S, const Matrix3<Number>& D)
{
  const Number zero(0.);
  const WrinkleEquations<Number> M(
      wrinkles.directions, wrinkles.amplitude,
      compute_wrinkle_tension(wrinkles.metric, C, S, wrinkles.stiffness), D,
      wrinkles.stiffness);
  Matrix3<Number> N = M.make_response();
  const Matrix3<Number> slack =
      any(wrinkles.slack)
          ? compute_inverse(add_wrinkle_stiffness(D, wrinkles.stiffness))
          : D;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      N[i][j] = select(wrinkles.slack, slack[i][j],
                       select(wrinkles.wrinkled, N[i][j], zero));
  return N;
}

/// -N dS: what the wrinkles add to the engineering strain.
template <class Number>
SymmetricTensor2<Number>
compute_wrinkle_change(const Matrix3<Number>& N,
                       const SymmetricTensor2<Number>& dS)
{
  const SymmetricTensor2<Number> change = multiply(N, dS);
  return {-change.xx, -change.yy, -change.xy};
}

/// D - D N D: the stiffness with wrinkles that follow.
template <class Number>
Matrix3<Number> condense_wrinkles(const Matrix3<Number>& N,
                                  const Matrix3<Number>& D)
{
  Matrix3<Number> result = D;
  for (unsigned int j = 0; j < 3; ++j)
  {
    const SymmetricTensor2<Number> e =
        compute_wrinkle_change(N, {D[0][j], D[1][j], D[2][j]});
    const SymmetricTensor2<Number> change = multiply(D, e);
    result[0][j] = D[0][j] + change.xx;
    result[1][j] = D[1][j] + change.yy;
    result[2][j] = D[2][j] + change.xy;
  }
  return result;
}
} // namespace taut::material
