#pragma once

#include <taut/study/run.h>

namespace taut::testing
{
/// A run that nobody watches.
class Silence : public study::RunOutput
{
public:
  void begin(const std::vector<study::Column>&) override {}
  void write_row(const std::vector<double>&) override {}
  void write_event(const study::EventRecord&) override {}
  void write_fields(double, structure::StructureSystem&, const double*) override
  {
  }
  void write_checkpoint(const study::RunProgress&, structure::StructureSystem&,
                        const double*) override
  {
  }
  void report_step(const time::Step&, const time::IntegratorStatistics&,
                   double) override
  {
  }
  bool wants_checkpoint() override
  {
    return false;
  }
  bool interrupted() override
  {
    return false;
  }
};
} // namespace taut::testing
