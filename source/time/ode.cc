#include <taut/base/exceptions.h>
#include <taut/time/ode.h>

#include <algorithm>
#include <cstdint>

#include "ode_stepper.h"
#include <boost/math/tools/toms748_solve.hpp>

namespace taut::time
{
namespace
{
using State = std::vector<double>;

/// Steps before the automatic method judges the length of explicit steps.
constexpr long explicit_start = 200;
constexpr long never = std::numeric_limits<long>::max();

/// The run of one problem over one schedule.
class OdeRun
{
public:
  OdeRun(const OdeProblem& problem, const OdeSchedule& schedule,
         const OdeOptions& options, const OdeEvents& events,
         const OdeObserver& observer, State& y, double& reached)
      : problem_(problem), schedule_(schedule), options_(options),
        events_(events), observer_(observer), y_(y), reached_(reached),
        inside_(y.size()), values_(events.fatal.size()),
        new_values_(events.fatal.size()),
        next_output_(std::lower_bound(schedule.output_times.begin(),
                                      schedule.output_times.end(),
                                      schedule.start))
  {
  }

  OdeResult run()
  {
    std::vector<double> ends;
    for (const double time : problem_.stop_times)
      if (time > schedule_.start && time < schedule_.end)
        ends.push_back(time);
    ends.push_back(schedule_.end);
    double begin = schedule_.start;
    for (const double end : ends)
    {
      enter_segment(begin, end);
      if (!result_.stopped_by_event && end > begin)
        run_segment(begin, end);
      if (result_.stopped_by_event)
        return result_;
      begin = end;
    }
    result_.time = schedule_.end;
    if (!(written_ == schedule_.end))
      write(schedule_.end, y_);
    return result_;
  }

private:
  void enter_segment(const double begin, const double end)
  {
    if (problem_.begin_segment)
      problem_.begin_segment(begin, end, y_.data());
    const bool first = begin == schedule_.start;
    evaluate_events(begin, y_, new_values_);
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (new_values_[i] <= 0 && (first || values_[i] > 0))
        report({i, begin, first}, y_);
    values_ = new_values_;
    if (result_.stopped_by_event)
      return;
    if (first || is_due(begin))
      write(begin, y_);
    while (is_due(begin))
      ++next_output_;
  }

  void run_segment(const double begin, const double end)
  {
    const bool implicit = options_.method == OdeMethod::implicit_bdf;
    auto stepper = (implicit ? make_implicit_stepper : make_explicit_stepper)(
        problem_, options_, result_.statistics);
    long steps_to_change =
        options_.method == OdeMethod::automatic ? explicit_start : never;
    stepper->start(begin, end, y_);
    while (stepper->time() < end && !result_.stopped_by_event)
    {
      const double time = stepper->time();
      if (--steps_to_change < 0 &&
          end - time > options_.explicit_steps * (time - stepper->step_start()))
      {
        steps_to_change = never;
        stepper = make_implicit_stepper(problem_, options_, result_.statistics);
        stepper->start(time, end, y_);
      }
      if (result_.statistics.steps >= options_.max_steps)
        throw SolverFailed(
            "more than " + std::to_string(options_.max_steps) +
            " time steps, stopped at t = " + std::to_string(time));
      stepper->advance();
      finish_step(*stepper, end);
    }
  }

  /// Events and outputs of the last step.
  void finish_step(OdeStepper& stepper, const double segment_end)
  {
    for (const auto& event : find_events(stepper))
    {
      write_until(stepper, event.time, segment_end);
      stepper.interpolate(event.time, inside_);
      report(event, inside_);
      if (result_.stopped_by_event)
      {
        y_ = inside_;
        reached_ = event.time;
        return;
      }
    }
    write_until(stepper, stepper.time(), segment_end);
    y_ = stepper.state();
    reached_ = stepper.time();
  }

  /// Outputs inside the step up to `time`; those at the end of a segment wait
  /// for the jump there.
  void write_until(OdeStepper& stepper, const double time,
                   const double segment_end)
  {
    const bool last = segment_end == schedule_.end;
    while (is_due(time) && (*next_output_ < segment_end || last))
    {
      stepper.interpolate(*next_output_, inside_);
      write(*next_output_, inside_);
      ++next_output_;
    }
  }

