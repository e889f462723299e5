#include <taut/structure/probes.h>
#include <taut/study/comparison.h>
#include <taut/study/lumped_case.h>
#include <taut/study/output_times.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "comparison_events.h"
#include "comparison_rows.h"

namespace taut::study
{
namespace
{
using structure::Probe;

/// A quantity of both models: a probe of the film and a value of the lumped
/// row, with the factors that make them the same.
struct Definition
{
  Probe probe;
  double film_factor = 1;
  double LumpedRow::*value = nullptr;
  double lumped_factor = 1;
};

Definition make_definition(const std::string& name, const Probe::Kind kind,
                           const std::string& of, const unsigned int component,
                           double LumpedRow::*value)
{
  Definition definition;
  definition.probe.name = name;
  definition.probe.kind = kind;
  definition.probe.of = of;
  definition.probe.component = component;
  definition.value = value;
  return definition;
}

std::vector<Definition> make_bar_definitions(const Case& film_case,
                                             const ResonatorEquivalent& same)
{
  const std::string& bar = film_case.comparison->bar;
  std::vector<Definition> all = {
      make_definition("bar displacement", Probe::Kind::bar_displacement, bar,
                      same.component, &LumpedRow::bar_displacement)};
  if (film_case.procedure.analysis == structure::Analysis::transient)
    all.push_back(make_definition("bar velocity", Probe::Kind::bar_velocity,
                                  bar, same.component,
                                  &LumpedRow::bar_velocity));
  for (Definition& definition : all)
    definition.film_factor = same.sign;
  return all;
}

/// The film pulls its support towards the bar with the stress times the
/// undeformed section; what the support carries is that without its sign.
Definition make_force_definition(const ResonatorEquivalent& same)
{
  Definition force =
      make_definition("force active", Probe::Kind::reaction, same.end_support,
                      same.component, &LumpedRow::nominal_stress_1_active);
  force.film_factor = -same.sign;
  force.lumped_factor = same.resonator.width * same.resonator.thickness;
  return force;
}

std::vector<Definition> make_definitions(const Case& film_case,
                                         const ResonatorEquivalent& same)
{
  using Kind = Probe::Kind;
  using R = LumpedRow;
  const ComparisonDescription& parts = *film_case.comparison;
  const std::string &a = parts.active_film, &b = parts.passive_film;
  std::vector<Definition> all = {
      make_definition("stretch active", Kind::mean_stretch, a, 0,
                      &R::stretch_active),
      make_definition("stretch passive", Kind::mean_stretch, b, 0,
                      &R::stretch_passive)};
  for (const Definition& definition : make_bar_definitions(film_case, same))
    all.push_back(definition);
  all.insert(all.end(),
             {make_definition("nominal stress 1 active", Kind::mean_stress, a,
                              0, &R::nominal_stress_1_active),
              make_definition("nominal stress 1 passive", Kind::mean_stress, b,
                              0, &R::nominal_stress_1_passive),
              make_definition("nominal stress 2 active", Kind::mean_stress, a,
                              1, &R::nominal_stress_2_active),
              make_definition("nominal stress 2 passive", Kind::mean_stress, b,
                              1, &R::nominal_stress_2_passive)});
  if (!same.end_support.empty())
    all.push_back(make_force_definition(same));
  all.push_back(
      make_definition("charge", Kind::charge, parts.electrode, 0, &R::charge));
  return all;
}

void record_film_events(const std::vector<EventRecord>& events,
                        const Case& film_case, Comparison& comparison)
{
  for (const EventRecord& event : events)
    comparison.film_events.push_back(make_film_event(event, film_case));
  if (comparison.film_summary.status == Status::event)
    comparison.film_failure = comparison.film_events.back();
}

void record_lumped_events(const lumped::ResonatorRun& run,
                          Comparison& comparison)
{
  const LumpedResonatorDescription& device = comparison.equivalent.resonator;
  const auto make = [&](const lumped::ResonatorEvent& event)
  {
    return make_lumped_event(make_event_record(device, event),
                             make_lumped_row(device, event.row).voltage);
  };
  for (const lumped::ResonatorEvent& event : run.events)
    comparison.lumped_events.push_back(make(event));
  if (run.failure)
    comparison.lumped_failure = make(*run.failure);
}

/// Until when the rows count, from both failures.
void compare_failures(const Case& film_case, Comparison& comparison)
{
  const auto &film = comparison.film_failure,
             &lumped = comparison.lumped_failure;
  comparison.compared_until = film_case.procedure.end_time;
  for (const auto& failure : {film, lumped})
    if (failure)
      comparison.compared_until =
          std::min(comparison.compared_until, failure->time);
  if (film && lumped)
    comparison.failure_difference = compare_failures(*film, *lumped);
}

Rows run_lumped_rows(const Case& film_case, const Rows& film_rows,
                     const std::vector<Definition>& definitions,
                     Comparison& comparison)
{
  const auto regular = make_history_times(film_case);
  std::set<double> times(regular.begin(), regular.end());
  for (const auto& [time, row] : film_rows)
    times.insert(time);
  const LumpedResonatorDescription& device = comparison.equivalent.resonator;
  const auto run =
      run_lumped(device, film_case.procedure, {times.begin(), times.end()});
  record_lumped_events(run, comparison);
  Rows rows;
  for (const lumped::ResonatorRow& row : run.rows)
  {
    const LumpedRow si = make_lumped_row(device, row);
    for (const Definition& definition : definitions)
      rows[row.time].push_back(definition.lumped_factor *
                               (si.*definition.value));
  }
  return rows;
}

/// The values of the comparison's own probes out of the rows of the film.
Rows select_film_rows(const Rows& rows, const std::size_t first,
                      const std::vector<Definition>& definitions)
{
  Rows selected;
  for (const auto& [time, row] : rows)
    for (std::size_t i = 0; i < definitions.size(); ++i)
      selected[time].push_back(definitions[i].film_factor * row[first + i]);
  return selected;
}

std::vector<double> get_values(const Rows& rows, const std::size_t quantity,
                               const std::vector<double>& times)
{
  std::vector<double> values;
  for (const double time : times)
  {
    const auto row = rows.find(time);
    values.push_back(row != rows.end()
                         ? row->second[quantity]
                         : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

void compare_rows(const Rows& film, const Rows& lumped,
                  const std::vector<Definition>& definitions,
                  Comparison& comparison)
{
  const Signal& voltage = comparison.equivalent.resonator.voltage;
  std::set<double> all;
  for (const Rows* rows : {&film, &lumped})
    for (const auto& [time, row] : *rows)
      if (!is_at_jump(voltage, time))
        all.insert(time);
  comparison.times.assign(all.begin(), all.end());
  std::vector<bool> counts;
  for (const double time : comparison.times)
  {
    comparison.voltage.push_back(voltage.value(time));
    counts.push_back(film.count(time) && lumped.count(time) &&
                     time <= comparison.compared_until);
  }
  for (std::size_t i = 0; i < definitions.size(); ++i)
  {
    ComparedQuantity quantity;
    quantity.name = definitions[i].probe.name;
    quantity.unit = structure::Probes::get_unit(definitions[i].probe.kind);
    quantity.film = get_values(film, i, comparison.times);
    quantity.lumped = get_values(lumped, i, comparison.times);
    compute_differences(comparison.times, counts, quantity);
    const auto is_zero = [](const double value)
    { return value == 0 || std::isnan(value); };
    if (!std::all_of(quantity.lumped.begin(), quantity.lumped.end(), is_zero))
      comparison.quantities.push_back(quantity);
  }
}
} // namespace

Case make_observed_case(const Case& film_case,
                        const ResonatorEquivalent& equivalent)
{
  Case observed = film_case;
  for (const Definition& definition : make_definitions(film_case, equivalent))
  {
    observed.device.probes.push_back(definition.probe);
    observed.device.probes.back().name += " (comparison)";
  }
  return without_files(observed);
}

Comparison compare_models(const Case& film_case,
                          const ResonatorEquivalent& equivalent,
                          structure::Structure& structure, RunOutput& output)
{
  const auto definitions = make_definitions(film_case, equivalent);
  Comparison comparison;
  comparison.equivalent = equivalent;
  Recorder recorder(output);
  comparison.film_summary =
      run_film(make_observed_case(film_case, equivalent), structure, recorder);
  record_film_events(recorder.events, film_case, comparison);
  const Rows lumped =
      run_lumped_rows(film_case, recorder.rows, definitions, comparison);
  compare_failures(film_case, comparison);
  const std::size_t first = 1 + film_case.device.probes.size();
  compare_rows(select_film_rows(recorder.rows, first, definitions), lumped,
               definitions, comparison);
  return comparison;
}
} // namespace taut::study
