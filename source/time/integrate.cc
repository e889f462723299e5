#include <taut/base/exceptions.h>
#include <taut/time/integrate.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "integrate_events.h"
#include "integrate_stepper.h"
#include "integrate_stops.h"

namespace taut::time
{
namespace
{
void require(const bool condition, const std::string& message)
{
  if (!condition)
    throw BadInput(message);
}

void validate(const IntegratorOptions& options, const Schedule& schedule,
              const GuardedSystem& system)
{
  require(options.position_tolerance > 0 && options.internal_tolerance > 0,
          "the tolerances of the integrator must be positive");
  require(options.weight_of_rates > 0 && options.velocity_time > 0,
          "the weight of the rates and the velocity time must be positive");
  require(options.first_step > 0, "the first step must be positive");
  require(options.largest_step >= 0, "the largest step must not be negative");
  require(options.max_order >= 1 && options.max_order <= 5,
          "the highest order of the bdf method must be 1 to 5");
  require(options.max_gamma_change > 0 && options.max_gamma_change < 1,
          "the largest change of gamma must lie between 0 and 1");
  require(schedule.end > schedule.start, "a run must end after its start");
  require(system.is_inertial() || options.method == Method::bdf,
          "a quasi-static system needs the method bdf");
}

/// What an observer sees of a step.
class AcceptedStep : public Step
{
public:
  AcceptedStep(Stepper& stepper, const double start, const double end)
      : stepper_(stepper), start_(start), end_(end)
  {
  }

  double start() const override
  {
    return start_;
  }
  double end() const override
  {
    return end_;
  }
  int order() const override
  {
    return stepper_.order();
  }
  const double* state() const override
  {
    return stepper_.state();
  }
  void interpolate(const double time, double* state) const override
  {
    stepper_.interpolate(std::clamp(time, start_, end_), state);
  }

private:
  Stepper& stepper_;
  double start_;
  double end_;
};

/// One call of integrate.
class Run
{
public:
  Run(System& system, double* state, const Schedule& schedule,
      const IntegratorOptions& options, const std::vector<Watch>& watches,
      const Observer& observer)
      : system_(system), size_(system_.layout().size()), state_(state),
        schedule_(schedule), options_(options), watches_(watches),
        observer_(observer), finder_(watches), scratch_(size_),
        time_(schedule.start)
  {
    validate(options, schedule, system_);
  }

  RunResult integrate();
  double time() const
  {
    return time_;
  }

private:
  bool has_stopped() const
  {
    return outcome_ != Outcome::completed;
  }
  void begin();
  void tell_armed() const;
  void advance_to(const Stop& stop);
  void take_step(double stop);
  void deliver(const Step& step, const std::vector<Event>& events);
  void deliver_outputs(const Step& step, double until);
  void deliver_event(const Event& event, const double* state);
  void pass(const Stop& stop);
  void restart();
  void output(double time, const double* state);
  void accept(double time, const double* state);
  void retire_stepper();
  IntegratorStatistics statistics() const;

  GuardedSystem system_;
  std::size_t size_;
  double* state_;
  const Schedule& schedule_;
  const IntegratorOptions& options_;
  const std::vector<Watch>& watches_;
  const Observer& observer_;
  EventFinder finder_;
  std::vector<double> scratch_;
  std::unique_ptr<Stepper> stepper_;

