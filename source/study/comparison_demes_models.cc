#include "comparison_demes_models.h"

#include <taut/base/exceptions.h>
#include <taut/lumped/demes_run.h>
#include <taut/lumped/demes_statics.h>

#include <algorithm>
#include <cmath>

namespace taut::study
{
namespace
{
constexpr double pi = 3.14159265358979323846;

/// From lumped units to SI.
class Units
{
public:
  explicit Units(const DemesEquivalent& equivalent)
      : scales_(lumped::make_scales(equivalent.device)),
        film_length_(equivalent.device.film_length)
  {
  }

  double make_drive(const double voltage) const
  {
    return voltage / scales_.voltage;
  }
  double make_tau(const double time) const
  {
    return time / scales_.time;
  }
  std::vector<double> make_tau(std::vector<double> times) const
  {
    for (double& time : times)
      time = make_tau(time);
    return times;
  }
  DemesShape make_shape(const double angle, const double stretch) const
  {
    return {angle, stretch * film_length_, stretch};
  }
  DemesRest make_rest(const double voltage, const DemesShape& shape,
                      const lumped::DemesFrequencies& frequencies) const
  {
    const double unit = scales_.angular_frequency / (2 * pi);
    // NaN where the square is negative.
    return {voltage, shape, unit * std::sqrt(frequencies.relaxed_squared),
            unit * std::sqrt(frequencies.instantaneous_squared)};
  }

private:
  lumped::DemesScales scales_;
  double film_length_;
};

/// Whether the second half of the run has one voltage.
bool is_steady(const Signal& voltage, const ProcedureDescription& procedure)
{
  const double end = procedure.end_time;
  const double middle = (procedure.start_time + end) / 2;
  return voltage.kinks(middle, end).empty() && voltage.rate(middle) == 0 &&
         voltage.rate(end) == 0 && voltage.value(middle) == voltage.value(end);
}

/// The stable relaxed state that is bent most, straight if there is none bent.
template <class Equilibrium>
const Equilibrium& find_stable(const std::vector<Equilibrium>& equilibria,
                               const std::string& model)
{
  const auto last =
      std::find_if(equilibria.rbegin(), equilibria.rend(),
                   [](const Equilibrium& state) { return state.stable; });
  if (last == equilibria.rend())
    throw BadInput("the " + model +
                   " of the comparison has no stable equilibrium");
  return *last;
}

DemesRest find_arc_rest(const Units& units, const lumped::Demes& demes,
                        const double voltage)
{
  const double drive = units.make_drive(voltage);
  const auto start = lumped::make_rest_start(demes, drive);
  return units.make_rest(
      voltage, units.make_shape(start.angle, start.inner_stretch),
      lumped::compute_frequencies(demes, start.angle, drive));
}

DemesRest find_elastica_rest(const Units& units,
                             const lumped::DemesElastica& elastica,
                             const double voltage)
{
  const auto equilibria =
      lumped::find_equilibria(elastica, units.make_drive(voltage));
  const auto& rest = find_stable(equilibria, "elastica");
  return units.make_rest(voltage,
                         units.make_shape(rest.shape.end_angle, rest.stretch),
                         rest.frequencies);
}

/// Rest and, where the voltage ends steady, driven state by `find`.
template <class Find>
void find_states(const Signal& voltage, const ProcedureDescription& procedure,
                 const Find& find, DemesModel& model)
{
  const double first = voltage.value(procedure.start_time);
  const double last = voltage.value(procedure.end_time);
  model.rest = find(first);
  if (last != first && is_steady(voltage, procedure))
    model.driven = find(last);
}

/// The start at rest: stretch and inner stretch are one.
lumped::DemesState make_start(const DemesRest& rest)
{
  return {rest.shape.angle, 0, rest.shape.stretch};
}

/// Rows carry the times asked for, without the round-off of their units.
template <class Row, class Angle>
DemesShapes make_shapes(const Units& units, const std::vector<double>& times,
                        const std::vector<Row>& rows, const Angle& get_angle)
{
  DemesShapes shapes;
  for (std::size_t i = 0; i < std::min(times.size(), rows.size()); ++i)
    shapes[times[i]] = units.make_shape(get_angle(rows[i]), rows[i].stretch);
  return shapes;
}
} // namespace

DemesShapes run_arc(const ProcedureDescription& procedure,
                    const std::vector<double>& times,
                    DemesComparison& comparison)
{
  const Units units(comparison.equivalent);
  const Signal& voltage = comparison.equivalent.device.source;
  const lumped::Demes demes = comparison.equivalent.make_arc();
  DemesModel& model = comparison.arc;
  model.name = "arc";
  find_states(
      voltage, procedure,
      [&](const double at) { return find_arc_rest(units, demes, at); }, model);
  lumped::DemesRunOptions options;
  options.start_time = units.make_tau(procedure.start_time);
  options.end_time = units.make_tau(procedure.end_time);
  options.output_times = units.make_tau(times);
  options.start = make_start(model.rest);
  const auto run = lumped::run_demes(demes, options);
  for (const lumped::DemesEvent& event : run.events)
  {
    const double time = event.row.time * demes.time_unit;
    comparison.arc_events.push_back({time, voltage.value(time),
                                     "loss of tension along 1", "film",
                                     event.at_start});
  }
  for (const std::string& note : run.notes)
    comparison.notes.push_back("arc: " + note);
  return make_shapes(units, times, run.rows,
                     [](const lumped::DemesRow& row) { return row.angle; });
}

DemesShapes run_elastica(const ProcedureDescription& procedure,
                         const std::vector<double>& times,
                         DemesComparison& comparison)
{
  const Units units(comparison.equivalent);
  const auto elastica = comparison.equivalent.make_elastica();
  DemesModel& model = comparison.elastica;
  model.name = "elastica";
  find_states(
      comparison.equivalent.device.source, procedure,
      [&](const double at) { return find_elastica_rest(units, elastica, at); },
      model);
  lumped::ElasticaRunOptions options;
  options.start_time = units.make_tau(procedure.start_time);
  options.end_time = units.make_tau(procedure.end_time);
  options.output_times = units.make_tau(times);
  options.start = make_start(model.rest);
  try
  {
    return make_shapes(units, times, lumped::run_elastica(elastica, options),
                       [](const lumped::ElasticaRow& row)
                       { return row.shape.end_angle; });
  }
  catch (const SolverFailed& failure)
  {
    // Its frame without inertia may snap; the other models go on.
    comparison.notes.push_back(std::string("elastica, no run in time: ") +
                               failure.what());
    return {};
  }
}
} // namespace taut::study
