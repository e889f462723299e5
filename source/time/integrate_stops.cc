#include "integrate_stops.h"

#include <algorithm>
#include <cmath>

namespace taut::time
{
bool is_same_time(const double a, const double b)
{
  return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}

namespace
{
/// One stop out of two at the same time, with the digits of the more important
/// one: the end of the run, then a jump, then a restart.
Stop merge(const Stop& a, const Stop& b, const double end)
{
  const bool a_decides = a.time == end || (a.is_jump && b.time != end);
  return {a_decides ? a.time : b.time, a.is_jump || b.is_jump,
          a.is_restart || b.is_restart};
}
} // namespace

std::vector<Stop> make_stops(const System& system, const Schedule& schedule)
{
  std::vector<Stop> candidates = {{schedule.end, false, false}};
  for (const double time : system.stop_times(schedule.start, schedule.end))
    candidates.push_back({time, true, false});
  for (const double time : schedule.restart_times)
    if (time > schedule.start && time <= schedule.end)
      candidates.push_back({time, false, true});
  std::sort(candidates.begin(), candidates.end(),
            [](const Stop& a, const Stop& b) { return a.time < b.time; });

  std::vector<Stop> stops;
  for (const Stop& stop : candidates)
    if (stops.empty() || !is_same_time(stops.back().time, stop.time))
      stops.push_back(stop);
    else
      stops.back() = merge(stops.back(), stop, schedule.end);
  return stops;
}
} // namespace taut::time
