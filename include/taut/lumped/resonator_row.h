#pragma once

#include <taut/lumped/frozen_resonator.h>

#include <vector>

namespace taut::lumped
{
/// The resonator at one time, dimensionless as in `Resonator`.
struct ResonatorRow
{
  /// s.
  double time = 0;
  /// V*.
  double voltage = 0;
  double stretch_1a = 0;
  double stretch_1b = 0;
  /// Static nominal stresses; s_1A = s_1B in a quasi-static run.
  double stress_1a = 0;
  double stress_1b = 0;
  double stress_2a = 0;
  double stress_2b = 0;
  /// d - V* lambda_1A lambda_2.
  double breakdown_margin = 0;
  /// Omega_n = omega_n / sqrt(alpha) of (3.28); 0 where the balance is
  /// unstable.
  double frequency = 0;
  /// V* lambda_1A^2 lambda_2^2.
  double charge = 0;
  /// d lambda_1A / dt (1/s) and the forces P_1 on the bar,
  /// s_1 + (rho L_1^2 / 3 G) d^2 lambda_1 / dt^2 (3.7, 3.12).
  double velocity = 0;
  double force_1a = 0;
  double force_1b = 0;
  /// Of both strips and the bar, over G and the undeformed volume of A. The
  /// free energy is Legendre-transformed: kinetic + free + dissipated + work is
  /// constant, with work = integral of charge dV*. The last two are tracked in
  /// inertial runs only.
  double kinetic_energy = 0;
  double free_energy = 0;
  double dissipated_energy = 0;
  double voltage_work = 0;
  /// lambda^i, four per network: 1A, 2A, 1B, 2B.
  std::vector<double> internal;
};

/// The row of a resonator at rest; `frozen` holds `internal`.
ResonatorRow make_row(const FrozenResonator& frozen, double time,
                      double voltage, double stretch_1a,
                      const double* internal);
} // namespace taut::lumped
