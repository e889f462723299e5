#pragma once

#include <taut/time/equilibrium.h>

#include <functional>
#include <optional>
#include <vector>

namespace taut::time
{
/// A point of a path of equilibria that may turn back in its parameter.
struct CurvePoint
{
  enum class Kind
  {
    regular,       ///< an equilibrium on the way
    requested,     ///< where the parameter has one of the values asked for
    limit,         ///< the parameter turns back
    bifurcation,   ///< another branch begins
    branch_switch, ///< first point on another branch
    landing ///< stable again, at the parameter of the critical point that ended
            ///< the stable part before: where a device snaps to
  };
  Kind kind = Kind::regular;
  double parameter = 0;
  /// From the start, in units of the path (see ContinuationOptions).
  double arc_length = 0;
  /// Of the tangent, 0 if stable; at limit points and bifurcations those
  /// before them. Nothing if the problem cannot tell.
  std::optional<int> negative_eigenvalues;
  /// This rank's unknowns; valid during the call.
  const double* u = nullptr;
};

/// Lengths along the path are measured with displacements over the largest
/// ones so far, and the parameter over its range: a length of 1 is about all
/// that happens between start and end.
struct ContinuationOptions
{
  EquilibriumOptions newton;
  /// The first step moves the parameter by this part of its range.
  unsigned int steps = 20;
  double largest_step = 0.1;
  double smallest_step = 1e-6;
  unsigned int most_points = 1000;
  /// Norm of displacements (m) below which nothing has happened; positive.
  double noticeable_displacement = 1e-8;
  /// At a bifurcation where the path becomes unstable, or turns back, it goes
  /// on along the other branch if that is stable.
  bool takes_stable_branch = false;
  /// This rank's displacements in whose direction another branch is taken;
  /// empty = either.
  std::vector<double> direction;
  /// Parameters at which a point is wanted whenever the path passes them.
  std::vector<double> parameters;
};

enum class CurveEnd
{
  reached,     ///< the parameter is that of the end
  left,        ///< as far on the other side of the start
  closed,      ///< the path is back at its start
  most_points, ///< has so many points
  stopped      ///< by the observer
};

struct ContinuationStatistics
{
  EquilibriumStatistics newton;
  unsigned int points = 0;
  unsigned int limit_points = 0;
  unsigned int bifurcations = 0;
  unsigned int branch_switches = 0;
  unsigned int rejected_steps = 0;
  CurveEnd end = CurveEnd::reached;
  double parameter = 0; ///< of the last point
};

/// Pseudo-arclength continuation (H. B. Keller, 1977): follows equilibria from
/// the parameter `start`, where u nearly is one, towards `end`, through limit
/// points. Each point lies on a plane across the tangent of the one before it;
/// step lengths follow the effort of Newton's method and the turning of the
/// path. Limit points and bifurcations between points are found where the
/// parameter stops along the path or an eigenvalue passes zero. Calls
/// `accepted` for every point, in order; the path ends if that returns false.
/// u becomes the last point. Collective.
/// Errors: StepRejected if there is no equilibrium at the start. SolverFailed
/// if the path goes on with no step above smallest_step, or if it returns onto
/// points that it has passed, neither of which has an end: the messages name
/// the parameter; u then holds the last good point. BadInput for options that
/// are not positive.
ContinuationStatistics
continue_path(EquilibriumProblem& problem, double start, double end, double* u,
              const ContinuationOptions& options,
              const std::function<bool(const CurvePoint&)>& accepted);
} // namespace taut::time
