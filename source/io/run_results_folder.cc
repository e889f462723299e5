#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/io/csv_file.h>
#include <taut/io/files.h>
#include <taut/io/run_results.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <limits>
#include <sstream>

namespace taut::io
{
namespace
{
/// "angle [rad]"
study::Column read_column(const std::string& header)
{
  const std::size_t open = header.rfind(" [");
  if (open == std::string::npos || header.back() != ']')
    return {header, ""};
  return {header.substr(0, open),
          header.substr(open + 2, header.size() - open - 3)};
}

double read_field(const std::string& field)
{
  double value;
  return read_number(field, value) ? value
                                   : std::numeric_limits<double>::quiet_NaN();
}

void read_history(const std::string& file, RecordedRun& run)
{
  std::istringstream stream(read_file(file));
  std::string line;
  std::getline(stream, line);
  for (const std::string& header : split_csv_line(line))
    run.columns.push_back(read_column(header));
  while (std::getline(stream, line))
  {
    const auto fields = split_csv_line(line);
    if (fields.size() != run.columns.size())
      throw BadInput("a row has not as many fields as the header", file,
                     run.rows.size() + 2, "");
    std::vector<double> row;
    std::transform(fields.begin(), fields.end(), std::back_inserter(row),
                   read_field);
    run.rows.push_back(row);
  }
}

void read_events(const std::string& file, RecordedRun& run)
{
  std::istringstream stream(read_file(file));
  std::string line;
  std::getline(stream, line);
  const auto header = split_csv_line(line);
  const auto find = [&header](const char* name)
  { return std::find(header.begin(), header.end(), name) - header.begin(); };
  const std::size_t time = find("time [s]"), name = find("event"),
                    kind = find("kind"), value = find("value");
  while (std::getline(stream, line))
  {
    const auto fields = split_csv_line(line);
    if (fields.size() != header.size() ||
        std::max({time, name, kind, value}) >= fields.size())
      throw BadInput("this is no table of events", file, 0, "");
    run.events.push_back({fields[name], fields[kind], read_field(fields[time]),
                          read_field(fields[value])});
  }
}
} // namespace

RecordedRun read_run(const OutputFolder& folder)
{
  RecordedRun run;
  read_history(folder.history(), run);
  // A run that only computes modes has no events.
  if (std::filesystem::exists(folder.events()))
    read_events(folder.events(), run);
  run.read_summary = [file = folder.summary()] { return read_file(file); };
  return run;
}
} // namespace taut::io
