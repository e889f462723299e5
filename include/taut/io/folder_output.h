#pragma once

#include <taut/io/checkpoint.h>
#include <taut/io/events_writer.h>
#include <taut/io/fields_writer.h>
#include <taut/io/history_writer.h>
#include <taut/io/output_folder.h>
#include <taut/io/run_log.h>
#include <taut/io/run_summary.h>

#include <chrono>
#include <optional>

namespace taut::io
{
/// Writes a run into a folder: parameters.prm, history.csv, events.csv,
/// fields.pvd, run.json, log.txt and checkpoint/, and the
/// tables of a motion or a response. Files that one rank can write
/// are the first rank's.
class FolderOutput : public study::RunOutput
{
public:
  /// `folder` is prepared. A run that goes on from `resumed` keeps what was
  /// written up to there and drops the rest. Errors: BadInput if the log cannot
  /// be opened.
  FolderOutput(const OutputFolder& folder, const CaseFile& case_file,
               MPI_Comm communicator,
               const std::optional<study::RunProgress>& resumed = std::nullopt);

  /// Writes parameters.prm, too. Errors: those of the writers.
  void begin(const std::vector<study::Column>& columns) override;
  void write_row(const std::vector<double>& row) override;
  /// Says it, too.
  void write_event(const study::EventRecord& event) override;
  void write_fields(double time, structure::StructureSystem& system,
                    const double* state) override;
  void write_checkpoint(const study::RunProgress& progress,
                        structure::StructureSystem& system,
                        const double* state) override;
  void report_step(const time::Step& step,
                   const time::IntegratorStatistics& statistics,
                   double balance_relative) override;
  bool wants_checkpoint() override;
  bool interrupted() override;
  std::vector<std::vector<double>> get_earlier_rows() override;

  /// A line for the user.
  void say(const std::string& text);
  /// Writes run.json and the tables beside history.csv and says how it ended.
  void finish(const study::RunSummary& summary);

private:
  using Clock = std::chrono::steady_clock;
  /// The answer of the first rank, or of any.
  bool on_any_rank(bool answer) const;
  void write_tables(const study::RunSummary& summary) const;

  const OutputFolder folder_;
  const CaseFile& case_file_;
  const MPI_Comm communicator_;
  const bool is_first_;
  const study::RunProgress resumed_;
  Clock::time_point last_checkpoint_;
  // All but the fields on the first rank only.
  std::unique_ptr<RunLog> log_;
  std::unique_ptr<HistoryWriter> history_;
  std::unique_ptr<EventsWriter> events_;
  std::unique_ptr<FieldsWriter> fields_;
};
} // namespace taut::io
