#include <taut/study/lumped_case_demes.h>
#include <taut/study/response.h>
#include <taut/study/run_demes.h>

#include <algorithm>
#include <cmath>

#include "run_lumped.h"

namespace taut::study
{
namespace
{
/// The largest deviation of the total energy from that at the start, also over
/// the largest energy that moved.
void set_balance(const lumped::DemesRun& run, const double unit,
                 RunSummary& summary)
{
  const lumped::DemesRow& start = run.rows[0];
  double drift = 0, moved = 0;
  for (const lumped::DemesRow& row : run.rows)
  {
    drift = std::max(
        drift, std::abs(row.get_total_energy() - start.get_total_energy()));
    moved = std::max({moved, row.kinetic_energy, row.dissipated_energy,
                      std::abs(row.source_work),
                      std::abs(row.free_energy - start.free_energy)});
  }
  summary.balance_absolute = unit * drift;
  summary.balance_relative = moved > 0 ? drift / moved : 0;
}

std::vector<double> get_values(const LumpedDemesRow& row)
{
  std::vector<double> values;
  for (const LumpedDemesColumn& column : get_lumped_demes_columns())
    values.push_back(row.*column.value);
  return values;
}

/// Tells `output` what happened and the summary how it ended.
void report(const Case& run_case, const lumped::DemesRun& run,
            RunOutput& output, RunSummary& summary)
{
  const LumpedDemesDescription& device = run_case.lumped_demes;
  const auto scales = lumped::make_scales(make_demes_si(device));
  for (const lumped::DemesRow& row : run.rows)
    output.write_row(get_values(make_lumped_row(device, scales, row)));
  for (const lumped::DemesEvent& event : run.events)
    output.write_event(make_event_record(device, event));
  const LumpedDemesRow last = make_lumped_row(device, run.rows.back());
  summary.time_reached = last.time;
  summary.final_row = get_values(last);
  if (run_case.procedure.analysis == structure::Analysis::transient)
    set_balance(run, scales.energy, summary);
  summary.counters["steps"] = double(run.statistics.steps);
  summary.counters["rejected"] = double(run.statistics.rejected);
  summary.counters["evaluations"] = double(run.statistics.evaluations);
  summary.notes = run.notes;
}
} // namespace

RunSummary run_demes(const Case& run_case, RunOutput& output)
{
  if (run_case.procedure.analysis == structure::Analysis::frequency_response)
    return run_response(run_case, output);
  return visit_demes(run_case, output, [](const auto&, RunSummary&) {});
}

RunSummary visit_demes(
    const Case& run_case, RunOutput& output,
    const std::function<void(const lumped::DemesRun&, RunSummary&)>& visit)
{
  return visit_lumped_model(
      run_case, get_lumped_demes_columns(), output,
      [&](const std::vector<double>& times)
      { return run_lumped(run_case.lumped_demes, run_case.procedure, times); },
      [&](const auto& run, RunOutput& recorded, RunSummary& summary)
      { report(run_case, run, recorded, summary); },
      visit);
}
} // namespace taut::study
