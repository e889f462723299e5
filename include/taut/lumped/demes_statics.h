#pragma once

#include <taut/lumped/demes.h>

#include <vector>

namespace taut::lumped
{
/// A relaxed state (xi = lambda) at rest.
struct DemesEquilibrium
{
  /// theta (rad).
  double angle = 0;
  double stretch = 0;
  double membrane_force = 0;
  /// Frame, film and electric energy.
  double energy = 0;
  DemesFrequencies frequencies;
  /// Whether small disturbances die out: relaxed_squared > 0.
  bool stable = false;
};

/// All relaxed equilibria at a drive e, by increasing angle. With a straight
/// frame and no eccentricity the straight state is one of them, exactly, and
/// the others come in pairs of opposite angles.
/// Errors: BadInput for impossible parameters.
std::vector<DemesEquilibrium> find_equilibria(const Demes& demes, double drive);

/// Pre-stretch at which the straight state loses its stability without drive,
/// for a straight frame without eccentricity:
///   lambda_p^2 = (3 K / m + sqrt(9 K^2 / m^2 + 4)) / 2.
/// Errors: BadInput for other frames, which have no straight state.
double compute_critical_pre_stretch(const Demes& demes);

/// Drive e above which the straight state is stable, 0 if it is so already
/// without: the electric force that leaves lambda_p s = 3 K.
/// Errors as compute_critical_pre_stretch.
double compute_flattening_drive(const Demes& demes);

/// Rate at which a small angle grows out of the straight state at a drive e, 0
/// if that is stable: sigma^2 = lambda_p s / 3 - K. The dashpot has no part in
/// it, because the stretch changes with the square of the angle.
/// Errors as compute_critical_pre_stretch.
double compute_growth_rate(const Demes& demes, double drive);
} // namespace taut::lumped
