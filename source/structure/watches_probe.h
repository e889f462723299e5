#pragma once

#include "event_watch.h"

namespace taut::structure
{
/// A probe that rises above or falls below a threshold.
class PassageWatch : public EventWatch
{
public:
  /// Errors: BadInput for a probe that the device lacks.
  PassageWatch(StructureSystem& system, Probes& probes,
               const EventDescription& event);
  double compute_margin(double time, const double* state) override;
  EventReport report(double time, const double* state) override;
  /// What swings about its threshold passes it each time.
  double get_recovered_margin() const override
  {
    return 0;
  }

private:
  Probes& probes_;
  std::size_t probe_;
};

/// A probe that moves faster than a threshold.
class SnapWatch : public EventWatch
{
public:
  /// Errors: BadInput for a probe that the device lacks, a threshold that is
  /// not positive and a run without inertia.
  SnapWatch(StructureSystem& system, Probes& probes,
            const EventDescription& event);
  double compute_margin(double time, const double* state) override;
  EventReport report(double time, const double* state) override;
  /// Between two snaps the device has slowed down to half the threshold.
  double get_recovered_margin() const override
  {
    return .5;
  }

private:
  double compute_rate(double time, const double* state);

  Probes& probes_;
  std::size_t probe_;
  double size_; ///< of the mesh (m)
};
} // namespace taut::structure
