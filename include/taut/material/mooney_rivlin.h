#pragma once

#include <taut/material/isotropic.h>

namespace taut::material
{
/// W = c1 (I1 - 3) + c2 (I2 - 3).
struct MooneyRivlin
{
  double first_coefficient;  ///< c1 in Pa
  double second_coefficient; ///< c2 in Pa
};

inline double shear_modulus(const MooneyRivlin& spring)
{
  return 2. * (spring.first_coefficient + spring.second_coefficient);
}

inline MooneyRivlin scale_moduli(const MooneyRivlin& spring, double factor)
{
  return {factor * spring.first_coefficient,
          factor * spring.second_coefficient};
}

template <class Number>
Number compute_energy(const MooneyRivlin& spring,
                      const Invariants<Number>& invariants)
{
  return spring.first_coefficient * (invariants.first() - 3.) +
         spring.second_coefficient * (invariants.second() - 3.);
}

template <class Number>
InvariantDerivatives<Number> compute_derivatives(const MooneyRivlin& spring,
                                                 const Invariants<Number>&)
{
  return {Number(spring.first_coefficient), Number(spring.second_coefficient),
          Number(0.), Number(0.), Number(0.)};
}
} // namespace taut::material
