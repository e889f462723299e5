#pragma once

#include <taut/time/system.h>

#include <functional>
#include <string>
#include <vector>

namespace taut::time
{
enum class Method
{
  /// ARKODE, ESDIRK436L2SA_6_3_4: the default of systems with velocities.
  esdirk4,
  /// ARKODE, ESDIRK324L2SA_4_2_3: the fall-back.
  esdirk3,
  /// IDA, variable order: the default of quasi-static systems.
  bdf
};

struct IntegratorOptions
{
  Method method = Method::esdirk4;
  /// Local error of a displacement (m), root mean square over the free
  /// unknowns.
  double position_tolerance = 1e-8;
  /// Local error of an internal variable; only controls quasi-static runs,
  /// where the internal variables drive the motion.
  double internal_tolerance = 1e-6;
  /// Local error of a global unknown, whatever kind of run.
  double global_tolerance = 1e-6;
  /// Velocities and, in inertial runs, internal variables weigh this much less
  /// than displacements: stiff modes must not stop the step.
  double weight_of_rates = 1e-6;
  /// A characteristic time (s) that turns position_tolerance into one of
  /// velocity.
  double velocity_time = 1e-3;
  /// First step after the start and after every stop time (s).
  double first_step = 1e-6;
  /// 0 = no limit (s).
  double largest_step = 0;
  /// Highest order of Method::bdf (1 to 5).
  int max_order = 5;
  /// Relative change of the step (times the order's coefficient) up to which
  /// the factors of the linear system are kept, below 1.
  double max_gamma_change = 0.2;
  /// Steps after which they are renewed in any case; not for Method::bdf.
  int setup_frequency = 40;
  long max_steps = 2000000;
};

struct IntegratorStatistics
{
  long steps = 0;
  long rejected_by_error = 0;
  long rejected_by_newton = 0;
  long evaluations = 0;
  long factorisations = 0;
  long solves = 0;
  long newton_iterations = 0;
};

/// One accepted step, valid during the callback that receives it.
class Step
{
public:
  virtual ~Step() = default;
  virtual double start() const = 0;
  virtual double end() const = 0;
  virtual int order() const = 0;
  /// The state at end().
  virtual const double* state() const = 0;
  /// Dense output at a time in [start(), end()]. ESDIRK: the cubic Hermite
  /// polynomial of (u, v) for the positions, its derivative for the
  /// velocities (one order less), that of (y, f) for the rest, for which f is
  /// evaluated once per step. Method::bdf: the integrator's own polynomial.
  /// Collective.
  virtual void interpolate(double time, double* state) const = 0;
};

/// A condition that the run watches. It fires when `value` falls through zero,
/// and again once it has been above `recovered` in between: a value that hovers
/// about zero is heard once. The signs are compared at the ends of steps: a dip
/// inside one step goes unseen.
struct Watch
{
  std::string name;
  /// Collective; the same value on every rank.
  std::function<double(double time, const double* state)> value;
  /// The run stops at the event.
  bool fatal = false;
  /// Not negative.
  double recovered = 0;
  /// False where a run goes on in which it fired and has not recovered yet.
  bool is_armed = true;
};

struct Event
{
  std::size_t watch = 0;
  double time = 0;
  /// Already negative at the start of the run.
  bool at_start = false;
};

/// What a run tells and asks; each may be empty. All callbacks are collective.
/// In each step come first the outputs and events, in order of time, then
/// `step`, `interrupted` and, if one is due, `checkpoint`.
struct Observer
{
  /// Called at the start, at each output time and at the end (at an event that
  /// stops the run, with its time). At a jump: with the state before it, and
  /// with the one after it if an event of the jump stops the run.
  std::function<void(double time, const double* state)> output;
  /// Called after each accepted step, but not after one that ends beyond an
  /// event that stops the run.
  std::function<void(const Step&, const IntegratorStatistics&)> step;
  /// Called once per event, in order of time, with the state at the event.
  std::function<void(const Event&, const double* state)> event;
  /// Called when the watches have been looked at: which of them may fire.
  std::function<void(const std::vector<bool>&)> armed;
  /// Asked after each step; true ends the run in good order (a signal, a limit
  /// of wall time).
  std::function<bool()> interrupted;
  /// Called at each restart time with the state; the integrator starts anew
  /// after it, so that a run resumed from it equals this one.
  std::function<void(double time, const double* state)> checkpoint;
};

struct Schedule
{
  double start = 0;
  double end = 0;
  /// Times of output, increasing; those outside [start, end] are ignored.
  std::vector<double> output_times;
  /// Times at which a checkpoint is written and the integrator starts anew.
  std::vector<double> restart_times;
  /// Same, every so many accepted steps; 0 = never.
  long restart_every_steps = 0;
};

enum class Outcome
{
  completed,
  stopped_by_event,
  interrupted
};

struct RunResult
{
  Outcome outcome = Outcome::completed;
  double time = 0;
  IntegratorStatistics statistics;
};

/// Integrates `state` (which must be consistent at schedule.start) to
/// schedule.end. Never steps across a stop time of the system; output and
/// events never change the steps. Events are located to the last digits on the
/// dense output.
/// Errors: BadInput for options that make no sense; SolverFailed, with the time
/// reached and the reason; whatever the system or an observer throws except
/// StepRejected. `state` then holds the last accepted state and `reached`, if
/// given, its time.
RunResult integrate(System& system, double* state, const Schedule& schedule,
                    const IntegratorOptions& options,
                    const std::vector<Watch>& watches, const Observer& observer,
                    double* reached = nullptr);
} // namespace taut::time
