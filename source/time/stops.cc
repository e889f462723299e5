#include "stops.h"

#include <algorithm>
#include <cmath>

namespace taut::time
{
bool is_same_time(const double a, const double b)
{
  return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}

std::vector<Stop> make_stops(const System& system, const Schedule& schedule)
{
  // The end comes first so that, among equal times, its digits win.
  std::vector<Stop> candidates = {{schedule.end, false, false}};
  for (const double time : system.stop_times(schedule.start, schedule.end))
    candidates.push_back({time, true, false});
  for (const double time : schedule.restart_times)
    if (time > schedule.start && time <= schedule.end)
      candidates.push_back({time, false, true});
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Stop& a, const Stop& b) {
                     return !is_same_time(a.time, b.time) && a.time < b.time;
                   });

  std::vector<Stop> stops;
  for (const Stop& stop : candidates)
    if (stops.empty() || !is_same_time(stops.back().time, stop.time))
      stops.push_back(stop);
    else
    {
      stops.back().is_jump |= stop.is_jump;
      stops.back().is_restart |= stop.is_restart;
    }
  return stops;
}
} // namespace taut::time
