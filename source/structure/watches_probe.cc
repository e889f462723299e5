#include "watches_probe.h"

#include <algorithm>
#include <cmath>

#include "entry_names.h"

namespace taut::structure
{
namespace
{
/// Half the diagonal of the box about all nodes (m).
double compute_mesh_size(const Structure& structure)
{
  double square = 0;
  for (unsigned int c = 0; c < 3; ++c)
  {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& vertex : structure.mesh().vertices)
    {
      low = std::min(low, vertex[c]);
      high = std::max(high, vertex[c]);
    }
    square += std::pow((high - low) / 2, 2);
  }
  return std::sqrt(square);
}
} // namespace

PassageWatch::PassageWatch(StructureSystem& system, Probes& probes,
                           const EventDescription& event)
    : EventWatch(system, event), probes_(probes),
      probe_(find_name(event, "probe",
                       get_names(system.structure().device().probes)))
{
}

double PassageWatch::compute_margin(const double time, const double* state)
{
  const double value = probes_.evaluate(time, state)[probe_];
  const double margin = event_.kind == EventDescription::Kind::probe_above
                            ? event_.threshold - value
                            : value - event_.threshold;
  return event_.threshold == 0 ? margin : margin / std::abs(event_.threshold);
}

EventReport PassageWatch::report(const double time, const double* state)
{
  EventReport report;
  report.place = event_.of;
  report.value = probes_.evaluate(time, state)[probe_];
  report.threshold = event_.threshold;
  report.margin = event_.threshold == 0
                      ? std::numeric_limits<double>::quiet_NaN()
                      : compute_margin(time, state);
  return report;
}

SnapWatch::SnapWatch(StructureSystem& system, Probes& probes,
                     const EventDescription& event)
    : EventWatch(system, event), probes_(probes),
      probe_(find_name(event, "probe",
                       get_names(system.structure().device().probes))),
      size_(compute_mesh_size(system.structure()))
{
  if (!(event.threshold > 0))
    refuse("the threshold of a snap-through is the speed of its probe, which "
           "must be above 0");
  if (!system.has_inertia())
    refuse("a run without inertia has no speed; a snap-through is watched in "
           "transient runs, and a path finds its limit points by itself");
}

/// By a central difference along the motion of all unknowns, at held loads.
double SnapWatch::compute_rate(const double time, const double* state)
{
  const std::size_t size = system_.layout().size();
  std::vector<double> f(size), rates(size), moved(size);
  system_.evaluate(time, state, f.data());
  system_.solve_mass(f.data(), rates.data());
  double fastest = 0;
  for (std::size_t i = 0; i < system_.layout().positions; ++i)
    fastest = std::max(fastest, std::abs(rates[i]));
  fastest = dealii::Utilities::MPI::max(fastest, system_.communicator());
  if (fastest == 0)
    return 0;
  // So far that round-off and curvature are both below 1e-10.
  const double step = 1e-5 * size_ / fastest;
  const auto evaluate = [&](const double by)
  {
    for (std::size_t i = 0; i < size; ++i)
      moved[i] = state[i] + by * rates[i];
    return probes_.evaluate(time, moved.data())[probe_];
  };
  return (evaluate(step) - evaluate(-step)) / (2 * step);
}

double SnapWatch::compute_margin(const double time, const double* state)
{
  return 1 - std::abs(compute_rate(time, state)) / event_.threshold;
}

EventReport SnapWatch::report(const double time, const double* state)
{
  EventReport report;
  report.place = event_.of;
  report.value = std::abs(compute_rate(time, state));
  report.threshold = event_.threshold;
  report.margin = 1 - report.value / report.threshold;
  return report;
}
} // namespace taut::structure
