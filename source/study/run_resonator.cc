#include <taut/study/lumped_case.h>
#include <taut/study/response.h>
#include <taut/study/run_resonator.h>

#include <algorithm>
#include <cmath>

#include "run_lumped.h"

namespace taut::study
{
namespace
{
double get_total_energy(const LumpedRow& row)
{
  return row.kinetic_energy + row.free_energy + row.dissipated_energy +
         row.voltage_work;
}

/// The largest deviation of the total energy from that at the start, also over
/// the largest energy that moved. Quasi-static runs do not track what is
/// dissipated.
void set_balance(const std::vector<LumpedRow>& rows, RunSummary& summary)
{
  double moved = 0;
  for (const LumpedRow& row : rows)
  {
    summary.balance_absolute =
        std::max(summary.balance_absolute,
                 std::abs(get_total_energy(row) - get_total_energy(rows[0])));
    moved = std::max({moved, row.kinetic_energy, row.dissipated_energy,
                      std::abs(row.voltage_work),
                      std::abs(row.free_energy - rows[0].free_energy)});
  }
  summary.balance_relative = moved > 0 ? summary.balance_absolute / moved : 0;
}

void set_counters(const time::OdeStatistics& statistics, RunSummary& summary)
{
  summary.counters["steps"] = double(statistics.steps);
  summary.counters["rejected"] = double(statistics.rejected);
  summary.counters["evaluations"] = double(statistics.evaluations);
}

std::vector<double> get_values(const LumpedRow& row)
{
  std::vector<double> values;
  for (const LumpedColumn& column : get_lumped_columns())
    values.push_back(row.*column.value);
  return values;
}

/// Tells `output` what happened and the summary how it ended.
void report(const Case& run_case, const lumped::ResonatorRun& run,
            RunOutput& output, RunSummary& summary)
{
  const auto& device = run_case.lumped_resonator;
  const auto scales = lumped::make_scales(make_resonator_si(device));
  std::vector<LumpedRow> rows;
  for (const lumped::ResonatorRow& row : run.rows)
    rows.push_back(make_lumped_row(device, scales, row));
  for (const LumpedRow& row : rows)
    output.write_row(get_values(row));
  for (const lumped::ResonatorEvent& event : run.events)
    output.write_event(make_event_record(device, event));
  summary.time_reached = rows.back().time;
  summary.final_row = get_values(rows.back());
  if (run_case.procedure.analysis == structure::Analysis::transient)
    set_balance(rows, summary);
  set_counters(run.statistics, summary);
  if (device.hold_time > 0)
    summary.findings = find_hold_limit(device, run_case.procedure);
  if (!run.failure)
    return;
  const EventRecord failure = make_event_record(device, *run.failure);
  summary.status = Status::event;
  summary.reason = failure.name + " in " + failure.place;
}
} // namespace

RunSummary run_resonator(const Case& run_case, RunOutput& output)
{
  if (run_case.procedure.analysis == structure::Analysis::frequency_response)
    return run_response(run_case, output);
  return visit_resonator(run_case, output, [](const auto&, RunSummary&) {});
}

RunSummary visit_resonator(
    const Case& run_case, RunOutput& output,
    const std::function<void(const lumped::ResonatorRun&, RunSummary&)>& visit)
{
  return visit_lumped_model(
      run_case, get_lumped_columns(), output,
      [&](const std::vector<double>& times) {
        return run_lumped(run_case.lumped_resonator, run_case.procedure, times);
      },
      [&](const auto& run, RunOutput& recorded, RunSummary& summary)
      { report(run_case, run, recorded, summary); },
      visit);
}
} // namespace taut::study
