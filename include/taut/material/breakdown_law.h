#pragma once

#include <taut/material/humidity_law.h>
#include <taut/material/temperature_law.h>

#include <limits>
#include <variant>
#include <vector>

// The true field at which a film breaks down, E_B = E_0 f_1 f_2 ...: a strength
// and factors for what it depends on. Without factors it is constant.
namespace taut::material
{
/// Where a law holds, ends included.
struct ValidRange
{
  double lowest = 0;
  double highest = std::numeric_limits<double>::infinity();
};

/// lambda^r, lambda = sqrt(J) with the area stretch J. Huang et al. (Appl.
/// Phys. Lett. 101, 122905, 2012) found r = 0.63 for an acrylic film, together
/// with n = 0.25 of ThicknessStrength; Koh et al. (J. Polym. Sci. B 49, 504,
/// 2011) use such a power without the thickness.
struct StretchStrength
{
  double exponent;  ///< r
  ValidRange range; ///< of lambda
};

/// (h/h_0)^-n with the current thickness h = H/J.
struct ThicknessStrength
{
  double reference; ///< h_0 (m)
  double exponent;  ///< n
  ValidRange range; ///< of h (m)
};

/// The factor of a law of temperature.
struct TemperatureStrength
{
  TemperatureLaw law;
};

/// The factor of a law of humidity.
struct HumidityStrength
{
  HumidityLaw law;
};

/// (R/R_0)^m with the rate R of the nominal field V/H, kept within `bounds`: a
/// voltage that is held counts as one that rises at the lowest rate. Breakdown
/// voltages that grow with their rate: Huang et al., Appl. Phys. Lett. 100,
/// 041911, 2012.
struct RateStrength
{
  double reference;  ///< R_0 (V/(m s))
  double exponent;   ///< m
  ValidRange bounds; ///< of R (V/(m s)); lowest above 0
};

using StrengthFactor =
    std::variant<StretchStrength, ThicknessStrength, TemperatureStrength,
                 HumidityStrength, RateStrength>;

struct BreakdownLaw
{
  /// E_0 (V/m), the largest true field where all factors are 1; infinity if
  /// there is none.
  double reference = std::numeric_limits<double>::infinity();
  std::vector<StrengthFactor> factors = {};
};

/// What a strength may depend on at a point of a film.
struct BreakdownState
{
  double area_stretch; ///< J
  double thickness;    ///< current, H/J (m)
  double temperature;  ///< (K)
  double field_rate;   ///< |d(V/H)/dt| (V/(m s))
  double humidity;     ///< relative, 0 to 1
};

/// E_B in V/m. Errors: StepRejected outside the range of a law, with the value
/// and the range.
double compute_strength(const BreakdownLaw& law, const BreakdownState& state);
} // namespace taut::material
