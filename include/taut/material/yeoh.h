#pragma once

#include <taut/material/isotropic.h>

namespace taut::material
{
/// W = c1 x + c2 x^2 + c3 x^3, x = I1 - 3.
struct Yeoh
{
  double first_coefficient;  ///< c1 in Pa
  double second_coefficient; ///< c2 in Pa
  double third_coefficient;  ///< c3 in Pa
};

inline double shear_modulus(const Yeoh& spring)
{
  return 2. * spring.first_coefficient;
}

inline Yeoh scale_moduli(const Yeoh& spring, double factor)
{
  return {factor * spring.first_coefficient, factor * spring.second_coefficient,
          factor * spring.third_coefficient};
}

template <class Number>
Number compute_energy(const Yeoh& spring, const Invariants<Number>& invariants)
{
  const Number x = invariants.first() - 3.;
  return x * (spring.first_coefficient +
              x * (spring.second_coefficient + x * spring.third_coefficient));
}

template <class Number>
FirstInvariantDerivatives<Number>
compute_derivatives(const Yeoh& spring, const Invariants<Number>& invariants)
{
  const Number x = invariants.first() - 3.;
  return {spring.first_coefficient + x * (2. * spring.second_coefficient +
                                          (3. * spring.third_coefficient) * x),
          2. * spring.second_coefficient + (6. * spring.third_coefficient) * x};
}
} // namespace taut::material
