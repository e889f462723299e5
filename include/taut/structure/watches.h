#pragma once

#include <taut/structure/point_fields.h>
#include <taut/structure/probes.h>
#include <taut/time/integrate.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace taut::structure
{
/// Where and how far an event has come.
struct EventReport
{
  /// Of the watched quantity: stress (Pa), field (V/m) or the probe's unit.
  double value = 0;
  double threshold = 0;
  /// Films (all on a tie) or probe.
  std::string place;
  /// Of the worst point in the mesh (m); NaN for probes.
  std::array<double, 3> point{{std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN()}};
  /// Across which tension is lost, in space; NaN for others.
  std::array<double, 3> direction = point;
};

/// The events of a device as functions that fall through zero.
///
/// Film events look at a quantile by undeformed volume, not at the bare
/// extreme, which fires at singular corners and is not smooth: tension is lost
/// when the smaller principal stress is below the threshold in more than the
/// share `quantile` of the film. Wrinkling is the same; the film is slack when
/// the larger one is, which it has left after wrinkling.
class Watches
{
public:
  /// Errors: BadInput for names that the device lacks.
  Watches(StructureSystem& system, Probes& probes);

  std::vector<time::Watch> make_time_watches();
  /// Collective.
  EventReport report(std::size_t event, double time, const double* state);

private:
  double evaluate(std::size_t event, double time, const double* state);
  /// Values at the points of one film, oriented so that small is bad.
  std::vector<std::pair<double, double>>
  collect(std::size_t event, std::size_t film,
          const std::vector<CriticalValues>& critical) const;
  double compute_film_margin(std::size_t event, std::size_t film,
                             const std::vector<CriticalValues>& critical) const;
  /// A value against which two margins are the same (Pa or V/m).
  double compute_scale(std::size_t event) const;
  void locate(std::size_t event, const std::vector<CriticalValues>& critical,
              double time, const double* state, EventReport& report);

  StructureSystem& system_;
  Probes& probes_;
  std::vector<EventDescription> events_;
  /// By event: the films or the one probe it looks at.
  std::vector<std::vector<std::size_t>> targets_;
};
} // namespace taut::structure
