#pragma once

#include <taut/material/scalar_law.h>

#include <variant>

// How a property depends on the temperature T (K).
namespace taut::material
{
/// f = exp(E_a/R (1/T - 1/T_0)): thermally activated flow.
struct ArrheniusLaw
{
  double reference;         ///< T_0 (K)
  double activation_energy; ///< E_a (J/mol)
};

using TemperatureLaw =
    std::variant<ConstantLaw, PolynomialLaw, TableLaw, ArrheniusLaw>;

/// The factor at T (K). Errors: StepRejected outside the law's range, with the
/// range.
double compute_factor(const TemperatureLaw& law, double temperature);

/// Its derivative by T (1/K).
double compute_factor_derivative(const TemperatureLaw& law, double temperature);

/// In K.
LawRange get_range(const TemperatureLaw& law);

/// How the film's properties follow the temperature.
struct ThermalLaws
{
  /// Of every shear modulus.
  TemperatureLaw modulus;
  /// Of every relaxation time (S = eta/mu).
  TemperatureLaw relaxation_time;
  /// c_0 (J/(kg K)) and T_0 (K) of the thermal energy
  /// rho c_0 ((T - T_0) - T ln(T/T_0)).
  double heat_capacity = 0;
  double reference = 293.15;
};
} // namespace taut::material
