#pragma once

#include <taut/lumped/demes_run.h>
#include <taut/study/run.h>

#include <functional>

namespace taut::study
{
/// Runs a case of the model "demes": the lumped model of Case::lumped_demes in
/// time. `output` gets the columns of get_lumped_demes_columns(), one row per
/// history time and one event each time the film starts to push; it is asked
/// for no fields and no checkpoints. A failure of the solver ends in
/// Status::failed with the reason.
/// Errors: BadInput for impossible parameters and for another analysis than
/// `transient`.
RunSummary run_demes(const Case& run_case, RunOutput& output);

/// The same; `visit` sees the run after it was written, and may add to what is
/// told about it.
RunSummary visit_demes(
    const Case& run_case, RunOutput& output,
    const std::function<void(const lumped::DemesRun&, RunSummary&)>& visit);
} // namespace taut::study
