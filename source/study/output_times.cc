#include <taut/study/output_times.h>
#include <taut/study/section.h>

#include <algorithm>
#include <set>

namespace taut::study
{
std::vector<double> make_output_times(const ProcedureDescription& procedure,
                                      const unsigned int intervals,
                                      const std::vector<double>& extra)
{
  std::set<double> times(extra.begin(), extra.end());
  const double length = procedure.end_time - procedure.start_time;
  for (unsigned int i = 0; i < intervals; ++i)
    times.insert(procedure.start_time + length * i / intervals);
  times.insert({procedure.start_time, procedure.end_time});
  return {times.begin(), times.end()};
}

std::vector<double> make_history_times(const Case& run_case)
{
  const ProcedureDescription& procedure = run_case.procedure;
  const auto regular =
      make_output_times(procedure, run_case.output.history_intervals,
                        run_case.output.history_times);
  if (!run_case.motion || !(run_case.motion->period > 0))
    return regular;
  const double period = run_case.motion->period;
  std::vector<double> times =
      make_strobe_times(period, procedure.start_time, procedure.end_time);
  const std::vector<double> strobes = times;
  for (const double time : regular)
  {
    const auto next =
        std::lower_bound(strobes.begin(), strobes.end(), time - 1e-9 * period);
    if (next == strobes.end() || *next > time + 1e-9 * period)
      times.push_back(time);
  }
  std::sort(times.begin(), times.end());
  return times;
}
} // namespace taut::study
