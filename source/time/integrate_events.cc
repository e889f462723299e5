#include "integrate_events.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

namespace taut::time
{
EventFinder::EventFinder(const std::vector<Watch>& watches) : watches_(watches)
{
  for (const Watch& watch : watches)
    conditions_.push_back({0, watch.is_armed});
}

std::vector<bool> EventFinder::get_armed() const
{
  std::vector<bool> armed;
  for (const Condition& condition : conditions_)
    armed.push_back(condition.is_armed);
  return armed;
}

std::vector<Event> EventFinder::check(const double time, const double* state,
                                      const bool at_start)
{
  std::vector<Event> events;
  for (std::size_t i = 0; i < watches_.size(); ++i)
  {
    Condition& condition = conditions_[i];
    condition.value = watches_[i].value(time, state);
    const bool fires = condition.is_armed && condition.value < 0;
    if (fires)
      events.push_back({i, time, at_start});
    condition.is_armed = condition.value > watches_[i].recovered ||
                         (condition.is_armed && !fires);
  }
  return events;
}

std::vector<Event> EventFinder::find(const Step& step, double* scratch)
{
  std::vector<double> before(conditions_.size());
  for (std::size_t i = 0; i < conditions_.size(); ++i)
    before[i] = conditions_[i].value;
  std::vector<Event> events = check(step.end(), step.state(), false);
  for (Event& event : events)
    event.time = locate(watches_[event.watch], step, before[event.watch],
                        conditions_[event.watch].value, scratch);
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b)
                   { return a.time < b.time; });
  return events;
}

double EventFinder::locate(const Watch& watch, const Step& step,
                           const double begin_value, const double end_value,
                           double* scratch) const
{
  const auto value = [&](const double time)
  {
    step.interpolate(time, scratch);
    return watch.value(time, scratch);
  };
  const auto is_narrow = [](const double a, const double b)
  { return std::abs(b - a) <= 1e-14 * std::max(std::abs(a), std::abs(b)); };
  // An armed watch is not negative at the beginning of the step.
  if (begin_value <= 0)
    return step.start();
  std::uintmax_t max_evaluations = 200;
  return boost::math::tools::toms748_solve(value, step.start(), step.end(),
                                           begin_value, end_value, is_narrow,
                                           max_evaluations)
      .second;
}
} // namespace taut::time
