#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/study/lumped_case_demes.h>

#include <limits>

namespace taut::study
{
namespace
{
lumped::PermittivityLaw make_permittivity(const LumpedDemesDescription& device)
{
  const auto& given = device.permittivity_coefficients;
  if (given.empty())
    return {};
  if (given.size() != 3)
    throw BadInput("the permittivity law has 3 coefficients or none, got " +
                   std::to_string(given.size()));
  return {given[0], given[1], given[2]};
}

} // namespace

lumped::DemesSI make_demes_si(const LumpedDemesDescription& device)
{
  lumped::DemesSI demes;
  demes.film_length = device.film_length;
  demes.film_width = device.film_width;
  demes.film_thickness = device.film_thickness;
  demes.pre_stretch = device.pre_stretch;
  demes.shear_modulus = device.shear_modulus;
  demes.viscous_ratio = device.viscous_ratio;
  demes.viscosity = device.viscosity;
  demes.frame_modulus = device.frame_modulus;
  demes.frame_width = device.frame_width;
  demes.frame_thickness = device.frame_thickness;
  demes.inertia = device.inertia;
  demes.film_offset = device.film_offset;
  demes.rest_angle = device.rest_angle;
  demes.relative_permittivity = device.relative_permittivity;
  demes.permittivity = make_permittivity(device);
  demes.laws = lumped::make_temperature_laws(device.temperature_laws);
  demes.temperature = device.temperature;
  demes.control = device.charge_controlled ? lumped::DemesControl::charge
                                           : lumped::DemesControl::voltage;
  demes.source = device.source;
  return demes;
}

/// Driven runs start where the frame rests before it is heated or driven.
lumped::DemesState make_start(const LumpedDemesDescription& device)
{
  lumped::DemesSI cold = make_demes_si(device);
  if (device.start == DemesStart::flat)
    return lumped::make_flat_start(lumped::make_demes(cold), device.seed_angle);
  cold.laws = {};
  return lumped::make_rest_start(lumped::make_demes(cold));
}

lumped::DemesRun run_lumped(const LumpedDemesDescription& device,
                            const ProcedureDescription& procedure,
                            const std::vector<double>& output_times)
{
  const bool at_rest = procedure.analysis == structure::Analysis::equilibrium;
  if (!at_rest && procedure.analysis != structure::Analysis::transient)
    throw BadInput("the lumped DEMES has the analyses 'equilibrium', "
                   "'transient' and 'frequency response' only");
  const lumped::Demes demes = lumped::make_demes(make_demes_si(device));
  lumped::DemesRunOptions options;
  options.start_time = procedure.start_time / demes.time_unit;
  options.end_time = procedure.end_time / demes.time_unit;
  for (const double time : output_times)
    options.output_times.push_back(time / demes.time_unit);
  options.tolerance = device.tolerance;
  if (at_rest)
    return lumped::run_rest_states(demes, options);
  options.start = make_start(device);
  return lumped::run_demes(demes, options);
}

LumpedDemesRow make_lumped_row(const LumpedDemesDescription& device,
                               const lumped::DemesRow& row)
{
  return make_lumped_row(device, lumped::make_scales(make_demes_si(device)),
                         row);
}

LumpedDemesRow make_lumped_row(const LumpedDemesDescription& device,
                               const lumped::DemesScales& scales,
                               const lumped::DemesRow& row)
{
  const bool charge = device.charge_controlled;
  LumpedDemesRow si;
  si.time = scales.time * row.time;
  si.voltage = scales.voltage * (charge ? row.conjugate : row.drive);
  si.charge = scales.charge * (charge ? row.drive : row.conjugate);
  si.angle = row.angle;
  si.angular_velocity = scales.angular_frequency * row.velocity;
  si.chord = device.film_length * row.stretch;
  si.stretch = row.stretch;
  si.inner_stretch = row.inner_stretch;
  si.film_force = scales.force * row.membrane_force;
  si.kinetic_energy = scales.energy * row.kinetic_energy;
  si.free_energy = scales.energy * row.free_energy;
  si.dissipated_energy = scales.energy * row.dissipated_energy;
  si.source_work = scales.energy * row.source_work;
  return si;
}

const std::vector<LumpedDemesColumn>& get_lumped_demes_columns()
{
  using R = LumpedDemesRow;
  static const std::vector<LumpedDemesColumn> columns = {
      {{"time", "s"}, &R::time},
      {{"voltage", "V"}, &R::voltage},
      {{"charge", "C"}, &R::charge},
      {{"angle", "rad"}, &R::angle},
      {{"angular velocity", "rad/s"}, &R::angular_velocity},
      {{"chord", "m"}, &R::chord},
      {{"stretch", "1"}, &R::stretch},
      {{"inner stretch", "1"}, &R::inner_stretch},
      {{"film force", "N"}, &R::film_force},
      {{"kinetic energy", "J"}, &R::kinetic_energy},
      {{"free energy", "J"}, &R::free_energy},
      {{"dissipated energy", "J"}, &R::dissipated_energy},
      {{"source work", "J"}, &R::source_work}};
  return columns;
}

EventRecord make_event_record(const LumpedDemesDescription& device,
                              const lumped::DemesEvent& event)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const LumpedDemesRow row = make_lumped_row(device, event.row);
  EventRecord record;
  record.time = row.time;
  record.name = "film pushes";
  record.kind = "tension_loss";
  record.place = "film";
  record.point = {nan, nan, nan};
  record.direction = {nan, nan, nan};
  record.value = row.film_force;
  record.margin = nan;
  record.at_start = event.at_start;
  return record;
}
} // namespace taut::study
