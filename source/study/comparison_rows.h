#pragma once

#include <taut/study/comparison.h>

#include <map>
#include <vector>

/// What the comparisons with all lumped models share.
namespace taut::study
{
/// By time (s).
using Rows = std::map<double, std::vector<double>>;

/// Keeps rows and events, and passes everything on.
class Recorder : public RunOutput
{
public:
  explicit Recorder(RunOutput& next) : next_(next) {}
  void begin(const std::vector<Column>& columns) override
  {
    next_.begin(columns);
  }
  void write_row(const std::vector<double>& row) override
  {
    rows[row.front()] = row;
    next_.write_row(row);
  }
  void write_event(const EventRecord& event) override
  {
    events.push_back(event);
    next_.write_event(event);
  }
  void write_fields(double, structure::StructureSystem&, const double*) override
  {
  }
  void write_checkpoint(const RunProgress&, structure::StructureSystem&,
                        const double*) override
  {
  }
  void report_step(const time::Step& step,
                   const time::IntegratorStatistics& statistics,
                   const double balance_relative) override
  {
    next_.report_step(step, statistics, balance_relative);
  }
  bool wants_checkpoint() override
  {
    return false;
  }
  bool interrupted() override
  {
    return next_.interrupted();
  }

  /// By time.
  Rows rows;
  std::vector<EventRecord> events;

private:
  RunOutput& next_;
};

/// The case without fields and checkpoints.
Case without_files(Case film_case);

/// Whether the voltage jumps there: one model writes the row before the jump,
/// the other the one after it.
bool is_at_jump(const Signal& voltage, double time);

/// Fills in the differences over the rows that count.
void compute_differences(const std::vector<double>& times,
                         const std::vector<bool>& counts,
                         ComparedQuantity& quantity);
} // namespace taut::study
