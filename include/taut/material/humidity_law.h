#pragma once

#include <taut/material/scalar_law.h>

#include <variant>

// How a property depends on the relative humidity h of the air, 0 to 1, with
// which a thin film is in equilibrium.
namespace taut::material
{
/// f = exp(k (h - h_0)): water that softens the polymer and frees its chains.
struct ExponentialLaw
{
  double reference;   ///< h_0
  double coefficient; ///< k
};

using HumidityLaw =
    std::variant<ConstantLaw, PolynomialLaw, TableLaw, ExponentialLaw>;

/// The factor at h. Errors: StepRejected outside 0 to 1 or the law's range,
/// with the range.
double compute_factor(const HumidityLaw& law, double humidity);

/// Its derivative by h.
double compute_factor_derivative(const HumidityLaw& law, double humidity);

/// Within 0 to 1.
LawRange get_range(const HumidityLaw& law);

/// How the film's properties follow the humidity.
struct HumidityLaws
{
  HumidityLaw modulus;         ///< of every shear modulus
  HumidityLaw relaxation_time; ///< of every relaxation time
  HumidityLaw permittivity;    ///< of the relative permittivity
};
} // namespace taut::material
