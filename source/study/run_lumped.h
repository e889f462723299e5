#pragma once

#include <taut/base/exceptions.h>
#include <taut/study/output_times.h>
#include <taut/study/run.h>

#include <chrono>
#include <optional>
#include <vector>

#include "motion_recorder.h"

namespace taut::study
{
/// Runs a lumped model at the output times of a case: `compute`(times) gives
/// its run, `report`(run, summary) writes it to `output`. A failure of the
/// solver is in the summary.
template <typename Compute, typename Report>
RunSummary run_lumped_model(const Case& run_case,
                            const std::vector<Column>& columns,
                            RunOutput& output, const Compute& compute,
                            const Report& report)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto times = make_history_times(run_case);
  RunSummary summary;
  std::optional<decltype(compute(times))> run;
  try
  {
    run = compute(times);
  }
  catch (const SolverFailed& failure)
  {
    summary.status = Status::failed;
    summary.reason = failure.what();
    summary.time_reached = run_case.procedure.start_time;
  }
  summary.columns = columns;
  output.begin(columns);
  if (run)
    report(*run, summary);
  summary.timings["total"] =
      std::chrono::duration<double>(Clock::now() - start).count();
  return summary;
}

/// The same with its motion recorded: `report`(run, output, summary) writes it,
/// `visit`(run, summary) comes last. `lumped_columns`: those of the model.
template <typename LumpedColumns, typename Compute, typename Report,
          typename Visit>
RunSummary visit_lumped_model(const Case& run_case,
                              const LumpedColumns& lumped_columns,
                              RunOutput& output, const Compute& compute,
                              const Report& report, const Visit& visit)
{
  std::vector<Column> columns;
  for (const auto& entry : lumped_columns)
    columns.push_back(entry.column);
  return record_motion(run_case, output,
                       [&](RunOutput& recorded)
                       {
                         return run_lumped_model(
                             run_case, columns, recorded, compute,
                             [&](const auto& run, RunSummary& summary)
                             {
                               report(run, recorded, summary);
                               visit(run, summary);
                             });
                       });
}
} // namespace taut::study
