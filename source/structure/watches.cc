#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/structure/watches.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace taut::structure
{
namespace
{
using Kind = EventDescription::Kind;

bool is_of_probe(const Kind kind)
{
  return kind == Kind::probe_above || kind == Kind::probe_below;
}

/// What falls as tension is lost (Pa).
double get_stress(const Kind kind, const CriticalValues& point)
{
  return kind == Kind::slackness ? point.larger_stress : point.smaller_stress;
}

/// Across which tension is lost.
Direction get_lost_direction(const PointFields& point)
{
  return point.wrinkle_strain > 0 ? point.wrinkle_direction
                                  : point.stress_directions[1];
}

/// The value below which the share `quantile` of the weight lies, over all
/// ranks; the smallest value if the share is 0.
double compute_quantile(std::vector<std::pair<double, double>> values,
                        const double quantile, const MPI_Comm comm)
{
  using dealii::Utilities::MPI::max;
  using dealii::Utilities::MPI::min;
  using dealii::Utilities::MPI::sum;
  std::sort(values.begin(), values.end());
  std::vector<double> weight_until{0.};
  for (const auto& [value, weight] : values)
    weight_until.push_back(weight_until.back() + weight);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low = min(values.empty() ? infinity : values.front().first, comm);
  double high = max(values.empty() ? -infinity : values.back().first, comm);
  const double target = quantile * sum(weight_until.back(), comm);
  const auto weight_below = [&](const double x)
  {
    const auto end = std::upper_bound(values.begin(), values.end(), x,
                                      [](const double y, const auto& entry)
                                      { return y < entry.first; });
    return sum(weight_until[end - values.begin()], comm);
  };
  if (!(weight_below(low) <= target))
    return low;
  // The bisection ends where neighbouring doubles do.
  while (true)
  {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high))
      return high;
    (weight_below(middle) > target ? high : low) = middle;
  }
}

template <typename Entry>
std::vector<std::string> get_names(const std::vector<Entry>& entries)
{
  std::vector<std::string> names;
  for (const auto& entry : entries)
    names.push_back(entry.name);
  return names;
}

