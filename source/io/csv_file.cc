#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/io/csv_file.h>
#include <taut/io/files.h>

#include <fmt/format.h>

#include <limits>
#include <sstream>
#include <stdexcept>

namespace taut::io
{
namespace
{
/// Header and first rows of the old file. A row ends with a line break: names
/// hold none.
std::string keep_rows(const std::string& file, const std::string& header,
                      const std::size_t rows)
{
  const std::string content = read_file(file);
  if (content.compare(0, header.size(), header) != 0)
    throw BadInput("the columns differ from those of the run that is to be "
                   "resumed: change the probes back, or start a new run",
                   file, 1, "");
  std::size_t end = header.size();
  for (std::size_t row = 0; row < rows; ++row)
  {
    const std::size_t line_break = content.find('\n', end);
    if (line_break == std::string::npos)
      throw BadInput(fmt::format("the file has {} rows, but the checkpoint was "
                                 "written after {}",
                                 row, rows),
                     file, 0, "");
    end = line_break + 1;
  }
  return content.substr(0, end);
}

/// `nan` is what to_field writes of a number that is none.
std::vector<double> read_fields(const std::string& file,
                                const std::size_t line_number,
                                const std::string& line)
{
  std::vector<double> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');)
  {
    double value = std::numeric_limits<double>::quiet_NaN();
    if (field != "nan" && field != "-nan" && !read_number(field, value))
      throw BadInput("'" + field + "' is no number", file,
                     static_cast<unsigned int>(line_number), "");
    fields.push_back(value);
  }
  return fields;
}
} // namespace

CsvFile::CsvFile(const std::string& file,
                 const std::vector<std::string>& header, const std::size_t rows)
    : file_(file)
{
  const std::string first = make_csv_line(header);
  if (rows > 0)
    replace_file(file, keep_rows(file, first, rows));
  else
    replace_file(file, first, false);
  stream_.open(file, std::ios::app);
}

void CsvFile::write(const std::vector<std::string>& fields)
{
  stream_ << make_csv_line(fields) << std::flush;
  if (!stream_)
    throw std::runtime_error("cannot write " + file_);
}

std::string make_csv_line(const std::vector<std::string>& fields)
{
  std::string line;
  for (const std::string& field : fields)
    line += (&field == &fields.front() ? "" : ",") + quote_field(field);
  return line + '\n';
}

std::vector<std::string> split_csv_line(const std::string& line)
{
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const char c = line[i];
    // Inside quotes, two of them stand for one.
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else if (c != '\r')
      fields.back() += c;
  }
  return fields;
}

std::string quote_field(const std::string& field)
{
  if (field.find_first_of(",\"\r\n") == std::string::npos)
    return field;
  std::string quoted = "\"";
  for (const char character : field)
    quoted += character == '"' ? "\"\"" : std::string(1, character);
  return quoted + '"';
}

std::vector<std::vector<double>> read_rows(const std::string& file,
                                           const std::size_t rows)
{
  std::vector<std::vector<double>> table;
  if (rows == 0)
    return table;
  std::istringstream content(read_file(file));
  std::string line;
  std::getline(content, line);
  while (table.size() < rows && std::getline(content, line))
    table.push_back(read_fields(file, table.size() + 2, line));
  if (table.size() < rows)
    throw BadInput(
        fmt::format("the file has {} rows, {} are needed", table.size(), rows),
        file, 0, "");
  return table;
}

std::string to_field(const double value)
{
  return fmt::format("{:.15g}", value);
}
} // namespace taut::io
