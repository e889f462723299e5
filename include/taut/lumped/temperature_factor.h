#pragma once

#include <string>
#include <variant>
#include <vector>

/// How the properties of a lumped model depend on the temperature T (K): a law
/// gives the factor on the value at its reference temperature.
namespace taut::lumped
{
struct ConstantFactor
{
};

/// 1 + c_1 (T - T_0) + c_2 (T - T_0)^2 + ...
struct PolynomialFactor
{
  /// T_0 (K).
  double reference = 299;
  /// c_i (1/K^i).
  std::vector<double> coefficients;
  /// Range in which it holds (K).
  double lowest = 0;
  double highest = 0;
};

/// exp(E_a / R (1 / T - 1 / T_0)), thermally activated flow.
struct ArrheniusFactor
{
  double reference = 299;
  /// E_a (J/mol).
  double activation_energy = 0;
};

/// (a + b / T) / (a + b / T_0), dipoles that heat disorders.
struct DipoleFactor
{
  double reference = 299;
  double a = 0;
  /// K.
  double b = 0;
};

using TemperatureFactor = std::variant<ConstantFactor, PolynomialFactor,
                                       ArrheniusFactor, DipoleFactor>;

/// Errors: BadInput outside the range of the law, with the range, and for a
/// temperature that is not positive.
double compute_factor(const TemperatureFactor& law, double temperature);

/// What heat changes in a DEMES.
struct DemesTemperatureLaws
{
  TemperatureFactor frame_modulus;
  TemperatureFactor shear_modulus;
  TemperatureFactor relaxation_time;
  TemperatureFactor permittivity;
  /// Where they come from.
  std::string source;
};

/// Laws by name, all with the permittivity of Wang et al. (2024), 2.1 + 960/T,
/// and the reference temperature 299 K:
///   constant   nothing else changes;
///   softening  frame -0.6 %/K, film -0.5 %/K, relaxation time by 30 kJ/mol:
///              our choice, for which the rest angle grows and the resonance
///              falls with heat as Wang et al. report, who print no laws;
///   entropic   the film's modulus proportional to T as of an ideal rubber,
///              the rest as in softening.
/// Errors: BadInput for another name, with those known.
DemesTemperatureLaws make_temperature_laws(const std::string& name);
} // namespace taut::lumped
