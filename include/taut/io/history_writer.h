#pragma once

#include <taut/io/csv_file.h>
#include <taut/study/run.h>

namespace taut::io
{
/// history.csv: `time [s],name [unit],...`, one row per output time.
class HistoryWriter
{
public:
  /// Goes on after `rows` rows of an old file. Errors as CsvFile.
  HistoryWriter(const std::string& file,
                const std::vector<study::Column>& columns,
                std::size_t rows = 0);
  /// One number per column.
  void write(const std::vector<double>& row);

private:
  CsvFile table_;
};
} // namespace taut::io
