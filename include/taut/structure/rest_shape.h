#pragma once

#include <taut/structure/systems.h>

#include <array>

namespace taut::structure
{
/// The way from a flat frame to the stable shape into which the film bends it.
///
/// The flat state is an equilibrium, too, and an unstable one. So the frames
/// start `first_stiffness` times stiffer, where the flat state is stable, and
/// soften to their own stiffness (by equal factors in equal steps), while a
/// dead load along them, which fades out on the way and has vanished at the
/// end, decides to which side they bend. The end of the path is an equilibrium
/// of the device as it is.
struct RestPathOptions
{
  /// Of the load (any length > 0); the opposite gives the other branch.
  std::array<double, 3> direction{{0, 0, 1}};
  /// Load at the start: 8 EI/L^3 times this, which would bend a cantilever of
  /// the frames' length L by this share of it.
  double perturbation = 1e-2;
  double first_stiffness = 20;
  /// Steps of the path, at least.
  unsigned int steps = 8;
  time::EquilibriumOptions newton;
};

struct RestShape
{
  time::EquilibriumStatistics statistics;
  /// Negative eigenvalues of the tangent: 0 if the shape is stable.
  int negative_eigenvalues = 0;
  /// The same of the flat state, without the load.
  int flat_negative_eigenvalues = 0;
};

/// Moves `u`, which is zero or near the flat state, to the rest shape at the
/// loads of `time`. Errors: as time::follow_path; BadInput for a device without
/// frames.
RestShape find_rest_shape(Structure& structure, LoadHistory& history,
                          Networks networks, const double* internal,
                          double time, const RestPathOptions& options,
                          double* u);
} // namespace taut::structure
