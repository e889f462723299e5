#include "continuation_critical.h"

#include <taut/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <boost/math/tools/toms748_solve.hpp>

namespace taut::time
{
namespace
{
/// The position of a turn is needed to half the digits: the parameter changes
/// by the square of what is missing.
constexpr double turn_tolerance = 1e-6;
constexpr double crossing_tolerance = 1e-10;
/// Of a step: shorter ones are not cut to part critical points that coincide.
constexpr double inseparable = 1e-3;
/// A load that works less on a mode does not work on it: a turn is found to
/// within such a part of a step.
constexpr double no_load = 1e-2;

/// Of the values on both sides: what is left where a function vanishes.
constexpr double largest_jump = 1e-2;

bool changes_sign(const double a, const double b)
{
  return std::signbit(a) != std::signbit(b);
}

/// Looks for a zero of a function of the points between two neighbours.
class Search
{
public:
  using Function = std::function<double(const PathState&)>;

  Search(PathSolver& solver, const PathState& last, const PathState& next,
         Function function)
      : solver_(solver), last_(last), next_(next),
        function_(std::move(function))
  {
  }

  double evaluate(const double distance)
  {
    PathState state = solver_.find_between(last_, next_, distance);
    const double value = function_(state);
    if (std::abs(value) < smallest_)
    {
      smallest_ = std::abs(value);
      best_ = state;
    }
    negative_ = state.negative_eigenvalues;
    return value;
  }
  /// The point where the function, of opposite signs at `a` and `b`, vanishes.
  /// Errors: StepRejected if it jumps instead.
  const PathState& solve(const double a, const double at_a, const double b,
                         const double at_b, const double width)
  {
    std::uintmax_t most = 50;
    boost::math::tools::toms748_solve(
        [this](const double distance) { return evaluate(distance); }, a, b,
        at_a, at_b,
        [width](const double low, const double high)
        { return high - low < width; },
        most);
    if (smallest_ > largest_jump * std::max(std::abs(at_a), std::abs(at_b)))
      throw StepRejected("the path changes to another branch within a step");
    return best_;
  }
  /// Of the state evaluated last.
  std::optional<int> negative_eigenvalues() const
  {
    return negative_;
  }

private:
  PathSolver& solver_;
  const PathState &last_, &next_;
  const Function function_;
  PathState best_;
  double smallest_ = std::numeric_limits<double>::infinity();
  std::optional<int> negative_;
};

std::vector<double> make_mode(const PathSolver& solver,
                              const PathVector& tangent)
{
  double square = 0;
  for (const double component : tangent.u)
    square += component * component;
  const double length = std::sqrt(solver.communicator().sum(square));
  std::vector<double> mode = tangent.u;
  for (double& component : mode)
    component /= length;
  return mode;
}

CriticalPoint find_turn(PathSolver& solver, const PathState& last,
                        const PathState& next, const double step)
{
  Search search(solver, last, next,
                [](const PathState& state) { return state.tangent.parameter; });
  CriticalPoint point;
  point.turns = true;
  point.state = search.solve(0, last.tangent.parameter, step,
                             next.tangent.parameter, turn_tolerance * step);
  point.mode = make_mode(solver, point.state.tangent);
  // A path that leaves a symmetric shape is there tangent to its mirror image,
  // and stable on both sides.
  point.is_limit =
      !last.negative_eigenvalues ||
      last.negative_eigenvalues != next.negative_eigenvalues ||
      solver.compute_load_share(point.state.x, point.mode) > no_load;
  return point;
}

std::optional<CriticalPoint> find_crossing_branch(PathSolver& solver,
                                                  const PathState& last,
                                                  const PathState& next,
                                                  const double step)
{
  std::vector<double> mode;
  Search search(solver, last, next,
                [&](const PathState&)
                {
                  const EigenPair pair = solver.find_nearest_eigenvalue(mode);
                  mode = pair.vector;
                  return pair.value;
                });
  double a = 0, b = step;
  double at_a = search.evaluate(a), at_b = search.evaluate(b);
  // The nearest eigenvalue may be one that stays: closer to the crossing it is
  // the one that crosses. Without symmetry the eigenvalues of the symmetric
  // part cross elsewhere.
  while (!changes_sign(at_a, at_b))
  {
    if (b - a < inseparable * step)
      return std::nullopt;
    const double middle = .5 * (a + b), value = search.evaluate(middle);
    const bool before =
        search.negative_eigenvalues() == last.negative_eigenvalues;
    (before ? a : b) = middle;
    (before ? at_a : at_b) = value;
  }
  CriticalPoint point;
  point.state = search.solve(a, at_a, b, at_b, crossing_tolerance * step);
  point.mode = mode;
  return point;
}

PathVector make_side(PathSolver& solver, const CriticalPoint& point,
                     const std::vector<double>& direction)
{
  const PathVector mode{point.mode, 0};
  const PathVector& tangent = point.state.tangent;
  PathVector side =
      solver.make_unit(add(mode, -solver.dot(mode, tangent), tangent));
  double along = 0;
  for (std::size_t i = 0; i < direction.size(); ++i)
    along += direction[i] * side.u[i];
  if (solver.communicator().sum(along) < 0)
    side = add(side, -2, side);
  return side;
}

PathState step_aside(PathSolver& solver, const PathState& from,
                     const PathVector& side, const double step)
{
  PathState state =
      solver.find({side, from.x, step}, add(from.x, step, side), side);
  state.arc_length = from.arc_length + solver.distance(from, state);
  return state;
}

bool is_stable(const PathState& state)
{
  return state.negative_eigenvalues && *state.negative_eigenvalues == 0;
}
} // namespace

std::optional<CriticalPoint> find_critical_point(PathSolver& solver,
                                                 const PathState& last,
                                                 const PathState& next,
                                                 const double step)
{
  const bool turns =
      changes_sign(last.tangent.parameter, next.tangent.parameter);
  int change = 0;
  if (last.negative_eigenvalues && next.negative_eigenvalues)
    change = *next.negative_eigenvalues - *last.negative_eigenvalues;
  if (!turns && change == 0)
    return std::nullopt;
  if (std::abs(change) > 1 && step > inseparable)
    throw StepRejected("several critical points lie within a step");
  auto point = turns ? find_turn(solver, last, next, step)
                     : find_crossing_branch(solver, last, next, step);
  if (point)
    point->state.negative_eigenvalues = last.negative_eigenvalues;
  return point;
}

std::optional<PathState> find_other_branch(PathSolver& solver,
                                           const CriticalPoint& point,
                                           const PathState& last,
                                           const double step,
                                           const std::vector<double>& direction)
{
  if (point.turns)
  {
    PathVector across = solver.make_unit(
        solver.find_direction_across(point.state.x, point.mode));
    if (changes_sign(across.parameter, last.tangent.parameter))
      across = add(across, -2, across);
    // A long step may pass the stable part of the branch.
    for (const double share : {1., .1, .01})
    {
      const PathState state =
          step_aside(solver, point.state, across, share * step);
      if (is_stable(state))
        return state;
    }
    return std::nullopt;
  }
  const PathVector side = make_side(solver, point, direction);
  const PathState wanted = step_aside(solver, point.state, side, step);
  if (is_stable(wanted))
    return wanted;
  const PathState opposite =
      step_aside(solver, point.state, add(side, -2, side), step);
  return is_stable(opposite) ? opposite : wanted;
}
} // namespace taut::time
