#pragma once

#include <taut/lumped/resonator.h>

namespace taut::lumped
{
/// Vacuum permittivity (F/m).
constexpr double vacuum_permittivity = 8.8541878128e-12;

/// The membrane resonator as it is built, in SI units.
struct ResonatorSI
{
  /// Undeformed lengths of the strips along x_1 (m).
  double length_a = 0;
  double length_b = 0;
  /// Undeformed width L_2 and thickness L_3 of both (m).
  double width = 0;
  double thickness = 0;
  /// Shear modulus of the ground network (Pa).
  double equilibrium_modulus = 0;
  /// Shear moduli (Pa) of the viscous networks and their tau (s, or 1/s if
  /// `tau_meaning` says so).
  std::vector<double> network_moduli;
  std::vector<double> network_taus;
  TauMeaning tau_meaning = TauMeaning::relaxation_time;
  /// J_lim.
  double gent_limit = 67;
  /// kg/m^3.
  double density = 0;
  /// Total mass of the bar between the strips (kg).
  double bar_mass = 0;
  double relative_permittivity = 0;
  /// True field at breakdown (V/m).
  double breakdown_field = 0;
  double pre_stretch_1 = 2;
  double pre_stretch_2 = 4;
  /// Between the electrodes of A (V).
  Signal voltage;
};

/// The SI value of one dimensionless unit.
struct ResonatorScales
{
  /// G, for stresses (Pa).
  double stress = 0;
  /// Of V* (V).
  double voltage = 0;
  /// G L_2 L_3, for the force along x_1 in either strip (N).
  double force_1 = 0;
  /// G L_1A L_3 and G L_1B L_3, for the forces along x_2 (N).
  double force_2a = 0;
  double force_2b = 0;
  /// sqrt(permittivity G) L_1A L_2, for the charge on A (C).
  double charge = 0;
  /// G L_1A L_2 L_3 (J).
  double energy = 0;
  /// sqrt(alpha), for Omega (rad/s).
  double angular_frequency = 0;
};

/// Errors: BadInput that names the first impossible value.
Resonator make_resonator(const ResonatorSI& device);
ResonatorScales make_scales(const ResonatorSI& device);
} // namespace taut::lumped
