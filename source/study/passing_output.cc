#include <taut/study/passing_output.h>

namespace taut::study
{
void PassingOutput::begin(const std::vector<Column>& columns)
{
  if (next_)
    next_->begin(columns);
}

void PassingOutput::write_row(const std::vector<double>& row)
{
  if (next_)
    next_->write_row(row);
}

void PassingOutput::write_event(const EventRecord& event)
{
  if (next_)
    next_->write_event(event);
}

void PassingOutput::write_fields(const double time,
                                 structure::StructureSystem& system,
                                 const double* state)
{
  if (next_)
    next_->write_fields(time, system, state);
}

void PassingOutput::write_checkpoint(const RunProgress& progress,
                                     structure::StructureSystem& system,
                                     const double* state)
{
  if (next_)
    next_->write_checkpoint(progress, system, state);
}

void PassingOutput::report_step(const time::Step& step,
                                const time::IntegratorStatistics& statistics,
                                const double balance_relative)
{
  if (next_)
    next_->report_step(step, statistics, balance_relative);
}

bool PassingOutput::wants_checkpoint()
{
  return next_ && next_->wants_checkpoint();
}

bool PassingOutput::interrupted()
{
  return next_ && next_->interrupted();
}

std::vector<std::vector<double>> PassingOutput::get_earlier_rows()
{
  return next_ ? next_->get_earlier_rows() : std::vector<std::vector<double>>();
}
} // namespace taut::study
