#include <taut/lumped/demes.h>

#include <cmath>

#include "demes_formulas.h"
#include "require.h"

namespace taut::lumped
{
namespace
{
const double pi = std::acos(-1.);
} // namespace

void validate(const Demes& demes)
{
  require_positive(demes.pre_stretch, "pre-stretch lambda_p");
  require_positive(demes.frame_stiffness, "stiffness K of the frame");
  require_positive(demes.relaxation, "relaxation number S");
  require_positive(demes.modulus_factor, "factor m of the shear modulus");
  require_positive(demes.permittivity_factor, "factor g of the permittivity");
  require(demes.viscous_ratio >= 0, demes.viscous_ratio,
          "ratio beta of the springs", "zero or positive");
  require(true, demes.eccentricity, "eccentricity 2 h / C", "finite");
  require(std::abs(demes.rest_angle) < 3, demes.rest_angle,
          "rest angle theta_0 of the frame", "within -3 and 3 rad");
  require_positive(demes.drive_unit, "unit of the drive");
  require_positive(demes.time_unit, "unit of time");
}

ChordShape compute_chord(const double angle, const double eccentricity)
{
  ChordShape chord;
  double straight;
  if (std::abs(angle) <= pi)
  {
    using Single = std::array<double, 1>;
    constexpr auto series = formulas::make_series(2);
    Single value, slope;
    formulas::compute_chords(Single{angle}, eccentricity, value, slope);
    chord.value = value[0];
    chord.slope = slope[0];
    straight = formulas::sum_series<1>(series, Single{angle * angle})[0];
  }
  else
  {
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const double value = sine / angle, slope = (cosine - value) / angle;
    chord.value = value - eccentricity * sine;
    chord.slope = slope - eccentricity * cosine;
    straight = -value - 2 * slope / angle;
  }
  chord.curvature = straight + eccentricity * std::sin(angle);
  return chord;
}

ElectricState compute_electric(const Demes& demes, const double stretch,
                               const double drive)
{
  const PermittivityLaw& phi = demes.permittivity;
  const double c = formulas::compute_capacitance(demes, stretch);
  const double c_1 = formulas::compute_capacitance_slope(demes, stretch);
  const double c_2 =
      demes.permittivity_factor *
      (2 * phi.value(stretch) + 4 * phi.derivative(stretch) * stretch +
       phi.second_derivative(stretch) * stretch * stretch);
  const double force = formulas::compute_electric_force(demes, stretch, drive);
  const double square = drive * drive;
  if (demes.control == DemesControl::voltage)
    return {-square / 2 * c, force, -square / 2 * c_2, drive * c};
  const double stiffness = square / (c * c) * (c_1 * c_1 / c - c_2 / 2);
  return {square / (2 * c), force, stiffness, drive / c};
}

double compute_membrane_force(const Demes& demes, const double stretch,
                              const double inner_stretch, const double drive)
{
  return formulas::compute_force(demes, stretch, inner_stretch * inner_stretch,
                                 drive);
}

double compute_acceleration(const Demes& demes, const double angle,
                            const double inner_stretch, const double drive)
{
  const ChordShape chord = compute_chord(angle, demes.eccentricity);
  const double force = compute_membrane_force(
      demes, demes.pre_stretch * chord.value, inner_stretch, drive);
  return -demes.frame_stiffness * (angle - demes.rest_angle) -
         demes.pre_stretch * chord.slope * force;
}

double compute_inner_rate(const Demes& demes, const double stretch,
                          const double inner_stretch)
{
  const double square = stretch * stretch;
  const double cube = inner_stretch * inner_stretch * inner_stretch;
  return demes.viscous_ratio / demes.relaxation *
         (square / cube - inner_stretch / square);
}

double compute_free_energy(const Demes& demes, const double angle,
                           const double inner_stretch, const double drive)
{
  const double stretch =
      demes.pre_stretch * compute_chord(angle, demes.eccentricity).value;
  const double bent = angle - demes.rest_angle;
  // x^2 + x^-2 - 2 = (x - 1/x)^2 of the whole and of the elastic stretch.
  const double whole = stretch - 1 / stretch;
  const double elastic = stretch / inner_stretch - inner_stretch / stretch;
  return demes.frame_stiffness * bent * bent / 2 +
         demes.modulus_factor / 2 *
             (whole * whole + demes.viscous_ratio * elastic * elastic) +
         compute_electric(demes, stretch, drive).energy;
}

double compute_dissipation(const Demes& demes, const double stretch,
                           const double inner_stretch)
{
  const double rate = compute_inner_rate(demes, stretch, inner_stretch);
  return demes.modulus_factor * demes.relaxation * rate * rate;
}

DemesFrequencies compute_frequencies(const Demes& demes, const double angle,
                                     const double drive)
{
  const ChordShape chord = compute_chord(angle, demes.eccentricity);
  const double stretch = demes.pre_stretch * chord.value;
  const double slope = demes.pre_stretch * chord.slope;
  const double square = stretch * stretch;
  const double force = compute_membrane_force(demes, stretch, stretch, drive);
  const double stiffness = demes.modulus_factor * (1 + 3 / (square * square)) +
                           compute_electric(demes, stretch, drive).stiffness;
  const double relaxed = demes.frame_stiffness + stiffness * slope * slope +
                         force * demes.pre_stretch * chord.curvature;
  return {relaxed, relaxed + demes.modulus_factor * 4 * demes.viscous_ratio /
                                 square * slope * slope};
}
} // namespace taut::lumped
