#pragma once

#include <taut/io/output_folder.h>
#include <taut/io/parameters.h>
#include <taut/io/run_results.h>
#include <taut/study/run.h>

#include <mpi.h>

#include <chrono>

/// A run of a case, as `taut run`, `taut modes` and the workers of `taut study`
/// do it.
namespace taut::app
{
using Clock = std::chrono::steady_clock;

/// What is done with a case.
enum class Task
{
  run,
  modes ///< a run to a state and the vibration modes about it; no resuming
};

/// Runs the case into a folder and tells on standard output how it went.
/// `record` receives it, too, if it is not null; `began` is what the total time
/// counts from. Collective. Errors: BadInput; the failure of a solver is in the
/// summary.
study::RunSummary run_case(const io::CaseFile& case_file, Task task,
                           const io::OutputFolder& folder, io::FolderUse use,
                           MPI_Comm communicator, Clock::time_point began,
                           io::RecordedRun* record = nullptr);

/// Runs the case without touching the disk. Errors likewise.
study::RunSummary run_case_in_memory(const io::CaseFile& case_file, Task task,
                                     MPI_Comm communicator,
                                     io::RecordedRun& record);
} // namespace taut::app