  bool is_due(const double time) const
  {
    return next_output_ != schedule_.output_times.end() &&
           *next_output_ <= time;
  }

  /// A piece of a step in which a value falls through zero.
  struct Crossing
  {
    std::size_t index;
    double begin, end;
    double value_begin, value_end;
  };

  /// All crossings in the last step, by the state that `look` gives; values_
  /// moves on to the end of the step.
  std::vector<Crossing> scan(OdeStepper& stepper,
                             void (OdeStepper::*look)(double, State&))
  {
    std::vector<Crossing> found;
    const double start = stepper.step_start();
    const double length = stepper.time() - start;
    const int pieces = options_.samples_per_step + 1;
    double begin = start;
    for (int piece = 1; piece <= pieces; ++piece)
    {
      const double end =
          piece == pieces ? stepper.time() : start + length * piece / pieces;
      (stepper.*look)(end, inside_);
      evaluate_events(end, inside_, new_values_);
      for (std::size_t i = 0; i < values_.size(); ++i)
        if (values_[i] > 0 && new_values_[i] <= 0)
          found.push_back({i, begin, end, values_[i], new_values_[i]});
      values_.swap(new_values_);
      begin = end;
    }
    return found;
  }

  /// All events of the last step in order of time.
  std::vector<OdeEvent> find_events(OdeStepper& stepper)
  {
    if (events_.fatal.empty())
      return {};
    const State start_values = values_;
    auto crossings = scan(stepper, &OdeStepper::estimate);
    if (!crossings.empty())
    {
      values_ = start_values;
      crossings = scan(stepper, &OdeStepper::interpolate);
    }
    std::vector<OdeEvent> found;
    for (const auto& crossing : crossings)
      found.push_back({crossing.index, locate(stepper, crossing), false});
    std::stable_sort(found.begin(), found.end(),
                     [](const OdeEvent& a, const OdeEvent& b)
                     { return a.time < b.time; });
    return found;
  }

  /// The first time at which the value is no longer positive.
  double locate(OdeStepper& stepper, const Crossing& crossing)
  {
    if (crossing.value_end == 0)
      return crossing.end;
    const auto value = [&](const double time)
    {
      stepper.interpolate(time, inside_);
      evaluate_events(time, inside_, new_values_);
      return new_values_[crossing.index];
    };
    std::uintmax_t iterations = 100;
    return boost::math::tools::toms748_solve(
               value, crossing.begin, crossing.end, crossing.value_begin,
               crossing.value_end, boost::math::tools::eps_tolerance<double>(),
               iterations)
        .second;
  }

  void evaluate_events(const double time, const State& y, State& values) const
  {
    if (!values.empty())
      events_.values(time, y.data(), values.data());
  }

  void report(const OdeEvent& event, const State& y)
  {
    if (result_.stopped_by_event)
      return;
    if (observer_.event)
      observer_.event(event, y.data());
    if (event.at_start || !events_.fatal[event.index])
      return;
    result_.stopped_by_event = true;
    result_.time = event.time;
    write(event.time, y);
  }

  void write(const double time, const State& y)
  {
    written_ = time;
    if (observer_.output)
      observer_.output(time, y.data());
  }

  const OdeProblem& problem_;
  const OdeSchedule& schedule_;
  const OdeOptions& options_;
  const OdeEvents& events_;
  const OdeObserver& observer_;
  State& y_;
  double& reached_;
  State inside_, values_, new_values_;
  std::vector<double>::const_iterator next_output_;
  /// Time of the last output.
  double written_ = -std::numeric_limits<double>::infinity();
  OdeResult result_;
};
} // namespace

OdeResult integrate_ode(const OdeProblem& problem, const OdeSchedule& schedule,
                        const OdeOptions& options, const OdeEvents& events,
                        const OdeObserver& observer, State& y, double* reached)
{
  double last = 0;
  double& time = reached ? *reached : last;
  time = schedule.start;
  return OdeRun(problem, schedule, options, events, observer, y, time).run();
}
} // namespace taut::time
