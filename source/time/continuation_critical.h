#pragma once

#include "continuation_solver.h"

namespace taut::time
{
/// Where a path turns back in its parameter or crosses another branch.
struct CriticalPoint
{
  PathState state;
  /// Null vector of the tangent (this rank's part).
  std::vector<double> mode;
  /// The parameter turns back.
  bool turns = false;
  /// No other branch begins.
  bool is_limit = false;
};

/// The critical point between two neighbours, `step` apart along the tangent
/// of the first, if there is one. Errors: StepRejected if there are several.
std::optional<CriticalPoint> find_critical_point(PathSolver& solver,
                                                 const PathState& last,
                                                 const PathState& next,
                                                 double step);

/// A point on the other branch, `step` away from where it begins: that on the
/// side of `direction` or, if only that is stable, the opposite one. If the
/// path turns back, the branch on which the parameter goes on; nothing if that
/// is unstable. Errors: StepRejected.
std::optional<PathState>
find_other_branch(PathSolver& solver, const CriticalPoint& point,
                  const PathState& last, double step,
                  const std::vector<double>& direction);
} // namespace taut::time
