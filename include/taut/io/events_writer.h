#pragma once

#include <taut/io/csv_file.h>
#include <taut/study/run.h>

namespace taut::io
{
/// events.csv, one row per event, in the order of time:
/// `time [s],event,kind,place,x [m],y [m],z [m],direction x,direction y,
/// direction z,value,threshold,margin,at start,fatal`. x, y, z is a point of
/// the mesh; value and threshold have the unit of their quantity (see
/// structure::EventReport); the margin is dimensionless and 0 at an event that
/// was located (see structure::Watches); what an event does not have is nan.
class EventsWriter
{
public:
  /// Goes on after `rows` rows of an old file. Errors as CsvFile.
  explicit EventsWriter(const std::string& file, std::size_t rows = 0);
  void write(const study::EventRecord& event);

private:
  CsvFile table_;
};
} // namespace taut::io
