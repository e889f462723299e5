#include <taut/structure/watches.h>

#include "watches_film.h"
#include "watches_frame.h"
#include "watches_probe.h"
#include "watches_pull_in.h"

namespace taut::structure
{
namespace
{
std::unique_ptr<EventWatch> make_watch(StructureSystem& system, Probes& probes,
                                       const Networks networks,
                                       const EventDescription& event)
{
  using Kind = EventDescription::Kind;
  switch (event.kind)
  {
  case Kind::breakdown:
    return std::make_unique<BreakdownWatch>(system, event);
  case Kind::pull_in:
    return std::make_unique<PullInWatch>(system, event, networks);
  case Kind::self_contact:
    return std::make_unique<ContactWatch>(system, event);
  case Kind::snap_through:
    return std::make_unique<SnapWatch>(system, probes, event);
  case Kind::probe_above:
  case Kind::probe_below:
    return std::make_unique<PassageWatch>(system, probes, event);
  case Kind::tension_loss:
  case Kind::wrinkling:
  case Kind::slackness:
    break;
  }
  return std::make_unique<TensionWatch>(system, event);
}
} // namespace

Watches::Watches(StructureSystem& system, Probes& probes,
                 const Networks networks)
    : events_(system.structure().device().events)
{
  for (std::size_t i = 0; i < events_.size(); ++i)
  {
    watches_.push_back(make_watch(system, probes, networks, events_[i]));
    if (events_[i].kind != EventDescription::Kind::probe_above &&
        events_[i].kind != EventDescription::Kind::probe_below)
      curves_.push_back(i);
  }
}

Watches::~Watches() = default;

std::vector<time::Watch> Watches::make_time_watches()
{
  std::vector<time::Watch> watches;
  for (std::size_t i = 0; i < events_.size(); ++i)
    watches.push_back({events_[i].name,
                       [this, i](const double time, const double* state)
                       { return compute_margin(i, time, state); },
                       events_[i].fatal, watches_[i]->get_recovered_margin()});
  return watches;
}

EventReport Watches::report(const std::size_t event, const double time,
                            const double* state)
{
  return watches_[event]->report(time, state);
}

double Watches::compute_margin(const std::size_t event, const double time,
                               const double* state)
{
  return watches_[event]->compute_margin(time, state);
}
} // namespace taut::structure