std::vector<std::size_t> find_targets(const EventDescription& event,
                                      const Device& device)
{
  const bool of_probe = is_of_probe(event.kind);
  const auto names =
      of_probe ? get_names(device.probes) : get_names(device.films);
  if (!of_probe && event.of.empty())
  {
    std::vector<std::size_t> all(names.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  const auto found = std::find(names.begin(), names.end(), event.of);
  if (found == names.end())
    throw BadInput(std::string("there is no ") + (of_probe ? "probe" : "film") +
                       " '" + event.of + "'; " + suggest(event.of, names),
                   "", event.source_line, "Event " + event.name);
  return {std::size_t(found - names.begin())};
}
} // namespace

Watches::Watches(StructureSystem& system, Probes& probes)
    : system_(system), probes_(probes),
      events_(system.structure().device().events)
{
  for (const auto& event : events_)
    targets_.push_back(find_targets(event, system.structure().device()));
}

std::vector<time::Watch> Watches::make_time_watches()
{
  std::vector<time::Watch> watches;
  for (std::size_t i = 0; i < events_.size(); ++i)
    watches.push_back({events_[i].name,
                       [this, i](const double time, const double* state)
                       { return evaluate(i, time, state); },
                       events_[i].fatal});
  return watches;
}

std::vector<std::pair<double, double>>
Watches::collect(const std::size_t event, const std::size_t film,
                 const std::vector<CriticalValues>& critical) const
{
  const fe::FilmCells& cells = system_.structure().cells();
  const double strength = system_.structure()
                              .device()
                              .films[film]
                              .material.dielectric.breakdown_strength;
  const unsigned int n = cells.element().n_nodes;
  std::vector<std::pair<double, double>> values;
  for (unsigned int cell = 0; cell < cells.cells().size(); ++cell)
    if (cells.cells()[cell].film == film)
      for (unsigned int q = 0; q < n; ++q)
      {
        const auto& point = critical[cell * n + q];
        values.push_back({events_[event].kind == Kind::breakdown
                              ? strength - point.true_field
                              : get_stress(events_[event].kind, point) -
                                    events_[event].threshold,
                          cells.volume(cell, q)});
      }
  return values;
}

double
Watches::compute_film_margin(const std::size_t event, const std::size_t film,
                             const std::vector<CriticalValues>& critical) const
{
  return compute_quantile(collect(event, film, critical),
                          events_[event].quantile,
                          system_.structure().communicator());
}

double Watches::evaluate(const std::size_t event, const double time,
                         const double* state)
{
  const EventDescription& description = events_[event];
  if (is_of_probe(description.kind))
  {
    const double value = probes_.evaluate(time, state)[targets_[event].front()];
    return description.kind == Kind::probe_above
               ? description.threshold - value
               : value - description.threshold;
  }
  const auto critical = compute_critical_values(system_.structure(),
                                                system_.loads_at(time, state),
                                                state, system_.internal(state));
  double margin = std::numeric_limits<double>::infinity();
  for (const auto film : targets_[event])
    margin = std::min(margin, compute_film_margin(event, film, critical));
  return margin;
}

EventReport Watches::report(const std::size_t event, const double time,
                            const double* state)
{
  const EventDescription& description = events_[event];
  const Device& device = system_.structure().device();
  EventReport report;
  report.threshold = description.threshold;
  if (is_of_probe(description.kind))
  {
    report.place = description.of;
    report.value = probes_.evaluate(time, state)[targets_[event].front()];
    return report;
  }
  const auto critical = compute_critical_values(system_.structure(),
                                                system_.loads_at(time, state),
                                                state, system_.internal(state));
  std::vector<double> margins;
  for (const auto film : targets_[event])
    margins.push_back(compute_film_margin(event, film, critical));
  const double margin = *std::min_element(margins.begin(), margins.end());
  const double scale = compute_scale(event);
  for (std::size_t i = 0; i < margins.size(); ++i)
    if (margins[i] <= margin + 1e-6 * scale)
      report.place += (report.place.empty() ? "" : " + ") +
                      device.films[targets_[event][i]].name;
  if (description.kind == Kind::breakdown)
  {
    report.threshold = scale;
    report.value = report.threshold - margin;
  }
  else
    report.value = margin + description.threshold;
  locate(event, critical, time, state, report);
  return report;
}

double Watches::compute_scale(const std::size_t event) const
{
  const material::Elastomer& material =
      system_.structure().device().films[targets_[event].front()].material;
  if (events_[event].kind == Kind::breakdown)
    return material.dielectric.breakdown_strength;
  double modulus = 0;
  for (const auto& spring : material.springs)
    modulus += material::shear_modulus(spring);
  for (const auto& network : material.networks)
    modulus += material::shear_modulus(network.spring);
  return modulus;
}

void Watches::locate(const std::size_t event,
                     const std::vector<CriticalValues>& critical,
                     const double time, const double* state,
                     EventReport& report)
{
  Structure& structure = system_.structure();
  const fe::FilmCells& cells = structure.cells();
  const unsigned int n = cells.element().n_nodes;
  const bool breakdown = events_[event].kind == Kind::breakdown;
  double worst = std::numeric_limits<double>::infinity();
  std::size_t index = 0;
  for (unsigned int cell = 0; cell < cells.cells().size(); ++cell)
    for (const auto film : targets_[event])
      if (cells.cells()[cell].film == film)
        for (unsigned int q = 0; q < n; ++q)
        {
          const auto& point = critical[cell * n + q];
          const double value = breakdown
                                   ? -point.true_field
                                   : get_stress(events_[event].kind, point);
          if (value < worst)
          {
            worst = value;
            index = cell * n + q;
          }
        }
  const auto fields = compute_point_fields(
      structure, system_.loads_at(time, state), state, system_.internal(state));
  std::array<double, 7> found{worst};
  if (std::isfinite(worst))
  {
    const auto point = cells.mesh_point(index / n, index % n);
    std::copy(point.begin(), point.end(), found.begin() + 1);
    const auto direction = get_lost_direction(fields[index]);
    std::copy(direction.begin(), direction.end(), found.begin() + 4);
  }
  const auto all =
      dealii::Utilities::MPI::all_gather(structure.communicator(), found);
  const auto& first = *std::min_element(all.begin(), all.end());
  std::copy_n(first.begin() + 1, 3, report.point.begin());
  if (!breakdown && events_[event].kind != Kind::slackness)
    std::copy_n(first.begin() + 4, 3, report.direction.begin());
}
} // namespace taut::structure
