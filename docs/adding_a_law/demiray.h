#pragma once

#include <taut/material/isotropic.h>

#include <cmath>

namespace taut::material
{
/// W = G/(2 b) (exp(b (I1 - 3)) - 1), Demiray, J. Biomech. 5, 309 (1972).
struct Demiray
{
  double shear_modulus; ///< G in Pa
  double stiffening;    ///< b, dimensionless
};

inline double shear_modulus(const Demiray& spring)
{
  return spring.shear_modulus;
}

inline Demiray scale_moduli(const Demiray& spring, const double factor)
{
  return {factor * spring.shear_modulus, spring.stiffening};
}

/// Where the exponential would exceed 5e21.
inline double first_invariant_limit(const Demiray& spring)
{
  return 3. + 50. / spring.stiffening;
}

template <class Number>
Number compute_energy(const Demiray& spring,
                      const Invariants<Number>& invariants)
{
  using std::exp;
  const Number x = invariants.first() - 3.;
  return (spring.shear_modulus / (2. * spring.stiffening)) *
         (exp(spring.stiffening * x) - 1.);
}

template <class Number>
FirstInvariantDerivatives<Number>
compute_derivatives(const Demiray& spring, const Invariants<Number>& invariants)
{
  using std::exp;
  const Number slope = (.5 * spring.shear_modulus) *
                       exp(spring.stiffening * (invariants.first() - 3.));
  return {slope, spring.stiffening * slope};
}
} // namespace taut::material
