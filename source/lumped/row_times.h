#pragma once

#include <vector>

namespace taut::lumped
{
/// Start, outputs and end of a run, once each.
inline std::vector<double> make_row_times(const double start, const double end,
                                          const std::vector<double>& outputs)
{
  std::vector<double> times = {start};
  for (const double time : outputs)
    if (time > times.back() && time < end)
      times.push_back(time);
  if (end > times.back())
    times.push_back(end);
  return times;
}
} // namespace taut::lumped
