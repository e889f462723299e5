#pragma once

#include <taut/base/exceptions.h>
#include <taut/structure/watches.h>

namespace taut::structure
{
/// One event of a device.
class EventWatch
{
public:
  EventWatch(StructureSystem& system, const EventDescription& event)
      : system_(system), event_(event)
  {
  }
  virtual ~EventWatch() = default;
  EventWatch(const EventWatch&) = delete;
  EventWatch& operator=(const EventWatch&) = delete;

  /// See Watches. Collective.
  virtual double compute_margin(double time, const double* state) = 0;
  /// Collective.
  virtual EventReport report(double time, const double* state) = 0;
  /// The event may happen again once its margin has recovered to this: what
  /// hovers about zero is reported once.
  virtual double get_recovered_margin() const
  {
    return 1e-3;
  }

protected:
  LoadState get_loads(const double time, const double* state) const
  {
    return system_.loads_at(time, state);
  }
  [[noreturn]] void refuse(const std::string& message) const
  {
    throw BadInput(message, "", event_.source_line, "Event " + event_.name);
  }

  StructureSystem& system_;
  const EventDescription event_;
};
} // namespace taut::structure
