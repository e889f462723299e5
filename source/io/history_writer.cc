#include <taut/io/history_writer.h>

#include <algorithm>
#include <iterator>

namespace taut::io
{
namespace
{
std::vector<std::string> make_header(const std::vector<study::Column>& columns)
{
  std::vector<std::string> header;
  for (const study::Column& column : columns)
    header.push_back(column.name + " [" + column.unit + "]");
  return header;
}
} // namespace

HistoryWriter::HistoryWriter(const std::string& file,
                             const std::vector<study::Column>& columns,
                             const std::size_t rows)
    : table_(file, make_header(columns), rows)
{
}

void HistoryWriter::write(const std::vector<double>& row)
{
  std::vector<std::string> fields;
  std::transform(row.begin(), row.end(), std::back_inserter(fields), to_field);
  table_.write(fields);
}
} // namespace taut::io
