#include "watches_film.h"

#include <taut/structure/point_fields.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "entry_names.h"

namespace taut::structure
{
namespace
{
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
  double low = min(values.empty() ? std::numeric_limits<double>::infinity()
                                  : values.front().first,
                   comm);
  double high = max(values.empty() ? -std::numeric_limits<double>::infinity()
                                   : values.back().first,
                    comm);
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

std::vector<std::size_t> find_films(const EventDescription& event,
                                    const Device& device)
{
  if (!event.of.empty())
    return {find_name(event, "film", get_names(device.films))};
  std::vector<std::size_t> all(device.films.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}
} // namespace

FilmWatch::FilmWatch(StructureSystem& system, const EventDescription& event)
    : EventWatch(system, event),
      films_(find_films(event, system.structure().device()))
{
}

const Film& FilmWatch::get_film(const std::size_t cell) const
{
  const Structure& structure = system_.structure();
  return structure.device().films[structure.cells().cells()[cell].film];
}

std::vector<double>
FilmWatch::compute_film_margins(const std::vector<double>& margins) const
{
  const fe::FilmCells& cells = system_.structure().cells();
  const unsigned int n = cells.element().n_nodes;
  std::vector<double> result;
  for (const std::size_t film : films_)
  {
    std::vector<std::pair<double, double>> values;
    for (unsigned int cell = 0; cell < cells.cells().size(); ++cell)
      if (cells.cells()[cell].film == film)
        for (unsigned int q = 0; q < n; ++q)
          values.push_back({margins[cell * n + q], cells.volume(cell, q)});
    result.push_back(compute_quantile(values, event_.quantile,
                                      system_.structure().communicator()));
  }
  return result;
}

double FilmWatch::compute_margin(const double time, const double* state)
{
  const auto margins = compute_film_margins(compute_point_margins(time, state));
  return *std::min_element(margins.begin(), margins.end());
}

std::size_t FilmWatch::find_worst(const std::vector<double>& margins,
                                  const std::vector<std::size_t>& films) const
{
  const fe::FilmCells& cells = system_.structure().cells();
  const unsigned int n = cells.element().n_nodes;
  std::size_t worst = margins.size();
  for (std::size_t point = 0; point < margins.size(); ++point)
    if (std::count(films.begin(), films.end(), cells.cells()[point / n].film) >
            0 &&
        (worst == margins.size() || margins[point] < margins[worst]))
      worst = point;
  return worst;
}

EventReport FilmWatch::report(const double time, const double* state)
{
  const Structure& structure = system_.structure();
  const auto margins = compute_point_margins(time, state);
  const auto film_margins = compute_film_margins(margins);
  EventReport report;
  report.margin = *std::min_element(film_margins.begin(), film_margins.end());
  // Films that differ by less fail together. Between the ends of a step across
  // the jump of stiffness where films wrinkle, equal ones differ by some 1e-6.
  constexpr double tie = 1e-4;
  std::vector<std::size_t> failing;
  for (std::size_t i = 0; i < films_.size(); ++i)
    if (film_margins[i] <= report.margin + tie)
      failing.push_back(films_[i]);
  for (const std::size_t film : failing)
    report.place += (report.place.empty() ? "" : " + ") +
                    structure.device().films[film].name;
  // Another film may have a worse point, but in a smaller share of it.
  const std::size_t worst = find_worst(margins, failing);
  describe(worst, time, state, report);
  std::array<double, 9> found{std::numeric_limits<double>::infinity()};
  if (worst < margins.size())
  {
    const unsigned int n = structure.cells().element().n_nodes;
    const auto point = structure.cells().mesh_point(worst / n, worst % n);
    found = {margins[worst],
             report.value,
             report.threshold,
             point[0],
             point[1],
             point[2],
             report.direction[0],
             report.direction[1],
             report.direction[2]};
  }
  const auto all =
      dealii::Utilities::MPI::all_gather(structure.communicator(), found);
  const auto& first = *std::min_element(all.begin(), all.end(),
                                        [](const auto& a, const auto& b)
                                        { return a[0] < b[0]; });
  report.value = first[1];
  report.threshold = first[2];
  std::copy_n(first.begin() + 3, 3, report.point.begin());
  std::copy_n(first.begin() + 6, 3, report.direction.begin());
  return report;
}

std::vector<double> TensionWatch::compute_point_margins(const double time,
                                                        const double* state)
{
  Structure& structure = system_.structure();
  const auto critical = compute_critical_values(
      structure, get_loads(time, state), state, system_.internal(state));
  const unsigned int n = structure.cells().element().n_nodes;
  std::vector<double> margins;
  for (std::size_t point = 0; point < critical.size(); ++point)
  {
    const double stress = event_.kind == EventDescription::Kind::slackness
                              ? critical[point].larger_stress
                              : critical[point].smaller_stress;
    margins.push_back((stress - event_.threshold) /
                      material::shear_modulus(get_film(point / n).material));
  }
  return margins;
}

void TensionWatch::describe(const std::size_t point, const double time,
                            const double* state, EventReport& report)
{
  const auto fields =
      compute_point_fields(system_.structure(), get_loads(time, state), state,
                           system_.internal(state));
  if (point >= fields.size())
    return;
  const unsigned int n = system_.structure().cells().element().n_nodes;
  report.threshold = event_.threshold;
  report.value =
      report.margin * material::shear_modulus(get_film(point / n).material) +
      event_.threshold;
  if (event_.kind != EventDescription::Kind::slackness)
    report.direction = get_lost_direction(fields[point]);
}

std::vector<double> BreakdownWatch::compute_point_margins(const double time,
                                                          const double* state)
{
  std::vector<double> margins;
  for (const auto& values :
       compute_breakdown_values(system_.structure(), get_loads(time, state),
                                state, system_.internal(state)))
    margins.push_back(values.margin);
  return margins;
}

void BreakdownWatch::describe(const std::size_t point, const double time,
                              const double* state, EventReport& report)
{
  const auto values =
      compute_breakdown_values(system_.structure(), get_loads(time, state),
                               state, system_.internal(state));
  if (point >= values.size())
    return;
  report.threshold = values[point].strength;
  report.value = (1 - report.margin) * report.threshold;
}
} // namespace taut::structure
