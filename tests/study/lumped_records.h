#pragma once

#include <taut/study/run.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace lumped_records
{
/// Keeps what a run of a lumped model writes.
class Records : public taut::study::RunOutput
{
public:
  void begin(const std::vector<taut::study::Column>& all) override
  {
    columns = all;
  }
  void write_row(const std::vector<double>& row) override
  {
    rows.push_back(row);
  }
  void write_event(const taut::study::EventRecord& event) override
  {
    events.push_back(event);
  }
  void write_fields(double, taut::structure::StructureSystem&,
                    const double*) override
  {
    FAIL() << "a lumped model has no fields";
  }
  void write_checkpoint(const taut::study::RunProgress&,
                        taut::structure::StructureSystem&,
                        const double*) override
  {
    FAIL() << "a lumped model has no checkpoints";
  }
  void report_step(const taut::time::Step&,
                   const taut::time::IntegratorStatistics&, double) override
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

  double get(const std::size_t row, const std::string& name) const
  {
    const auto column =
        std::find_if(columns.begin(), columns.end(),
                     [&](const auto& other) { return other.name == name; });
    return rows.at(row).at(std::size_t(column - columns.begin()));
  }

  std::vector<taut::study::Column> columns;
  std::vector<std::vector<double>> rows;
  std::vector<taut::study::EventRecord> events;
};
} // namespace lumped_records
