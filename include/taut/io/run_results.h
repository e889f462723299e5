#pragma once

#include <taut/io/output_folder.h>
#include <taut/study/passing_output.h>
#include <taut/study/statistic.h>

#include <functional>
#include <string>
#include <vector>

/// Numbers of a finished run, taken from memory or from its folder.
namespace taut::io
{
struct RecordedEvent
{
  std::string name, kind;
  double time = 0; ///< (s)
  double value = 0;
};

struct RecordedRun
{
  std::vector<study::Column> columns;
  /// One number per column; the first is the time (s).
  std::vector<std::vector<double>> rows;
  std::vector<RecordedEvent> events;
  /// Gives the text of run.json.
  std::function<std::string()> read_summary;
};

/// What history.csv, events.csv and run.json of a folder hold. Errors: BadInput
/// for a missing or damaged file.
RecordedRun read_run(const OutputFolder& folder);

/// Keeps a run in memory and passes all of it on to another output, if there is
/// one.
class RecordingOutput : public study::PassingOutput
{
public:
  explicit RecordingOutput(RecordedRun& run, study::RunOutput* next = nullptr)
      : PassingOutput(next), run_(run)
  {
  }
  void begin(const std::vector<study::Column>& columns) override;
  void write_row(const std::vector<double>& row) override;
  void write_event(const study::EventRecord& event) override;
  /// Also without another output.
  bool interrupted() override;

private:
  RecordedRun& run_;
};

struct ResultValue
{
  /// A number or a word; empty if the run has no such value.
  std::string text;
  /// Empty for words and where it is unknown.
  std::string unit;
};

/// Events that a run of the case may report: their names, or their kinds.
std::vector<std::string> get_event_names(const study::Case& run_case);

/// Errors: BadInput that names what is not there: a column or a member of
/// run.json that the run lacks, an event that is not among `events`.
ResultValue compute_result(const RecordedRun& run,
                           const study::ResultRequest& request,
                           const std::vector<std::string>& events);
} // namespace taut::io
