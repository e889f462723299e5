#include <taut/io/csv_file.h>
#include <taut/io/files.h>
#include <taut/io/first_rank.h>
#include <taut/io/folder_output.h>
#include <taut/io/interrupt.h>
#include <taut/io/motion_writer.h>

#include <fmt/format.h>

#include <cmath>

namespace taut::io
{
FolderOutput::FolderOutput(const OutputFolder& folder,
                           const CaseFile& case_file,
                           const MPI_Comm communicator,
                           const std::optional<study::RunProgress>& resumed)
    : folder_(folder), case_file_(case_file), communicator_(communicator),
      is_first_(dealii::Utilities::MPI::this_mpi_process(communicator) == 0),
      resumed_(resumed.value_or(study::RunProgress())),
      last_checkpoint_(Clock::now())
{
  if (is_first_)
    log_ = std::make_unique<RunLog>(folder_.log());
}

bool FolderOutput::on_any_rank(const bool answer) const
{
  return dealii::Utilities::MPI::max(static_cast<int>(answer), communicator_) !=
         0;
}

void FolderOutput::begin(const std::vector<study::Column>& columns)
{
  const study::Case& run_case = case_file_.content;
  if (run_case.output.write_fields && run_case.model == "film")
    fields_ = std::make_unique<FieldsWriter>(folder_.path, communicator_,
                                             resumed_.field_frames);
  if (!is_first_)
    return;
  history_ = std::make_unique<HistoryWriter>(folder_.history(), columns,
                                             resumed_.history_rows);
  events_ =
      std::make_unique<EventsWriter>(folder_.events(), resumed_.event_rows);
  replace_file(folder_.parameters(), case_file_.effective_parameters,
               folder_.wait_for_disk);
  const auto& procedure = run_case.procedure;
  log_->set_interval(resumed_.history_rows > 0 ? resumed_.time
                                               : procedure.start_time,
                     procedure.end_time);
}

void FolderOutput::write_row(const std::vector<double>& row)
{
  if (is_first_)
    history_->write(row);
}

void FolderOutput::write_event(const study::EventRecord& event)
{
  if (!is_first_)
    return;
  events_->write(event);
  // The points of a path pass no threshold.
  if (std::isnan(event.threshold))
    return say(fmt::format("t = {:.9g} s: {} of the {}", event.time, event.kind,
                           event.name));
  say(fmt::format("t = {:.6g} s: {} in {}, {:.6g} against {:.6g}{}", event.time,
                  event.name, event.place, event.value, event.threshold,
                  event.at_start ? " (already at the start)" : ""));
}

void FolderOutput::write_fields(const double time,
                                structure::StructureSystem& system,
                                const double* state)
{
  fields_->write(time, system, state);
}

void FolderOutput::write_checkpoint(const study::RunProgress& progress,
                                    structure::StructureSystem& system,
                                    const double* state)
{
  const StoredRun run =
      collect_run(get_critical_parameters(case_file_), progress, system, state);
  if (is_first_)
    io::write_checkpoint(folder_.checkpoint(), run);
  last_checkpoint_ = Clock::now();
}

void FolderOutput::report_step(const time::Step& step,
                               const time::IntegratorStatistics& statistics,
                               const double balance_relative)
{
  if (is_first_)
    log_->report(step, statistics, balance_relative);
}

bool FolderOutput::wants_checkpoint()
{
  const double minutes = case_file_.content.checkpoint.every_minutes;
  const std::chrono::duration<double> passed = Clock::now() - last_checkpoint_;
  return minutes > 0 && on_any_rank(passed.count() > 60 * minutes);
}

bool FolderOutput::interrupted()
{
  return on_any_rank(was_interrupted());
}

std::vector<std::vector<double>> FolderOutput::get_earlier_rows()
{
  return on_first_rank(
      communicator_,
      [&] { return read_rows(folder_.history(), resumed_.history_rows); });
}

void FolderOutput::say(const std::string& text)
{
  if (is_first_)
    log_->say(text);
}

void FolderOutput::write_tables(const study::RunSummary& summary) const
{
  auto tables = summary.tables;
  if (summary.motion)
    tables.merge(make_motion_tables(*summary.motion));
  for (const auto& [name, table] : tables)
    replace_file(folder_.get(name + ".csv"), make_table_text(table));
}

void FolderOutput::finish(const study::RunSummary& summary)
{
  const Machine machine = measure_machine(communicator_);
  if (!is_first_)
    return;
  write_tables(summary);
  replace_file(folder_.summary(),
               make_run_json(summary, machine, case_file_.changed_parameters),
               folder_.wait_for_disk);
  say(fmt::format("{} at t = {:.6g} s{}{}; output in {}",
                  to_text(summary.status), summary.time_reached,
                  summary.reason.empty() ? "" : ": ", summary.reason,
                  folder_.path));
}
} // namespace taut::io
