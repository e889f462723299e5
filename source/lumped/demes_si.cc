#include <taut/lumped/demes_si.h>
#include <taut/lumped/resonator_si.h>

#include <cmath>

#include "require.h"

namespace taut::lumped
{
namespace
{
void validate(const DemesSI& device)
{
  require_positive(device.film_length, "length of the film");
  require_positive(device.film_width, "width of the film");
  require_positive(device.film_thickness, "thickness of the film");
  require_positive(device.pre_stretch, "pre-stretch lambda_p");
  require_positive(device.shear_modulus, "shear modulus");
  require_positive(device.viscosity, "viscosity");
  require_positive(device.frame_modulus, "modulus of the frame");
  require_positive(device.frame_width, "width of the frame's legs");
  require_positive(device.frame_thickness, "thickness of the frame");
  require_positive(device.inertia, "inertia of the ends");
  require(device.relative_permittivity >= 1, device.relative_permittivity,
          "relative permittivity", "at least 1");
  // Farther out the ends of the film lie outside of the frame's.
  require(std::abs(device.film_offset) <=
              device.pre_stretch * device.film_length,
          device.film_offset, "distance of the film from the frame",
          "no larger than the frame is long");
}
} // namespace

DemesScales make_scales(const DemesSI& device)
{
  validate(device);
  const double area = device.film_length * device.film_width;
  const double permittivity =
      device.relative_permittivity * vacuum_permittivity;
  DemesScales scales;
  scales.energy = device.shear_modulus * area * device.film_thickness;
  scales.angular_frequency = std::sqrt(scales.energy / device.inertia);
  scales.time = 1 / scales.angular_frequency;
  scales.voltage =
      device.film_thickness * std::sqrt(device.shear_modulus / permittivity);
  scales.charge = area * std::sqrt(device.shear_modulus * permittivity);
  scales.force = scales.energy / device.film_length;
  return scales;
}

Demes make_demes(const DemesSI& device)
{
  const DemesScales scales = make_scales(device);
  const double length = device.pre_stretch * device.film_length;
  const double bending_stiffness = device.frame_modulus * device.frame_width *
                                   std::pow(device.frame_thickness, 3) / 12;
  const double temperature = device.temperature;
  Demes demes;
  demes.pre_stretch = device.pre_stretch;
  demes.frame_stiffness =
      4 * bending_stiffness / (length * scales.energy) *
      compute_factor(device.laws.frame_modulus, temperature);
  demes.relaxation = scales.angular_frequency * device.viscosity /
                     device.shear_modulus *
                     compute_factor(device.laws.relaxation_time, temperature);
  demes.modulus_factor = compute_factor(device.laws.shear_modulus, temperature);
  demes.permittivity_factor =
      compute_factor(device.laws.permittivity, temperature);
  demes.viscous_ratio = device.viscous_ratio;
  demes.eccentricity = 2 * device.film_offset / length;
  demes.rest_angle = device.rest_angle;
  demes.permittivity = device.permittivity;
  demes.control = device.control;
  demes.drive = device.source;
  demes.drive_unit =
      device.control == DemesControl::voltage ? scales.voltage : scales.charge;
  demes.time_unit = scales.time;
  validate(demes);
  return demes;
}
} // namespace taut::lumped
