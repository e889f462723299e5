#pragma once

#include <taut/study/passing_output.h>

namespace taut::study
{
/// Keeps of what a run writes what its case asks for of the motion.
class MotionRecorder : public PassingOutput
{
public:
  /// Both must outlive it; the case asks for a motion.
  MotionRecorder(const Case& run_case, RunOutput& output);

  /// Errors: BadInput with the nearest name if a column is missing.
  void begin(const std::vector<Column>& columns) override;
  void write_row(const std::vector<double>& row) override;

  /// Adds what became of the motion to the summary of its run.
  void finish(RunSummary& summary);

private:
  void record(const std::vector<double>& row);

  const Case& case_;
  const MotionDescription& description_;
  MotionTrack track_;
  std::string unit_, velocity_name_;
  std::size_t value_ = 0;
  /// The place of the velocity, or 0, which is that of the time.
  std::size_t velocity_ = 0;
};

/// Calls run(output) and finds out about its motion if the case asks for it.
template <typename Run>
RunSummary record_motion(const Case& run_case, RunOutput& output,
                         const Run& run)
{
  if (!run_case.motion)
    return run(output);
  MotionRecorder recorder(run_case, output);
  RunSummary summary = run(recorder);
  recorder.finish(summary);
  return summary;
}
} // namespace taut::study
