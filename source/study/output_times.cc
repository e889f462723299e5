#include <taut/study/output_times.h>

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
} // namespace taut::study
