#include <taut/io/events_writer.h>

namespace taut::io
{
namespace
{
std::string to_word(const bool value)
{
  return value ? "true" : "false";
}
} // namespace

EventsWriter::EventsWriter(const std::string& file, const std::size_t rows)
    : table_(file,
             {"time [s]", "event", "kind", "place", "x [m]", "y [m]", "z [m]",
              "direction x", "direction y", "direction z", "value", "threshold",
              "margin", "at start", "fatal"},
             rows)
{
}

void EventsWriter::write(const study::EventRecord& event)
{
  std::vector<std::string> fields{to_field(event.time), event.name, event.kind,
                                  event.place};
  for (const double coordinate : event.point)
    fields.push_back(to_field(coordinate));
  for (const double component : event.direction)
    fields.push_back(to_field(component));
  fields.push_back(to_field(event.value));
  fields.push_back(to_field(event.threshold));
  fields.push_back(to_field(event.margin));
  fields.push_back(to_word(event.at_start));
  fields.push_back(to_word(event.fatal));
  table_.write(fields);
}
} // namespace taut::io
