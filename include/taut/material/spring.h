#pragma once

#include <taut/material/arruda_boyce.h>
#include <taut/material/gent.h>
#include <taut/material/mooney_rivlin.h>
#include <taut/material/neo_hookean.h>
#include <taut/material/yeoh.h>

#include <limits>
#include <variant>

namespace taut::material
{
using Spring = std::variant<NeoHookean, MooneyRivlin, Gent, Yeoh, ArrudaBoyce>;

/// The shear modulus at small strain in Pa.
inline double shear_modulus(const Spring& spring)
{
  return std::visit([](const auto& law) { return shear_modulus(law); }, spring);
}

/// The spring with all its moduli, hence its energy, multiplied by a factor.
inline Spring scale_moduli(const Spring& spring, double factor)
{
  return std::visit([factor](const auto& law) -> Spring
                    { return scale_moduli(law, factor); },
                    spring);
}

/// Springs that extend without limit.
template <class Law>
double first_invariant_limit(const Law&)
{
  return std::numeric_limits<double>::infinity();
}

/// The first invariant that the spring never reaches; infinity if none.
inline double first_invariant_limit(const Spring& spring)
{
  return std::visit([](const auto& law) { return first_invariant_limit(law); },
                    spring);
}

/// Energy per undeformed volume in J/m^3, zero without strain.
template <class Number>
Number compute_energy(const Spring& spring,
                      const Invariants<Number>& invariants)
{
  return std::visit(
      [&](const auto& law) { return compute_energy(law, invariants); }, spring);
}

/// Derivatives of the energy by t and ln d in Pa.
template <class Number>
EnergyDerivatives<Number>
compute_energy_derivatives(const Spring& spring,
                           const Invariants<Number>& invariants)
{
  return std::visit(
      [&](const auto& law)
      {
        return compute_energy_derivatives(compute_derivatives(law, invariants),
                                          invariants);
      },
      spring);
}
} // namespace taut::material
