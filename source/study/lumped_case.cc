#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/lumped/resonator_critical.h>
#include <taut/lumped/resonator_statics.h>
#include <taut/study/lumped_case.h>

#include <cmath>
#include <limits>

namespace taut::study
{
namespace
{
using lumped::ResonatorFailure;
using lumped::ResonatorPlace;

/// g_m of every network; equal ones if the description lists none.
std::vector<double> make_shares(const LumpedResonatorDescription& device)
{
  if (!device.network_shares.empty() || device.relaxation_times.empty())
    return device.network_shares;
  const std::size_t n = device.relaxation_times.size();
  return std::vector<double>(n, (1 - device.equilibrium_share) / double(n));
}

lumped::ResonatorStart get_start(const ProcedureDescription& procedure)
{
  return procedure.start == structure::Start::relaxed
             ? lumped::ResonatorStart::relaxed
             : lumped::ResonatorStart::unrelaxed;
}

double get_hertz(const double angular_frequency)
{
  return angular_frequency / (2 * std::acos(-1.));
}

/// At which the voltage rises at the start (V/s).
double get_ramp_rate(const LumpedResonatorDescription& device,
                     const ProcedureDescription& procedure)
{
  const double rate = device.voltage.rate(procedure.start_time);
  if (!(rate > 0))
    throw BadInput("a hold time needs a voltage that rises at the start, and "
                   "its rate there is " +
                   number_text(rate) + " V/s");
  return rate;
}

std::string get_place(const ResonatorPlace place)
{
  switch (place)
  {
  case ResonatorPlace::a:
    return "active";
  case ResonatorPlace::b:
    return "passive";
  case ResonatorPlace::a_and_b:
    break;
  }
  return "active + passive";
}

/// The quantity that fell through its threshold: a nominal stress (Pa), or the
/// true field (V/m).
double get_event_value(const ResonatorFailure failure,
                       const ResonatorPlace place, const LumpedRow& row)
{
  if (failure == ResonatorFailure::breakdown)
    return row.true_field;
  const bool passive = place == ResonatorPlace::b;
  if (failure == ResonatorFailure::loss_of_tension_2)
    return passive ? row.nominal_stress_2_passive : row.nominal_stress_2_active;
  return row.nominal_stress_1_passive;
}
} // namespace

lumped::ResonatorSI make_resonator_si(const LumpedResonatorDescription& device)
{
  lumped::ResonatorSI resonator;
  resonator.length_a = device.length_active;
  resonator.length_b = device.length_passive;
  resonator.width = device.width;
  resonator.thickness = device.thickness;
  resonator.equilibrium_modulus =
      device.equilibrium_share * device.shear_modulus;
  for (const double share : make_shares(device))
    resonator.network_moduli.push_back(share * device.shear_modulus);
  resonator.network_taus = device.relaxation_times;
  resonator.tau_meaning = device.relaxation_is_rate
                              ? lumped::TauMeaning::rate
                              : lumped::TauMeaning::relaxation_time;
  resonator.gent_limit = device.limit;
  resonator.density = device.density;
  resonator.bar_mass = device.bar_mass;
  resonator.relative_permittivity = device.relative_permittivity;
  resonator.breakdown_field = device.breakdown_strength;
  resonator.pre_stretch_1 = device.pre_stretch[0];
  resonator.pre_stretch_2 = device.pre_stretch[1];
  resonator.voltage = device.voltage;
  return resonator;
}

lumped::ResonatorRun run_lumped(const LumpedResonatorDescription& device,
                                const ProcedureDescription& procedure,
                                const std::vector<double>& output_times)
{
  if (procedure.analysis != structure::Analysis::equilibrium &&
      procedure.analysis != structure::Analysis::quasi_static &&
      procedure.analysis != structure::Analysis::transient)
    throw BadInput("the lumped resonator has the analyses 'equilibrium', "
                   "'quasi-static', 'transient' and 'frequency response' only");
  if (device.hold_time > 0)
    get_ramp_rate(device, procedure);
  const auto resonator = lumped::make_resonator(make_resonator_si(device));
  lumped::ResonatorRunOptions options;
  options.start_time = procedure.start_time;
  options.end_time = procedure.end_time;
  options.output_times = output_times;
  options.start = get_start(procedure);
  if (procedure.analysis == structure::Analysis::equilibrium)
    return lumped::run_static(resonator, options);
  return procedure.analysis == structure::Analysis::transient
             ? lumped::run_inertial(resonator, options)
             : lumped::run_quasi_static(resonator, options);
}

std::map<std::string, double>
find_hold_limit(const LumpedResonatorDescription& device,
                const ProcedureDescription& procedure)
{
  const auto si = make_resonator_si(device);
  const auto resonator = lumped::make_resonator(si);
  const auto scales = lumped::make_scales(si);
  lumped::ResonatorRamp ramp;
  ramp.rate = get_ramp_rate(device, procedure) / scales.voltage;
  ramp.start = get_start(procedure);
  const double limit =
      lumped::find_hold_limit(resonator, ramp, device.hold_time);
  const double frequency =
      lumped::find_relaxed_state(resonator, limit).frequency;
  return {{"hold limit", scales.voltage * limit},
          {"natural frequency at hold limit",
           get_hertz(scales.angular_frequency * frequency)}};
}

LumpedRow make_lumped_row(const LumpedResonatorDescription& device,
                          const lumped::ResonatorRow& row)
{
  return make_lumped_row(device, lumped::make_scales(make_resonator_si(device)),
                         row);
}

LumpedRow make_lumped_row(const LumpedResonatorDescription& device,
                          const lumped::ResonatorScales& scales,
                          const lumped::ResonatorRow& row)
{
  LumpedRow si;
  si.time = row.time;
  si.voltage = scales.voltage * row.voltage;
  si.stretch_active = row.stretch_1a;
  si.stretch_passive = row.stretch_1b;
  si.bar_displacement =
      device.length_active * (row.stretch_1a - device.pre_stretch[0]);
  si.bar_velocity = device.length_active * row.velocity;
  si.nominal_stress_1_active = scales.stress * row.stress_1a;
  si.nominal_stress_1_passive = scales.stress * row.stress_1b;
  si.nominal_stress_2_active = scales.stress * row.stress_2a;
  si.nominal_stress_2_passive = scales.stress * row.stress_2b;
  si.charge = scales.charge * row.charge;
  si.natural_frequency = get_hertz(scales.angular_frequency * row.frequency);
  si.true_field =
      si.voltage / device.thickness * row.stretch_1a * device.pre_stretch[1];
  si.breakdown_margin = device.breakdown_strength - si.true_field;
  si.kinetic_energy = scales.energy * row.kinetic_energy;
  si.free_energy = scales.energy * row.free_energy;
  si.dissipated_energy = scales.energy * row.dissipated_energy;
  si.voltage_work = scales.energy * row.voltage_work;
  return si;
}

const std::vector<LumpedColumn>& get_lumped_columns()
{
  using R = LumpedRow;
  static const std::vector<LumpedColumn> columns = {
      {{"time", "s"}, &R::time},
      {{"voltage", "V"}, &R::voltage},
      {{"stretch active", "1"}, &R::stretch_active},
      {{"stretch passive", "1"}, &R::stretch_passive},
      {{"bar displacement", "m"}, &R::bar_displacement},
      {{"bar velocity", "m/s"}, &R::bar_velocity},
      {{"nominal stress 1 active", "Pa"}, &R::nominal_stress_1_active},
      {{"nominal stress 1 passive", "Pa"}, &R::nominal_stress_1_passive},
      {{"nominal stress 2 active", "Pa"}, &R::nominal_stress_2_active},
      {{"nominal stress 2 passive", "Pa"}, &R::nominal_stress_2_passive},
      {{"charge", "C"}, &R::charge},
      {{"natural frequency", "Hz"}, &R::natural_frequency},
      {{"true field", "V/m"}, &R::true_field},
      {{"breakdown margin", "V/m"}, &R::breakdown_margin},
      {{"kinetic energy", "J"}, &R::kinetic_energy},
      {{"free energy", "J"}, &R::free_energy},
      {{"dissipated energy", "J"}, &R::dissipated_energy},
      {{"voltage work", "J"}, &R::voltage_work}};
  return columns;
}

EventRecord make_event_record(const LumpedResonatorDescription& device,
                              const lumped::ResonatorEvent& event)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const LumpedRow row = make_lumped_row(device, event.row);
  EventRecord record;
  record.time = row.time;
  record.name = lumped::to_text(event.failure);
  record.place = get_place(event.place);
  record.point = {nan, nan, nan};
  record.direction = {nan, nan, nan};
  record.value = get_event_value(event.failure, event.place, row);
  record.at_start = event.at_start;
  record.fatal = !event.at_start;
  if (event.failure == ResonatorFailure::breakdown)
  {
    record.kind = "breakdown";
    record.threshold = device.breakdown_strength;
    record.margin = 1 - record.value / record.threshold;
    return record;
  }
  record.kind = "tension_loss";
  record.margin = record.value / device.shear_modulus;
  if (event.failure == ResonatorFailure::loss_of_tension_1)
    record.direction = {1, 0, 0};
  else
    record.direction = {0, 1, 0};
  return record;
}
} // namespace taut::study
