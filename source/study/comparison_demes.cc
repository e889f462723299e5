#include <taut/structure/probes.h>
#include <taut/study/comparison_demes.h>
#include <taut/study/output_times.h>

#include <algorithm>
#include <cmath>

#include "comparison_demes_models.h"
#include "comparison_rows.h"

namespace taut::study
{
namespace
{
using structure::Probe;

/// The column of a probe in the rows of the film, behind time.
std::size_t find_column(const Case& film_case, const std::string& name)
{
  const auto& probes = film_case.device.probes;
  const auto found =
      std::find_if(probes.begin(), probes.end(),
                   [&](const Probe& probe) { return probe.name == name; });
  return 1 + (found - probes.begin());
}

using Shapes = DemesShapes;

/// With an angle that is positive at the start.
Shapes select_film_shapes(const Case& film_case, const Rows& rows)
{
  const DemesComparisonDescription& parts = *film_case.demes_comparison;
  const std::size_t angle = find_column(film_case, parts.angle_probe);
  const std::size_t chord = find_column(film_case, parts.chord_probe);
  const std::size_t stretch = find_column(film_case, parts.stretch_probe);
  Shapes shapes;
  if (rows.empty())
    return shapes;
  const double sign = rows.begin()->second[angle] < 0 ? -1 : 1;
  for (const auto& [time, row] : rows)
    shapes[time] = {sign * row[angle], row[chord], row[stretch]};
  return shapes;
}

void fill_history(const std::vector<double>& times, const Shapes& shapes,
                  DemesModel& model)
{
  for (const double time : times)
  {
    const auto row = shapes.find(time);
    const DemesShape shape = row != shapes.end() ? row->second : DemesShape();
    model.angle.push_back(shape.angle);
    model.chord.push_back(shape.chord);
    model.stretch.push_back(shape.stretch);
  }
}

/// Of the rows that a model has.
void measure(const Shapes& shapes, DemesModel& model)
{
  // Far below what a run at usual tolerances resolves of an angle.
  constexpr double smallest = 1e-6;
  std::vector<double> times, angle, chord, stretch;
  for (const auto& [time, shape] : shapes)
  {
    times.push_back(time);
    angle.push_back(shape.angle);
    chord.push_back(shape.chord);
    stretch.push_back(shape.stretch);
  }
  model.oscillation = measure_oscillation(times, angle, smallest);
  const Oscillation& swing = model.oscillation;
  if (std::isnan(swing.frequency))
    return;
  const auto mean = [&](const std::vector<double>& values)
  { return compute_mean(times, values, swing); };
  model.mean = {mean(angle), mean(chord), mean(stretch)};
}

ComparedQuantity compare(const DemesComparison& comparison,
                         const DemesModel& lumped, const std::string& name,
                         const std::string& unit,
                         std::vector<double> DemesModel::*history)
{
  ComparedQuantity quantity;
  quantity.name = lumped.name == "arc" ? name : name + " (" + lumped.name + ")";
  quantity.unit = unit;
  quantity.film = comparison.film.*history;
  quantity.lumped = lumped.*history;
  std::vector<bool> counts;
  for (std::size_t i = 0; i < comparison.times.size(); ++i)
    counts.push_back(!std::isnan(quantity.film[i]) &&
                     !std::isnan(quantity.lumped[i]) &&
                     comparison.times[i] <= comparison.compared_until);
  compute_differences(comparison.times, counts, quantity);
  return quantity;
}

void compare_histories(DemesComparison& comparison)
{
  for (const DemesModel* lumped : {&comparison.arc, &comparison.elastica})
  {
    comparison.quantities.push_back(
        compare(comparison, *lumped, "angle", "rad", &DemesModel::angle));
    comparison.quantities.push_back(
        compare(comparison, *lumped, "chord", "m", &DemesModel::chord));
    comparison.quantities.push_back(
        compare(comparison, *lumped, "stretch", "1", &DemesModel::stretch));
  }
}

/// Of events the film alone has rows.
void keep_times(const std::vector<double>& times, const Signal& voltage,
                DemesComparison& comparison)
{
  for (const double time : times)
    if (!is_at_jump(voltage, time))
    {
      comparison.times.push_back(time);
      comparison.voltage.push_back(voltage.value(time));
    }
}

void run_film_model(const Case& film_case, structure::Structure& structure,
                    RunOutput& output, DemesComparison& comparison,
                    Shapes& shapes)
{
  Recorder recorder(output);
  comparison.film.name = "finite elements";
  comparison.film_summary =
      run_film(make_observed_demes_case(film_case), structure, recorder);
  comparison.film_events = recorder.events;
  comparison.compared_until = comparison.film_summary.time_reached;
  for (const std::string& note : comparison.film_summary.notes)
    comparison.notes.push_back(note);
  shapes = select_film_shapes(film_case, recorder.rows);
  if (shapes.empty())
    return;
  const Signal& voltage = comparison.equivalent.device.source;
  comparison.film.rest = {voltage.value(film_case.procedure.start_time),
                          shapes.begin()->second};
}
} // namespace

Case make_observed_demes_case(const Case& film_case)
{
  return without_files(film_case);
}

DemesComparison compare_demes_models(const Case& film_case,
                                     const DemesEquivalent& equivalent,
                                     structure::Structure& structure,
                                     RunOutput& output)
{
  DemesComparison comparison;
  comparison.equivalent = equivalent;
  const auto times = make_history_times(film_case);
  // They take no time: what is wrong with them is known before the film runs.
  const Shapes arc = run_arc(film_case.procedure, times, comparison);
  const Shapes elastica = run_elastica(film_case.procedure, times, comparison);
  Shapes film;
  run_film_model(film_case, structure, output, comparison, film);
  keep_times(times, equivalent.device.source, comparison);
  const auto take = [&](const Shapes& shapes, DemesModel& model)
  {
    fill_history(comparison.times, shapes, model);
    measure(shapes, model);
  };
  take(film, comparison.film);
  take(elastica, comparison.elastica);
  take(arc, comparison.arc);
  compare_histories(comparison);
  return comparison;
}
} // namespace taut::study
