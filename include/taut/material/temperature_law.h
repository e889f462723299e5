#pragma once

#include <string>
#include <variant>
#include <vector>

// How a property depends on the temperature T (K): every law gives the factor
// on the value at its reference temperature.
namespace taut::material
{
/// f = 1.
struct ConstantLaw
{
};

/// f = 1 + c_1 (T - T_0) + c_2 (T - T_0)^2 + ...
struct PolynomialLaw
{
  double reference;                 ///< T_0 (K)
  std::vector<double> coefficients; ///< c_i (1/K^i)
  double lowest;                    ///< range of T in which the law holds (K)
  double highest;
};

/// Linear between rows.
struct TableLaw
{
  std::vector<double> temperatures; ///< (K), increasing
  std::vector<double> factors;
};

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

/// Range of T (K) in which the law holds; infinite where it has no bounds.
struct TemperatureRange
{
  double lowest, highest;
};
TemperatureRange get_range(const TemperatureLaw& law);

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
