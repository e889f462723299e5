#include "comparison_events.h"

#include <algorithm>
#include <cmath>

namespace taut::study
{
namespace
{
std::string get_tension_kind(const std::array<double, 3>& direction,
                             const std::array<double, 3>& axis)
{
  double along = 0, squares = 0;
  for (unsigned int c = 0; c < 3; ++c)
  {
    along += direction[c] * axis[c];
    squares += axis[c] * axis[c];
  }
  const double cosine = std::min(1., std::abs(along) / std::sqrt(squares));
  // Round-off turns the axes of a uniform stress less than this.
  constexpr double aligned = 1e-3;
  if (std::sqrt(1 - cosine * cosine) < aligned)
    return "loss of tension along 1";
  if (cosine < aligned)
    return "loss of tension along 2";
  return "loss of tension";
}

std::string get_kind(const EventRecord& record,
                     const std::array<double, 3>& axis)
{
  if (record.kind == "tension_loss" || record.kind == "wrinkling")
    return get_tension_kind(record.direction, axis);
  return record.kind == "breakdown" ? record.kind : record.name;
}

/// Replaces the names of the films by the parts they play.
std::string get_place(const std::string& place,
                      const ComparisonDescription& parts)
{
  if (place == parts.active_film)
    return "active";
  if (place == parts.passive_film)
    return "passive";
  if (place == parts.active_film + " + " + parts.passive_film ||
      place == parts.passive_film + " + " + parts.active_film)
    return "active + passive";
  return place;
}

double get_voltage(const Case& film_case, const double time)
{
  for (const auto& electrode : film_case.device.electrodes)
    if (electrode.name == film_case.comparison->electrode)
      return electrode.voltage.value(time);
  return std::nan("");
}
} // namespace

ComparedEvent make_film_event(const EventRecord& record, const Case& film_case)
{
  ComparedEvent event;
  event.time = record.time;
  event.voltage = get_voltage(film_case, record.time);
  event.kind = get_kind(record, film_case.device.films.front().axis);
  event.place = get_place(record.place, *film_case.comparison);
  event.at_start = record.at_start;
  return event;
}

ComparedEvent make_lumped_event(const EventRecord& record, const double voltage)
{
  return {record.time, voltage, get_kind(record, {1, 0, 0}), record.place,
          record.at_start};
}

FailureDifference compare_failures(const ComparedEvent& film,
                                   const ComparedEvent& lumped)
{
  const auto compare = [](const double a, const double b)
  { return b == 0 ? a - b : (a - b) / std::abs(b); };
  return {compare(film.time, lumped.time),
          compare(film.voltage, lumped.voltage), film.kind == lumped.kind,
          film.place == lumped.place};
}
} // namespace taut::study
