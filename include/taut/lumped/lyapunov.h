#pragma once

#include <functional>
#include <vector>

namespace taut::lumped
{
/// Takes a state from one time to another.
using Flow = std::function<std::vector<double>(const std::vector<double>& state,
                                               double begin, double end)>;

struct LyapunovOptions
{
  double begin = 0;
  double end = 0;
  /// Number of equal intervals after each of which the neighbour is brought
  /// back to its distance.
  unsigned int intervals = 400;
  /// Sizes by which the components of the state are measured; empty: 1.
  std::vector<double> scales;
  /// Distance of the neighbour: small against the motion, large against what
  /// the flow's own error leaves.
  double distance = 1e-7;
};

struct LyapunovExponent
{
  /// Per unit of time; positive: neighbours separate.
  double value = 0;
  /// Standard error of the mean over ten parts of the time.
  double uncertainty = 0;
};

/// The largest Lyapunov exponent of the motion through `state` at `begin`, by
/// two trajectories (Benettin, Galgani, Giorgilli and Strelcyn, Meccanica 15
/// (1980)): the mean of ln(d_k / d_0) / h over intervals h, after each of which
/// a neighbour at the distance d_k is moved back to d_0. The first fifth of the
/// intervals does not count: in it the neighbour turns into the direction that
/// grows most.
/// Errors: BadInput for an empty time or fewer than 20 intervals, SolverFailed
/// if the flow moves both to the same state; those of the flow.
LyapunovExponent compute_lyapunov(const Flow& flow,
                                  const std::vector<double>& state,
                                  const LyapunovOptions& options);
} // namespace taut::lumped
