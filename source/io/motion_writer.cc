#include <taut/io/csv_file.h>
#include <taut/io/motion_writer.h>

namespace taut::io
{
namespace
{
/// The unit of a rate.
std::string make_rate_unit(const std::string& unit)
{
  return unit == "1" ? "1/s" : unit + "/s";
}

study::Table make_section_table(const study::Motion& motion)
{
  study::Table table;
  table.columns = {{"time", "s"},
                   {motion.of, motion.unit},
                   {"rate of " + motion.of, make_rate_unit(motion.unit)}};
  for (std::size_t k = 0; k < motion.section.size(); ++k)
  {
    const study::MotionPoint point = motion.section.get(k);
    table.rows.push_back({point.time, point.value, point.velocity});
  }
  return table;
}

study::Table make_spectrum_table(const study::Motion& motion)
{
  study::Table table;
  table.columns = {{"frequency", "Hz"}, {"amplitude", motion.unit}};
  const study::Spectrum& spectrum = motion.spectrum;
  for (std::size_t k = 0; k < spectrum.frequencies.size(); ++k)
    table.rows.push_back({spectrum.frequencies[k], spectrum.amplitudes[k]});
  return table;
}
} // namespace

std::map<std::string, study::Table>
make_motion_tables(const study::Motion& motion)
{
  return {{"section", make_section_table(motion)},
          {"spectrum", make_spectrum_table(motion)}};
}

std::string make_table_text(const study::Table& table)
{
  std::string text;
  for (const study::Column& column : table.columns)
    text += (text.empty() ? "" : ",") +
            quote_field(column.name + " [" + column.unit + "]");
  text += '\n';
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      text += to_field(row[i]) + (i + 1 < row.size() ? "," : "\n");
  return text;
}
} // namespace taut::io
