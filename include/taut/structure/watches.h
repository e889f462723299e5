#pragma once

#include <taut/structure/probes.h>
#include <taut/time/integrate.h>

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace taut::structure
{
/// Where and how far an event has come.
struct EventReport
{
  /// Of the watched quantity: stress (Pa), field (V/m), share of the stiffness
  /// that the voltage has left (pull-in), distance of the faces (m), speed of
  /// the probe (its unit/s) or the probe's unit.
  double value = 0;
  double threshold = 0;
  /// See Watches; NaN for a probe whose threshold is zero.
  double margin = 0;
  /// Films (all on a tie), frames or probe.
  std::string place;
  /// Of the worst point in the mesh (m); NaN for probes.
  std::array<double, 3> point{{std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN()}};
  /// Across which tension is lost, in space; NaN for others.
  std::array<double, 3> direction = point;
};

class EventWatch;

/// The events of a device as margins, dimensionless functions that fall through
/// zero as they happen:
/// - tension loss, wrinkling: (smaller principal stress - threshold)/modulus;
///   slackness: the same of the larger one, which is left after wrinkling. The
///   modulus is that of all springs and networks;
/// - breakdown: 1 - true field/strength;
/// - pull-in: (m - threshold)/(1 - threshold), where m is the share of the
///   stiffness against the voltage that the voltage has left: 1 without
///   voltage, 0 at the limit point. With inertia the film must also be pushed
///   on there, past the barrier that would throw it back;
/// - self-contact: (distance - threshold)/(the same in the mesh) of faces of
///   frames, smallest over all pairs; once they have passed through each other
///   it says nothing any more;
/// - snap-through: 1 - |rate of the probe|/threshold, with inertia only;
/// - probe above and below: (threshold - value)/|threshold| or its opposite,
///   undivided if the threshold is zero.
///
/// Films are looked at by a quantile of the undeformed volume, not by the bare
/// extreme, which fires at singular corners and is not smooth: an event of a
/// film happens when its margin is negative in more than the share `quantile`.
class Watches
{
public:
  /// `networks`: how the internal variables enter the stiffness that pull-in
  /// looks at: relaxed on static paths of relaxed films, else as given.
  /// Errors: BadInput for names that the device lacks, thresholds out of range
  /// and events that the device or the analysis cannot have.
  Watches(StructureSystem& system, Probes& probes,
          Networks networks = Networks::as_given);
  ~Watches();

  std::vector<time::Watch> make_time_watches();
  /// Collective.
  EventReport report(std::size_t event, double time, const double* state);

  /// Events other than passages of probes, which show in their own column.
  const std::vector<std::size_t>& with_margin_curve() const
  {
    return curves_;
  }
  /// Collective. Errors: StepRejected outside the range of a law.
  double compute_margin(std::size_t event, double time, const double* state);

private:
  std::vector<EventDescription> events_;
  std::vector<std::unique_ptr<EventWatch>> watches_;
  std::vector<std::size_t> curves_;
};
} // namespace taut::structure