  double time_;
  std::optional<double> last_output_;
  std::size_t next_output_ = 0;
  long steps_ = 0;
  long steps_since_restart_ = 0;
  Outcome outcome_ = Outcome::completed;
  /// Counts of the steppers that are gone.
  IntegratorStatistics retired_;
};

RunResult Run::integrate()
{
  begin();
  for (const Stop& stop : make_stops(system_.get_system(), schedule_))
  {
    if (has_stopped())
      break;
    advance_to(stop);
  }
  output(time_, state_);
  RunResult result;
  result.outcome = outcome_;
  result.time = time_;
  result.statistics = statistics();
  return result;
}

void Run::tell_armed() const
{
  if (observer_.armed)
    observer_.armed(finder_.get_armed());
}

void Run::begin()
{
  output(time_, state_);
  const auto events = finder_.check(time_, state_, true);
  tell_armed();
  for (const Event& event : events)
    if (!has_stopped())
      deliver_event(event, state_);
}

void Run::advance_to(const Stop& stop)
{
  while (!has_stopped() && !is_same_time(time_, stop.time))
    take_step(stop.time);
  if (is_same_time(time_, stop.time) && outcome_ != Outcome::stopped_by_event)
    pass(stop);
  // An interruption is no news to a run that is complete.
  if (outcome_ == Outcome::interrupted && is_same_time(time_, schedule_.end))
    outcome_ = Outcome::completed;
}

void Run::take_step(const double stop)
{
  if (steps_ >= options_.max_steps)
    fail(system_.guard(), time_, "the largest number of steps is reached");
  if (!stepper_)
    stepper_ = make_stepper(system_, options_, {time_, state_, stop});
  const double end = stepper_->advance();
  ++steps_;
  ++steps_since_restart_;
  const AcceptedStep step(*stepper_, time_,
                          is_same_time(end, stop) ? stop : end);
  const auto events = finder_.find(step, scratch_.data());
  tell_armed();
  deliver(step, events);
  if (has_stopped())
    return;
  accept(step.end(), step.state());
  if (observer_.step)
    observer_.step(step, statistics());
  if (observer_.interrupted && observer_.interrupted())
    outcome_ = Outcome::interrupted;
  if (steps_since_restart_ == schedule_.restart_every_steps &&
      !is_same_time(time_, stop))
    restart();
}

void Run::deliver(const Step& step, const std::vector<Event>& events)
{
  for (const Event& event : events)
  {
    deliver_outputs(step, event.time);
    step.interpolate(event.time, scratch_.data());
    deliver_event(event, scratch_.data());
    if (has_stopped())
    {
      accept(event.time, scratch_.data());
      return;
    }
  }
  deliver_outputs(step, step.end());
}

void Run::deliver_outputs(const Step& step, const double until)
{
  const std::vector<double>& times = schedule_.output_times;
  for (; next_output_ < times.size() && times[next_output_] <= until;
       ++next_output_)
  {
    const double time = times[next_output_];
    if (time <= step.start())
      continue;
    if (time == step.end())
    {
      output(time, step.state());
      continue;
    }
    step.interpolate(time, scratch_.data());
    output(time, scratch_.data());
  }
}

void Run::deliver_event(const Event& event, const double* state)
{
  if (observer_.event)
    observer_.event(event, state);
  if (watches_[event.watch].fatal)
    outcome_ = Outcome::stopped_by_event;
}

void Run::pass(const Stop& stop)
{
  if (stop.is_jump)
  {
    system_.get_system().pass_stop_time(time_, state_);
    const auto events = finder_.check(time_, state_, false);
    tell_armed();
    for (const Event& event : events)
      if (outcome_ != Outcome::stopped_by_event)
        deliver_event(event, state_);
    // The last output may show the state before the jump.
    if (outcome_ == Outcome::stopped_by_event)
      last_output_.reset();
  }
  if (stop.is_restart ||
      (schedule_.restart_every_steps > 0 &&
       steps_since_restart_ >= schedule_.restart_every_steps))
    restart();
  retire_stepper();
}

void Run::restart()
{
  steps_since_restart_ = 0;
  retire_stepper();
  if (observer_.checkpoint)
    observer_.checkpoint(time_, state_);
}

void Run::output(const double time, const double* state)
{
  const bool is_done = last_output_ && is_same_time(time, *last_output_);
  if (!observer_.output || is_done)
    return;
  last_output_ = time;
  observer_.output(time, state);
}

void Run::accept(const double time, const double* state)
{
  time_ = time;
  std::copy_n(state, size_, state_);
}

void Run::retire_stepper()
{
  retired_ = statistics();
  stepper_.reset();
}

IntegratorStatistics Run::statistics() const
{
  IntegratorStatistics sum = retired_;
  if (stepper_)
  {
    const IntegratorStatistics counts = stepper_->statistics();
    sum.rejected_by_error += counts.rejected_by_error;
    sum.rejected_by_newton += counts.rejected_by_newton;
    sum.newton_iterations += counts.newton_iterations;
  }
  sum.steps = steps_;
  sum.evaluations = system_.evaluations();
  sum.factorisations = system_.factorisations();
  sum.solves = system_.solves();
  return sum;
}

[[noreturn]] void fail_outside(const double time, const StepRejected& rejection)
{
  std::ostringstream message;
  message.precision(12);
  message << "the run cannot go on at time " << time
          << " s: " << rejection.what();
  throw SolverFailed(message.str());
}
} // namespace

RunResult integrate(System& system, double* state, const Schedule& schedule,
                    const IntegratorOptions& options,
                    const std::vector<Watch>& watches, const Observer& observer,
                    double* reached)
{
  Run run(system, state, schedule, options, watches, observer);
  const auto report = [&]
  {
    if (reached != nullptr)
      *reached = run.time();
  };
  try
  {
    const RunResult result = run.integrate();
    report();
    return result;
  }
  catch (const StepRejected& rejection)
  {
    report();
    fail_outside(run.time(), rejection);
  }
  catch (...)
  {
    report();
    throw;
  }
}
} // namespace taut::time
