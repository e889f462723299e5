#pragma once

#include <taut/lumped/resonator_run.h>
#include <taut/study/run.h>

#include <functional>

namespace taut::study
{
/// Runs a case of the model "resonator": the lumped model of
/// Case::lumped_resonator, quasi-static or with inertia as the procedure says,
/// until it fails or ends. `output` gets the columns of get_lumped_columns(),
/// one row per history time and one per event; it is asked for no fields and
/// no checkpoints. A failure of the solver ends in Status::failed with the
/// reason.
/// Errors: BadInput for impossible parameters and for the analysis
/// `equilibrium`.
RunSummary run_resonator(const Case& run_case, RunOutput& output);

/// The same; `visit` sees the run after it was written, and may add to what is
/// told about it.
RunSummary visit_resonator(
    const Case& run_case, RunOutput& output,
    const std::function<void(const lumped::ResonatorRun&, RunSummary&)>& visit);
} // namespace taut::study
