#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace taut::io
{
/// A table of comma-separated values that grows by rows, each of which is on
/// its way to the disk when `write` returns. Fields that hold a comma, a quote
/// or a line break are quoted.
class CsvFile
{
public:
  /// Begins a new file, or (`rows` > 0) goes on after the
  /// first `rows` rows of the old one and drops the others.
  /// Errors: BadInput if the old file has another header or fewer rows,
  /// std::runtime_error if the file cannot be written.
  CsvFile(const std::string& file, const std::vector<std::string>& header,
          std::size_t rows = 0);

  /// Errors: std::runtime_error if the disk is full or gone.
  void write(const std::vector<std::string>& fields);

private:
  std::string file_;
  std::ofstream stream_;
};

/// `fields` as a line of such a table, with its end.
std::string make_csv_line(const std::vector<std::string>& fields);

/// The fields of a line, without their quotes.
std::vector<std::string> split_csv_line(const std::string& line);

/// The first rows of a file of numbers below its header.
/// Errors: BadInput if it has fewer, or fields that are no numbers.
std::vector<std::vector<double>> read_rows(const std::string& file,
                                           std::size_t rows);

/// In quotes if it needs them.
std::string quote_field(const std::string& field);

/// 15 significant digits.
std::string to_field(double value);
} // namespace taut::io
