#pragma once

#include <taut/material/isotropic.h>

namespace taut::material
{
/// W = G/2 (I1 - 3).
struct NeoHookean
{
  double shear_modulus; ///< G in Pa
};

inline double shear_modulus(const NeoHookean& spring)
{
  return spring.shear_modulus;
}

inline NeoHookean scale_moduli(const NeoHookean& spring, double factor)
{
  return {factor * spring.shear_modulus};
}

template <class Number>
Number compute_energy(const NeoHookean& spring,
                      const Invariants<Number>& invariants)
{
  return 0.5 * spring.shear_modulus * (invariants.first() - 3.);
}

template <class Number>
FirstInvariantDerivatives<Number> compute_derivatives(const NeoHookean& spring,
                                                      const Invariants<Number>&)
{
  return {Number(0.5 * spring.shear_modulus), Number(0.)};
}
} // namespace taut::material
