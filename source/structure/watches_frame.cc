#include "watches_frame.h"

#include <taut/base/number_text.h>

#include "entry_names.h"

namespace taut::structure
{
namespace
{
std::optional<unsigned int> find_frame(const EventDescription& event,
                                       const Device& device)
{
  if (event.of.empty())
    return std::nullopt;
  return find_name(event, "frame", get_names(device.frames));
}
} // namespace

ContactWatch::ContactWatch(StructureSystem& system,
                           const EventDescription& event)
    : EventWatch(system, event),
      contact_(system.structure(),
               find_frame(event, system.structure().device()))
{
  if (contact_.empty())
    refuse("there are no two elements of frames that could touch; neighbours "
           "do not count");
  if (!(event.threshold >= 0))
    refuse("the threshold of a self-contact is a gap between faces, 0 or more");
  const auto closest = contact_.get_closest_in_mesh();
  if (!(closest.mesh_distance > event.threshold))
    refuse("frames are no more than " + number_text(closest.mesh_distance) +
           " m apart in the mesh, in " + get_place(closest) + " near (" +
           number_text(closest.mesh_point[0]) + ", " +
           number_text(closest.mesh_point[1]) + ", " +
           number_text(closest.mesh_point[2]) +
           ") m: that is not above the threshold of " +
           number_text(event.threshold) + " m");
}

FrameClearance ContactWatch::find_closest(const double time,
                                          const double* state) const
{
  return contact_.find_closest(
      system_.structure().compute_positions(get_loads(time, state), state),
      event_.threshold);
}

double ContactWatch::compute_margin(const FrameClearance& clearance) const
{
  return (clearance.distance - event_.threshold) /
         (clearance.mesh_distance - event_.threshold);
}

double ContactWatch::compute_margin(const double time, const double* state)
{
  return compute_margin(find_closest(time, state));
}

std::string ContactWatch::get_place(const FrameClearance& clearance) const
{
  const auto& frames = system_.structure().device().frames;
  const auto& [a, b] = clearance.frames;
  return a == b ? frames[a].name : frames[a].name + " + " + frames[b].name;
}

EventReport ContactWatch::report(const double time, const double* state)
{
  const FrameClearance clearance = find_closest(time, state);
  EventReport report;
  report.value = clearance.distance;
  report.threshold = event_.threshold;
  report.margin = compute_margin(clearance);
  report.place = get_place(clearance);
  report.point = clearance.mesh_point;
  return report;
}
} // namespace taut::structure
