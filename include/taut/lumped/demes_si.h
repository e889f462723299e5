#pragma once

#include <taut/lumped/demes.h>
#include <taut/lumped/temperature_factor.h>

namespace taut::lumped
{
/// A DEMES as it is built, in SI units.
struct DemesSI
{
  /// Undeformed film L_0 x W_0 x t_0 (m).
  double film_length = 0;
  double film_width = 0;
  double film_thickness = 0;
  /// lambda_p; the frame is as long as the stretched film, C = lambda_p L_0.
  double pre_stretch = 2;
  /// mu of the elastic spring at the reference temperature (Pa).
  double shear_modulus = 0;
  /// beta.
  double viscous_ratio = 2.5;
  /// eta of the dashpot at the reference temperature (Pa s).
  double viscosity = 0;
  /// Young's modulus Y_f at the reference temperature (Pa), total width of the
  /// legs and thickness d of the frame (m): EI = Y_f w d^3 / 12.
  double frame_modulus = 0;
  double frame_width = 0;
  double frame_thickness = 0;
  /// I, twice the rotary inertia of each end (kg m^2).
  double inertia = 0;
  /// h, from the frame's neutral line to the film on the hollow side (m).
  double film_offset = 0;
  /// theta_0 (rad).
  double rest_angle = 0;
  /// eps_r of the unstretched film at the reference temperature.
  double relative_permittivity = 0;
  PermittivityLaw permittivity = wang_permittivity;
  DemesTemperatureLaws laws;
  /// T (K); the laws need it.
  double temperature = 299;
  DemesControl control = DemesControl::voltage;
  /// Between the electrodes (V), or on them (C), in time (s).
  Signal source;
};

/// The SI value of one dimensionless unit.
struct DemesScales
{
  /// Of tau (s).
  double time = 0;
  /// Of frequencies (rad/s).
  double angular_frequency = 0;
  double voltage = 0;
  double charge = 0;
  /// mu_0 V_0, also of torques (J, N m).
  double energy = 0;
  /// Force along the film (N).
  double force = 0;
};

/// Errors: BadInput that names the first impossible value.
Demes make_demes(const DemesSI& device);
DemesScales make_scales(const DemesSI& device);
} // namespace taut::lumped
