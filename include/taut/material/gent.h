#pragma once

#include <taut/material/isotropic.h>

#include <cmath>

namespace taut::material
{
/// W = -(G J_lim/2) ln(1 - (I1 - 3)/J_lim); admissible below I1 = J_lim + 3.
struct Gent
{
  double shear_modulus; ///< G in Pa
  double limit;         ///< J_lim
};

inline double shear_modulus(const Gent& spring)
{
  return spring.shear_modulus;
}

inline Gent scale_moduli(const Gent& spring, double factor)
{
  return {factor * spring.shear_modulus, spring.limit};
}

/// The first invariant that the spring never reaches.
inline double first_invariant_limit(const Gent& spring)
{
  return spring.limit + 3.;
}

template <class Number>
Number compute_energy(const Gent& spring, const Invariants<Number>& invariants)
{
  using std::log;
  const Number left = 1. - (invariants.first() - 3.) / spring.limit;
  return -0.5 * spring.shear_modulus * spring.limit * log(left);
}

template <class Number>
FirstInvariantDerivatives<Number>
compute_derivatives(const Gent& spring, const Invariants<Number>& invariants)
{
  const Number inverse_distance =
      1. / ((spring.limit + 3.) - invariants.first());
  const Number by_1 =
      (0.5 * spring.shear_modulus * spring.limit) * inverse_distance;
  return {by_1, by_1 * inverse_distance};
}
} // namespace taut::material
