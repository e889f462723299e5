#pragma once

#include <taut/structure/systems.h>

#include <array>
#include <optional>

namespace taut::structure
{
/// The way from a flat frame to the stable shape into which the film bends it.
///
/// The flat state is an equilibrium, too, and an unstable one. So the frames
/// start `first_stiffness` times stiffer, where the flat state is stable, and
/// soften to their own stiffness under a dead load along them, which decides to
/// which side they bend and which is taken away again in the second half of the
/// path. The end of the path is an equilibrium of the device as it is.
struct RestPathOptions
{
  /// Of the load (any length > 0); the opposite gives the other branch.
  std::array<double, 3> direction{{0, 0, 1}};
  /// Load at most: 8 EI/L^3 times this, with the stiffened EI and the extent L
  /// of the device. By beam theory a load of 1 bends a cantilever of length L
  /// by L, one of half the length by L/16.
  double perturbation = 2;
  /// More where that leaves the flat state unstable.
  double first_stiffness = 10;
  /// Steps of the path, at least.
  unsigned int steps = 6;
  time::EquilibriumOptions newton;
};

struct RestShape
{
  time::EquilibriumStatistics statistics;
  /// Negative eigenvalues of the tangent: 0 if the shape is stable.
  int negative_eigenvalues = 0;
  /// The same of the flat state, without the load; nothing if the device has no
  /// equilibrium near it.
  std::optional<int> flat_negative_eigenvalues;
};

/// Moves `u`, which is zero or near the flat state, to the rest shape at the
/// loads of `time`. Errors: as time::follow_path; BadInput for a device without
/// frames.
RestShape find_rest_shape(Structure& structure, LoadHistory& history,
                          Networks networks, const double* internal,
                          double time, const RestPathOptions& options,
                          double* u);
} // namespace taut::structure
