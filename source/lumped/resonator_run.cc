#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/lumped/resonator_statics.h>

#include <cmath>

#include "resonator_motion.h"

namespace taut::lumped
{
void validate(const ResonatorRunOptions& options)
{
  if (!(options.end_time >= options.start_time) ||
      !std::isfinite(options.end_time))
    throw BadInput("a run must end after it starts, not go from " +
                   number_text(options.start_time) + " s to " +
                   number_text(options.end_time) + " s");
}

namespace
{
std::vector<double> make_internal(const Resonator& resonator,
                                  const ResonatorRunOptions& options)
{
  switch (options.start)
  {
  case ResonatorStart::unrelaxed:
    return std::vector<double>(resonator.n_internal(), 1.);
  case ResonatorStart::relaxed:
    return find_relaxed_state(resonator,
                              resonator.voltage.value(options.start_time) /
                                  resonator.voltage_unit)
        .internal;
  case ResonatorStart::given:
    break;
  }
  if (options.internal.size() != resonator.n_internal())
    throw BadInput(
        "a given start needs " + std::to_string(resonator.n_internal()) +
        " internal stretches, got " + std::to_string(options.internal.size()));
  return options.internal;
}

time::OdeProblem make_problem(const Resonator& resonator,
                              ResonatorMotion& motion, const std::size_t size,
                              const ResonatorRunOptions& options)
{
  time::OdeProblem problem;
  problem.size = size;
  problem.rate = [&](const double time, const double* y, double* rate)
  { motion.compute_rate(time, y, rate); };
  problem.stop_times =
      resonator.voltage.kinks(options.start_time, options.end_time);
  problem.begin_segment = [&](const double begin, const double end, double* y)
  { motion.begin_segment(begin, end, y); };
  return problem;
}

ResonatorRun run(const Resonator& resonator, const ResonatorRunOptions& options,
                 ResonatorMotion& motion)
{
  validate(resonator);
  validate(options);
  ResonatorRun result;
  const auto watches = motion.get_watches();
  time::OdeEvents events;
  events.fatal.assign(watches.size(), options.stop_at_failure);
  events.values = [&](const double time, const double* y, double* values)
  { motion.compute_watches(time, y, values); };
  time::OdeObserver observer;
  observer.output = [&](const double time, const double* y)
  { result.rows.push_back(motion.observe(time, y)); };
  observer.event = [&](const time::OdeEvent& event, const double* y)
  {
    const auto& watch = watches[event.index];
    result.events.push_back({watch.failure, watch.place, event.at_start,
                             motion.observe(event.time, y)});
  };
  auto y = motion.make_state(make_internal(resonator, options), options);
  const auto problem = make_problem(resonator, motion, y.size(), options);
  const auto end = time::integrate_ode(
      problem, {options.start_time, options.end_time, options.output_times},
      options.ode, events, observer, y);
  result.statistics = end.statistics;
  if (end.stopped_by_event)
    result.failure = result.events.back();
  return result;
}
} // namespace

std::string to_text(const ResonatorFailure failure)
{
  switch (failure)
  {
  case ResonatorFailure::loss_of_tension_1:
    return "loss of tension along x_1";
  case ResonatorFailure::loss_of_tension_2:
    return "loss of tension along x_2";
  case ResonatorFailure::breakdown:
    break;
  }
  return "electric breakdown";
}

std::string to_text(const ResonatorPlace place)
{
  switch (place)
  {
  case ResonatorPlace::a:
    return "A";
  case ResonatorPlace::b:
    return "B";
  case ResonatorPlace::a_and_b:
    break;
  }
  return "A and B";
}

ResonatorRun run_quasi_static(const Resonator& resonator,
                              const ResonatorRunOptions& options)
{
  QuasiStaticMotion motion(resonator);
  return run(resonator, options, motion);
}

ResonatorRun run_inertial(const Resonator& resonator,
                          const ResonatorRunOptions& options)
{
  InertialMotion motion(resonator);
  ResonatorRunOptions chosen = options;
  if (chosen.ode.method == time::OdeMethod::automatic)
    chosen.ode.method = time::OdeMethod::explicit_runge_kutta;
  return run(resonator, chosen, motion);
}
} // namespace taut::lumped
