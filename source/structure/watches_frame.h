#pragma once

#include <taut/structure/frame_contact.h>

#include "event_watch.h"

namespace taut::structure
{
/// Frames that touch themselves or each other.
class ContactWatch : public EventWatch
{
public:
  /// Errors: BadInput for a frame that the device lacks, a device without
  /// frames that could touch, a negative threshold and frames that are closer
  /// than the threshold in the mesh.
  ContactWatch(StructureSystem& system, const EventDescription& event);
  double compute_margin(double time, const double* state) override;
  EventReport report(double time, const double* state) override;
  /// Never: what has passed through itself counts no more.
  double get_recovered_margin() const override
  {
    return std::numeric_limits<double>::infinity();
  }

private:
  FrameClearance find_closest(double time, const double* state) const;
  double compute_margin(const FrameClearance& clearance) const;
  std::string get_place(const FrameClearance& clearance) const;

  FrameContact contact_;
};
} // namespace taut::structure
