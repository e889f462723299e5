#pragma once

#include <taut/study/case.h>

namespace taut::testing
{
/// A lumped DEMES with K = 1, e(5 kV) = 0.3, S = 0.03; 5 Hz is omega = 1.
inline study::Case make_lumped_demes_case(const double pre_stretch)
{
  study::Case result;
  result.model = "demes";
  auto& device = result.lumped_demes;
  device.film_length = 0.02;
  device.film_width = 0.04;
  device.film_thickness = 5e-4;
  device.pre_stretch = pre_stretch;
  device.shear_modulus = 52246.6;
  device.viscosity = 49.9;
  device.frame_modulus = 2e9;
  device.frame_thickness = 5e-4;
  device.frame_width = 0.2508 * pre_stretch * device.film_length;
  device.inertia = 2.117476e-5;
  device.source = Signal::constant(5000);
  result.procedure.end_time = 1;
  result.output.history_intervals = 50;
  return result;
}

/// A lumped resonator whose networks relax within 10 ms and 1 s.
inline study::Case make_lumped_resonator_case()
{
  study::Case result;
  result.model = "resonator";
  auto& device = result.lumped_resonator;
  device.length_active = device.length_passive = device.width = 0.02;
  device.thickness = 1e-3;
  device.pre_stretch = {{2, 4}};
  device.bar_mass = 0.02;
  device.density = 960;
  device.shear_modulus = 40e3;
  device.equilibrium_share = 0.5;
  device.relaxation_times = {0.01, 1};
  device.breakdown_strength = 155e6;
  return result;
}
} // namespace taut::testing
