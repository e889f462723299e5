#include "run_events.h"

namespace taut::study
{
namespace
{
std::string get_kind(const structure::EventDescription& event)
{
  using Kind = structure::EventDescription::Kind;
  switch (event.kind)
  {
  case Kind::tension_loss:
    return "tension_loss";
  case Kind::wrinkling:
    return "wrinkling";
  case Kind::slackness:
    return "slackness";
  case Kind::breakdown:
    return "breakdown";
  case Kind::pull_in:
    return "pull_in";
  case Kind::snap_through:
    return "snap_through";
  case Kind::self_contact:
    return "self_contact";
  case Kind::probe_above:
    return "probe_above";
  default:
    return "probe_below";
  }
}
} // namespace

EventRecord make_event_record(const structure::EventDescription& description,
                              const time::Event& event,
                              const structure::EventReport& report)
{
  EventRecord record;
  record.time = event.time;
  record.name = description.name;
  record.kind = get_kind(description);
  record.place = report.place;
  record.point = report.point;
  record.direction = report.direction;
  record.value = report.value;
  record.threshold = report.threshold;
  record.margin = report.margin;
  record.at_start = event.at_start;
  record.fatal = description.fatal;
  return record;
}
} // namespace taut::study
