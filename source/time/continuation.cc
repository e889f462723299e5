#include <taut/base/exceptions.h>
#include <taut/time/continuation.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "continuation_critical.h"
#include "continuation_record.h"

namespace taut::time
{
namespace
{
using Kind = CurvePoint::Kind;

/// Newton's iterations up to which the next step grows, and from which it
/// shrinks; more mean a step that is better cut.
constexpr unsigned int few_iterations = 4, many_iterations = 8;
constexpr unsigned int most_iterations = 15;
constexpr double growth = 1.5, shrinkage = 0.7, cut_back = 0.5;
/// Cosines between the tangents of neighbours: below the first, the next step
/// shrinks, below the second the path may have changed its direction.
constexpr double wide_turn = 0.9, too_wide_turn = 0.5;
/// A point lies at most so many steps from its neighbour.
constexpr double longest_chord = 1.5;

/// Where a stable part of the path ended, and the direction of the way there.
struct Departure
{
  double parameter, way;
};

struct Found
{
  Kind kind;
  PathState state;
};

/// A step and what lies within it, in order; the last is its end.
struct Stretch
{
  std::vector<Found> found;
  std::optional<Departure> departure;
};

class Curve
{
public:
  Curve(EquilibriumProblem& problem, double start, double end, double* u,
        const ContinuationOptions& options,
        const std::function<bool(const CurvePoint&)>& accepted);

  ContinuationStatistics follow();

private:
  void begin();
  Stretch advance();
  PathState find_next();
  std::optional<PathState> find_end();
  void refuse_turn(const PathState& next) const;
  void rescale(PathState& next);
  Stretch examine(const PathState& next);
  void add_part(const PathState& a, const Found& b, Stretch& stretch);
  std::optional<PathState> find_landing(const PathState& a, const PathState& b,
                                        const Departure& departure);
  void accept(const Stretch& stretch);
  void remember(const PathState& next);
  void report(const Found& found);
  void finish(CurveEnd end);
  void adapt_step(const PathState& next, unsigned int iterations);
  [[noreturn]] void give_up(const std::string& reason) const;

