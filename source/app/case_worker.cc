#include "case_worker.h"

#include <taut/base/exceptions.h>
#include <taut/io/parameters.h>
#include <taut/io/run_summary.h>

#include <filesystem>

#include "case_run.h"

namespace taut::app
{
namespace
{
/// A run of a study is only there to be looked at.
study::RunSummary run_anew(const io::CaseFile& case_file, const Task task,
                           const io::OutputFolder& folder,
                           const MPI_Comm communicator, io::RecordedRun& record)
{
  const auto summary = run_case(case_file, task, folder, io::FolderUse::replace,
                                communicator, Clock::now(), &record);
  record.read_summary = [folder]
  { return io::read_run(folder).read_summary(); };
  return summary;
}

/// None if there is no checkpoint that fits.
std::optional<study::RunSummary> resume(const io::CaseFile& case_file,
                                        const io::OutputFolder& folder,
                                        const MPI_Comm communicator,
                                        io::RecordedRun& record)
{
  if (!std::filesystem::exists(folder.get("checkpoint/state")))
    return std::nullopt;
  try
  {
    const auto summary =
        run_case(case_file, Task::run, folder, io::FolderUse::resume,
                 communicator, Clock::now());
    // What was computed before is only there.
    record = io::read_run(folder);
    return summary;
  }
  catch (const BadInput&)
  {
    return std::nullopt;
  }
}

study::RunSummary run(const io::CaseJob& job, const io::CaseFile& case_file,
                      const MPI_Comm communicator, io::RecordedRun& record)
{
  const Task task = job.command == "modes" ? Task::modes : Task::run;
  if (job.folder.empty())
  {
    const auto summary =
        run_case_in_memory(case_file, task, communicator, record);
    record.read_summary = [summary, &case_file, communicator]
    {
      return io::make_run_json(summary, io::measure_machine(communicator),
                               case_file.changed_parameters);
    };
    return summary;
  }
  const bool is_long = case_file.content.model == "film";
  const io::OutputFolder folder{job.folder, is_long};
  if (job.resume && task == Task::run)
    if (const auto summary = resume(case_file, folder, communicator, record))
      return *summary;
  return run_anew(case_file, task, folder, communicator, record);
}

/// Until the first that no case can have.
void compute_results(const io::CaseJob& job, const io::RecordedRun& record,
                     const std::vector<std::string>& events,
                     io::CaseOutcome& outcome)
{
  for (std::size_t i = 0; i < job.results.size(); ++i)
    try
    {
      outcome.results.push_back(
          io::compute_result(record, job.results[i], events));
    }
    catch (const BadInput& problem)
    {
      outcome.mistake =
          io::ResultMistake{static_cast<unsigned int>(i), problem.message()};
      return;
    }
}
} // namespace

const io::CaseText& CaseWorker::get_text(const std::string& file)
{
  auto text = texts_.find(file);
  if (text == texts_.end())
    text = texts_.emplace(file, io::CaseText::read(file)).first;
  return text->second;
}

void CaseWorker::compute(const io::CaseJob& job, io::CaseOutcome& outcome)
{
  const bool keeps_folder = !job.folder.empty();
  const auto case_file =
      io::make_case_file(get_text(job.case_file), job.overrides, keeps_folder);
  io::RecordedRun record;
  const auto summary = run(job, case_file, communicator_, record);
  outcome.status = io::to_text(summary.status);
  outcome.reason = summary.reason;
  outcome.time_reached = summary.time_reached;
  if (outcome.is_done())
    compute_results(job, record, io::get_event_names(case_file.content),
                    outcome);
}

io::CaseOutcome CaseWorker::compute(const io::CaseJob& job)
{
  const auto began = Clock::now();
  io::CaseOutcome outcome;
  outcome.number = job.number;
  try
  {
    compute(job, outcome);
  }
  catch (const BadInput& error)
  {
    outcome.status = "refused";
    outcome.reason = error.what();
  }
  catch (const std::exception& error)
  {
    outcome.status = "failed";
    outcome.reason = error.what();
  }
  outcome.seconds = std::chrono::duration<double>(Clock::now() - began).count();
  return outcome;
}
} // namespace taut::app
