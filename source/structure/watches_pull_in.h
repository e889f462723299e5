#pragma once

#include "event_watch.h"

namespace taut::structure
{
/// Electromechanical pull-in: the stiffness of the device against its voltages
/// is lost. With the forces f at held internal variables, the voltages V and
/// the tangents K and K_0 with and without them,
///   d = K^-1 (f(V) - f(0)),  k = d . K d,  k_e = d . (K - K_0) d,
///   m = k/(|k| + |k_e|).
/// d is how the device answers the voltages; at their limit point it becomes
/// the null vector of K, and m falls through zero with a slope. A bifurcation
/// whose mode the voltages do not drive leaves m as it is.
class PullInWatch : public EventWatch
{
public:
  /// Errors: BadInput without electrodes, for a threshold that is not from 0
  /// to below 1 and an event that names a film.
  PullInWatch(StructureSystem& system, const EventDescription& event,
              Networks networks);
  double compute_margin(double time, const double* state) override;
  EventReport report(double time, const double* state) override;

private:
  struct Response
  {
    std::vector<double> direction; ///< d (m)
    double stiffness = 0;          ///< k (J)
    double electric_stiffness = 0; ///< k_e (J)
    /// d . f/k: by how much of the electric force the device is pushed on
    /// where k is negative.
    double push = 0;
    double get_share() const;
  };
  Response compute_response(double time, const double* state);
  double compute_margin(const Response& response) const;
  void locate(double time, const double* state, const Response& response,
              EventReport& report);
  double compute_product(const std::vector<double>& a,
                         const std::vector<double>& b) const;

  const Networks networks_;
  /// The same device once more: the integrator goes on with the factors of the
  /// other.
  std::unique_ptr<Structure> replica_;
};
} // namespace taut::structure