  PathSolver solver_;
  const double start_, end_;
  double* u_;
  const ContinuationOptions& options_;
  const std::function<bool(const CurvePoint&)>& accepted_;
  PathState first_, last_;
  PathRecord record_;
  std::optional<Departure> departure_;
  double step_;
  bool goes_on_ = true;
};

EquilibriumOptions make_newton(EquilibriumOptions options)
{
  options.max_iterations = std::min(options.max_iterations, most_iterations);
  return options;
}

Curve::Curve(EquilibriumProblem& problem, const double start, const double end,
             double* u, const ContinuationOptions& options,
             const std::function<bool(const CurvePoint&)>& accepted)
    : solver_(problem, start, end, make_newton(options.newton)), start_(start),
      end_(end), u_(u), options_(options), accepted_(accepted),
      step_(1. / options.steps)
{
  last_.x = {std::vector<double>(u, u + problem.n_unknowns()), start};
}

void Curve::begin()
{
  solver_.metric().displacement = options_.noticeable_displacement;
  const PathVector forward{std::vector<double>(last_.x.u.size(), 0.),
                           end_ - start_};
  last_ = solver_.find_at(start_, last_.x, forward);
  first_ = last_;
  record_.add(first_, 0, solver_);
  report({Kind::regular, first_});
}

/// The next point, not yet examined. Errors: StepRejected.
PathState Curve::find_next()
{
  if (solver_.statistics.points == 1)
  {
    // Nothing is known yet of the size of displacements.
    const PathVector guess = add(
        last_.x, step_ * std::abs((end_ - start_) / last_.tangent.parameter),
        last_.tangent);
    return solver_.find_at(guess.parameter, guess, last_.tangent);
  }
  if (const auto at_end = find_end())
    return *at_end;
  const PathState next =
      solver_.find({last_.tangent, last_.x, step_},
                   add(last_.x, step_, last_.tangent), last_.tangent);
  refuse_turn(next);
  return next;
}

/// The end of the path if the next step would pass it: the path may have a
/// corner there. Nothing if it is not so.
std::optional<PathState> Curve::find_end()
{
  const double rest = end_ - last_.x.parameter;
  const double share = rest / (step_ * last_.tangent.parameter);
  if (!(share > 0 && share <= 1))
    return std::nullopt;
  try
  {
    const PathState state = solver_.find_at(
        end_, add(last_.x, share * step_, last_.tangent), last_.tangent);
    refuse_turn(state);
    return state;
  }
  catch (const StepRejected&)
  {
    // It turns back before.
    return std::nullopt;
  }
}

void Curve::refuse_turn(const PathState& next) const
{
  if (solver_.dot(next.tangent, last_.tangent) < too_wide_turn ||
      solver_.distance(last_, next) > longest_chord * step_)
    throw StepRejected("the path turns too much within a step");
}

void Curve::rescale(PathState& next)
{
  PathVector way = add(next.x, -1, first_.x);
  const double share = std::abs(way.parameter / (end_ - start_));
  way.parameter = 0;
  double& scale = solver_.metric().displacement;
  const double size = solver_.norm(way) * scale;
  // The first step tells what the others would add up to, were they all alike.
  scale = std::max(scale, solver_.statistics.points == 1 ? size / share : size);
  last_.tangent = solver_.make_unit(last_.tangent);
  next.tangent = solver_.make_unit(next.tangent);
  next.arc_length = last_.arc_length + solver_.distance(last_, next);
}

std::optional<PathState> Curve::find_landing(const PathState& a,
                                             const PathState& b,
                                             const Departure& departure)
{
  const auto& [parameter, way] = departure;
  if (b.negative_eigenvalues != 0 || (a.x.parameter - parameter) * way >= 0 ||
      (b.x.parameter - parameter) * way < 0)
    return std::nullopt;
  const PathState landing = solver_.find_crossing(a, b, parameter);
  return landing.negative_eigenvalues == 0 ? std::optional(landing)
                                           : std::nullopt;
}

/// Adds the part from `a` to `b`, along which the parameter does not turn.
void Curve::add_part(const PathState& a, const Found& b, Stretch& stretch)
{
  std::vector<Found> found;
  const auto add_crossing = [&](const double parameter, const Kind kind)
  {
    const double behind = parameter - a.x.parameter;
    const double ahead = b.state.x.parameter - parameter;
    if (behind * ahead > 0)
      found.push_back({kind, solver_.find_crossing(a, b.state, parameter)});
  };
  for (const double parameter : options_.parameters)
    if (parameter != end_)
      add_crossing(parameter, Kind::requested);
  add_crossing(end_, Kind::regular);
  add_crossing(2 * start_ - end_, Kind::regular);
  if (stretch.departure)
    if (const auto landing = find_landing(a, b.state, *stretch.departure))
    {
      found.push_back({Kind::landing, *landing});
      stretch.departure.reset();
    }
  // The first point on another branch may be the end already.
  if (b.kind == Kind::branch_switch)
    for (Found& crossing : found)
      if (crossing.kind == Kind::regular)
        crossing.kind = Kind::branch_switch;
  std::stable_sort(found.begin(), found.end(),
                   [&](const Found& x, const Found& y)
                   {
                     return std::abs(x.state.x.parameter - a.x.parameter) <
                            std::abs(y.state.x.parameter - a.x.parameter);
                   });
  stretch.found.insert(stretch.found.end(), found.begin(), found.end());
  stretch.found.push_back(b);
}

/// What lies between the last point and the next. Errors: StepRejected.
Stretch Curve::examine(const PathState& next)
{
  Stretch stretch;
  stretch.departure = departure_;
  const double step = solver_.dot(last_.tangent, add(next.x, -1, last_.x));
  auto point = find_critical_point(solver_, last_, next, step);
  if (!point)
  {
    add_part(last_, {Kind::regular, next}, stretch);
    return stretch;
  }
  const bool becomes_stable =
      !point->turns && next.negative_eigenvalues < last_.negative_eigenvalues;
  std::optional<PathState> other;
  if (options_.takes_stable_branch && !point->is_limit && !becomes_stable)
    other =
        find_other_branch(solver_, *point, last_, step_, options_.direction);
  add_part(last_,
           {point->is_limit ? Kind::limit : Kind::bifurcation, point->state},
           stretch);
  const PathState& after = other ? *other : next;
  if (last_.negative_eigenvalues == 0 && after.negative_eigenvalues != 0 &&
      !stretch.departure)
    stretch.departure = {point->state.x.parameter, last_.tangent.parameter};
  if (!other)
  {
    add_part(point->state, {Kind::regular, next}, stretch);
    return stretch;
  }
  point->state.tangent = solver_.make_unit(add(other->x, -1, point->state.x));
  add_part(point->state, {Kind::branch_switch, *other}, stretch);
  return stretch;
}

void Curve::adapt_step(const PathState& next, const unsigned int iterations)
{
  if (solver_.statistics.points == 1)
    step_ = solver_.distance(last_, next);
  const bool turns = solver_.dot(next.tangent, last_.tangent) < wide_turn;
  if (iterations > many_iterations || turns)
    step_ *= shrinkage;
  else if (iterations <= few_iterations)
    step_ *= growth;
  step_ = std::min(step_, options_.largest_step);
}

/// The next stretch of the path, whatever length its step must have.
Stretch Curve::advance()
{
  while (true)
    try
    {
      const unsigned int before = solver_.statistics.newton.iterations;
      PathState next = find_next();
      const unsigned int iterations =
          solver_.statistics.newton.iterations - before;
      rescale(next);
      Stretch stretch = examine(next);
      adapt_step(next, iterations);
      return stretch;
    }
    catch (const StepRejected& rejection)
    {
      ++solver_.statistics.rejected_steps;
      step_ *= cut_back;
      if (step_ < options_.smallest_step)
        give_up(rejection.what());
    }
}

void Curve::finish(const CurveEnd end)
{
  goes_on_ = false;
  solver_.statistics.end = end;
}

void Curve::report(const Found& found)
{
  const auto& [kind, state] = found;
  auto& statistics = solver_.statistics;
  statistics.parameter = state.x.parameter;
  std::copy(state.x.u.begin(), state.x.u.end(), u_);
  ++statistics.points;
  statistics.limit_points += kind == Kind::limit;
  statistics.bifurcations += kind == Kind::bifurcation;
  statistics.branch_switches += kind == Kind::branch_switch;
  const bool wanted = accepted_({kind, state.x.parameter, state.arc_length,
                                 state.negative_eigenvalues, u_});
  if (state.x.parameter == end_)
    finish(CurveEnd::reached);
  else if (state.x.parameter == 2 * start_ - end_)
    finish(CurveEnd::left);
  else if (!wanted)
    finish(CurveEnd::stopped);
  else if (statistics.points >= options_.most_points)
    finish(CurveEnd::most_points);
}

void Curve::remember(const PathState& next)
{
  const auto verdict =
      record_.add(next, solver_.distance(last_, next), solver_);
  if (verdict == PathRecord::Verdict::closed)
    finish(CurveEnd::closed);
  if (verdict != PathRecord::Verdict::retraced)
    return;
  std::ostringstream message;
  message.precision(12);
  message << "the path has returned to points that it passed before, at the "
             "parameter "
          << next.x.parameter << ", and would go round without end";
  throw SolverFailed(message.str());
}

void Curve::accept(const Stretch& stretch)
{
  const PathState& next = stretch.found.back().state;
  remember(next);
  for (const Found& found : stretch.found)
    if (goes_on_)
      report(found);
  last_ = next;
  departure_ = stretch.departure;
}

void Curve::give_up(const std::string& reason) const
{
  std::ostringstream message;
  message.precision(12);
  message << "the path does not go on from the parameter " << last_.x.parameter
          << ", even with the smallest step: " << reason;
  throw SolverFailed(message.str());
}

ContinuationStatistics Curve::follow()
{
  begin();
  while (goes_on_)
    accept(advance());
  return solver_.statistics;
}

void validate(const double start, const double end,
              const ContinuationOptions& options)
{
  if (!(options.steps > 0 && options.largest_step > 0 &&
        options.smallest_step > 0 && options.noticeable_displacement > 0))
    throw BadInput("the steps of a path must be positive, and so must be the "
                   "displacement that counts");
  if (!(std::abs(end - start) > 0))
    throw BadInput("a path needs a start and another end");
}
} // namespace

ContinuationStatistics
continue_path(EquilibriumProblem& problem, const double start, const double end,
              double* u, const ContinuationOptions& options,
              const std::function<bool(const CurvePoint&)>& accepted)
{
  validate(start, end, options);
  return Curve(problem, start, end, u, options, accepted).follow();
}
} // namespace taut::time
