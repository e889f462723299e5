#pragma once

#include <taut/time/continuation.h>
#include <taut/time/null_vector.h>

#include <optional>

#include "continuation_bordered.h"

namespace taut::time
{
/// An equilibrium on a path.
struct PathState
{
  PathVector x;
  PathVector tangent; ///< of length 1, in the direction of travel
  std::optional<int> negative_eigenvalues;
  double arc_length = 0;
};

/// Finds equilibria on planes, and their tangents.
class PathSolver
{
public:
  PathSolver(EquilibriumProblem& problem, double start, double end,
             const EquilibriumOptions& options);

  const Communicator& communicator() const
  {
    return communicator_;
  }
  double dot(const PathVector& a, const PathVector& b) const
  {
    return time::dot(a, b, metric_, communicator_);
  }
  double norm(const PathVector& a) const;
  /// a over its length; errors: StepRejected if it has none.
  PathVector make_unit(const PathVector& a) const;
  double distance(const PathState& a, const PathState& b) const;
  const PathMetric& metric() const
  {
    return metric_;
  }
  PathMetric& metric()
  {
    return metric_;
  }

  /// The equilibrium on a plane, from `guess`, with its tangent, which points
  /// along `forward`. Errors: StepRejected.
  PathState find(const PathPlane& plane, const PathVector& guess,
                 const PathVector& forward);
  /// The equilibrium at a parameter.
  PathState find_at(double parameter, const PathVector& guess,
                    const PathVector& forward);
  /// Between two neighbours, at the distance from `a` along its tangent.
  PathState find_between(const PathState& a, const PathState& b,
                         double distance);
  /// Where the parameter between two neighbours is the given one.
  /// Errors: StepRejected if that equilibrium lies elsewhere.
  PathState find_crossing(const PathState& a, const PathState& b,
                          double parameter);

  /// At the state found last.
  EigenPair find_nearest_eigenvalue(const std::vector<double>& guess);
  /// How much of the load that the parameter brings works on `mode`, 0 to 1.
  double compute_load_share(const PathVector& x,
                            const std::vector<double>& mode);
  /// The change of the displacements with the parameter across `mode`, where
  /// the tangent is singular but for it; at the state `x`.
  PathVector find_direction_across(const PathVector& x,
                                   const std::vector<double>& mode);

  ContinuationStatistics statistics;

private:
  void find_tangent(PathState& state, const PathVector& forward);

  EquilibriumProblem& problem_;
  const EquilibriumOptions options_;
  const Communicator communicator_;
  BorderedProblem bordered_;
  PathMetric metric_;
};

/// The point at the share `way` between two neighbours, of the third order.
PathVector interpolate(const PathState& a, const PathState& b, double way,
                       double distance);
} // namespace taut::time
