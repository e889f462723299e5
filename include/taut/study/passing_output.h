#pragma once

#include <taut/study/run.h>

namespace taut::study
{
/// Passes all that a run writes on to another output, if there is one; derived
/// classes look at it on the way. Without one there are no fields and no
/// checkpoints.
class PassingOutput : public RunOutput
{
public:
  /// `next` may be null; it must outlive this.
  explicit PassingOutput(RunOutput* next) : next_(next) {}

  void begin(const std::vector<Column>& columns) override;
  void write_row(const std::vector<double>& row) override;
  void write_event(const EventRecord& event) override;
  void write_fields(double time, structure::StructureSystem& system,
                    const double* state) override;
  void write_checkpoint(const RunProgress& progress,
                        structure::StructureSystem& system,
                        const double* state) override;
  void report_step(const time::Step& step,
                   const time::IntegratorStatistics& statistics,
                   double balance_relative) override;
  bool wants_checkpoint() override;
  bool interrupted() override;
  std::vector<std::vector<double>> get_earlier_rows() override;

protected:
  bool has_next() const
  {
    return next_ != nullptr;
  }

private:
  RunOutput* next_;
};
} // namespace taut::study
