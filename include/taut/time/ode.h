#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace taut::time
{
/// A small dense system y' = f(t, y) on one rank, smooth between its stop
/// times.
struct OdeProblem
{
  /// Number of unknowns.
  std::size_t size = 0;
  /// rate = f(t, y). Errors: StepRejected where the state is not admissible;
  /// anything else ends the run.
  std::function<void(double time, const double* y, double* rate)> rate;
  /// Times at which f or one of its derivatives jumps, increasing.
  std::vector<double> stop_times;
  /// Called before each smooth segment, with the state at its beginning, which
  /// it may change (a jump). Until the next call, `rate` and the events are
  /// asked in [begin, end] only and at `end` must answer with the limit from
  /// the left. May be empty.
  std::function<void(double begin, double end, double* y)> begin_segment;
};

/// Conditions that the run watches. Each fires when its value falls through
/// zero.
struct OdeEvents
{
  /// All values at once, one per entry of `fatal`.
  std::function<void(double time, const double* y, double* values)> values;
  /// Whether the run stops at the event.
  std::vector<bool> fatal;
};

struct OdeEvent
{
  /// Position in OdeEvents::fatal.
  std::size_t index = 0;
  double time = 0;
  /// Not positive already at the start of the run; reported, never fatal.
  bool at_start = false;
};

enum class OdeMethod
{
  /// Explicit as long as steps of the present length would reach the end of the
  /// segment in `OdeOptions::explicit_steps` more, implicit from then on.
  automatic,
  /// Runge-Kutta of Dormand and Prince, order 5 (4): the fastest where steps
  /// are not held back by stiffness.
  explicit_runge_kutta,
  /// Backward differences of variable order (CVODE), dense Jacobian by
  /// differences: for stiff problems.
  implicit_bdf
};

struct OdeOptions
{
  OdeMethod method = OdeMethod::automatic;
  /// Local error per step, largest component of
  /// |error| / (absolute + relative |y|) for the explicit method, its root mean
  /// square for the implicit one.
  double relative_tolerance = 1e-10;
  double absolute_tolerance = 1e-12;
  /// See OdeMethod::automatic.
  long explicit_steps = 2000;
  long max_steps = 5000000;
  /// Points inside each step at which events are looked for, so that a value
  /// that dips below zero and comes back within one step is seen.
  int samples_per_step = 1;
  /// Longest step.
  double largest_step = std::numeric_limits<double>::infinity();
};

struct OdeSchedule
{
  double start = 0;
  double end = 0;
  /// Increasing; those outside [start, end] are ignored.
  std::vector<double> output_times;
};

/// What a run tells; each may be empty.
struct OdeObserver
{
  /// At the start, at each output time and at the end, which may be an event
  /// that stops the run. At a stop time: the state just after it.
  std::function<void(double time, const double* y)> output;
  /// Once per event, in order of time.
  std::function<void(const OdeEvent& event, const double* y)> event;
};

struct OdeStatistics
{
  long steps = 0;
  long rejected = 0;
  long evaluations = 0;
};

struct OdeResult
{
  /// The end of the schedule, or the time of the event that stopped the run.
  double time = 0;
  bool stopped_by_event = false;
  OdeStatistics statistics;
};

/// Integrates `y` over the schedule. Outputs and events are computed with the
/// accuracy of the method itself and never change its steps; events are located
/// to the last digits.
/// Errors: SolverFailed when the step falls below the resolution of time or
/// max_steps is exceeded; the message names the time and the last reason.
/// `y` then holds the last good state and `reached`, if given, its time. Errors
/// of the callbacks other than StepRejected from the rate pass through.
OdeResult integrate_ode(const OdeProblem& problem, const OdeSchedule& schedule,
                        const OdeOptions& options, const OdeEvents& events,
                        const OdeObserver& observer, std::vector<double>& y,
                        double* reached = nullptr);
} // namespace taut::time
