#include <taut/base/exceptions.h>
#include <taut/lumped/demes_statics.h>
#include <taut/study/lumped_case.h>
#include <taut/study/lumped_case_demes.h>
#include <taut/study/modes.h>
#include <taut/study/run_demes.h>
#include <taut/study/run_resonator.h>
#include <taut/time/damped_modes.h>

#include <algorithm>
#include <cmath>

namespace taut::study
{
namespace
{
/// Squares of the angular frequency (1/s^2): of fast motions, and what each
/// relaxation takes from it if it follows.
struct LumpedStiffness
{
  double frozen = 0;
  std::vector<double> parts;

  double relaxed() const
  {
    double square = frozen;
    for (const double part : parts)
      square -= part;
    return square;
  }
};

/// Fills in what follows from time, relaxations, mass and stiffness.
void complete(const ModesDescription& description,
              const LumpedStiffness& stiffness, const double modal_mass,
              ModesReport& report)
{
  time::DampedVibration vibration{1, {stiffness.frozen}, {0.}, {}};
  for (std::size_t m = 0; m < stiffness.parts.size(); ++m)
    vibration.parts.push_back(
        {{stiffness.parts[m]}, report.relaxations[m].time});
  const auto rate = time::find_damped_rate(vibration, {1.});
  ModesReport::Mode mode;
  mode.square = description.networks == ModesDescription::Networks::frozen
                    ? stiffness.frozen
                    : stiffness.relaxed();
  mode.growth_rate = rate.real();
  mode.damped_angular_frequency = rate.imag();
  mode.damping_ratio = std::abs(rate) > 0 ? -rate.real() / std::abs(rate) : 0.;
  mode.modal_mass = modal_mass;
  for (const ModesRelaxation& relaxation : report.relaxations)
    mode.products.push_back(std::sqrt(std::max(0., mode.square)) *
                            relaxation.time);
  report.modes = {mode};
  report.lowest_frozen = stiffness.frozen;
  report.lowest_relaxed = stiffness.relaxed();
  report.unstable_frozen = stiffness.frozen < 0;
  report.unstable_relaxed = stiffness.relaxed() < 0;
  report.stable = report.unstable_relaxed == 0;
}

template <class Row>
const Row& get_row(const ModesDescription& description,
                   const std::vector<Row>& rows)
{
  return description.at == ModesDescription::At::start ? rows.front()
                                                       : rows.back();
}

/// Omega_n^2 (3.29) next to the balance of a row, without some networks.
double compute_square(lumped::Resonator resonator,
                      const lumped::ResonatorRow& row, const double stretch,
                      const std::vector<bool>& counts)
{
  std::vector<lumped::ResonatorNetwork> networks;
  std::vector<double> internal;
  for (std::size_t m = 0; m < counts.size(); ++m)
    if (counts[m])
    {
      networks.push_back(resonator.networks[m]);
      internal.insert(internal.end(), row.internal.begin() + 4 * m,
                      row.internal.begin() + 4 * (m + 1));
    }
  resonator.networks = networks;
  lumped::FrozenResonator frozen(resonator);
  frozen.freeze(internal.data());
  return resonator.get_alpha() *
         frozen.compute_frequency_squared(stretch, row.voltage);
}

ModesReport find_modes(const ModesDescription& description,
                       const LumpedResonatorDescription& device,
                       const lumped::ResonatorRow& row)
{
  const lumped::ResonatorSI si = make_resonator_si(device);
  const auto resonator = lumped::make_resonator(si);
  lumped::FrozenResonator frozen(resonator);
  frozen.freeze(row.internal.data());
  const double stretch = frozen.find_balance(row.voltage, row.stretch_1a);
  ModesReport report;
  report.time = row.time;
  report.moved = device.length_active * std::abs(stretch - row.stretch_1a);
  std::vector<bool> counts(resonator.networks.size(), true);
  LumpedStiffness stiffness;
  stiffness.frozen = compute_square(resonator, row, stretch, counts);
  for (std::size_t m = 0; m < counts.size(); ++m)
  {
    report.relaxations.push_back({"network " + std::to_string(m + 1),
                                  resonator.networks[m].relaxation_time});
    counts[m] = false;
    stiffness.parts.push_back(stiffness.frozen -
                              compute_square(resonator, row, stretch, counts));
    counts[m] = true;
  }
  // 1/alpha counts masses as m L_1A/(G L_2 L_3).
  const double mass = lumped::make_scales(si).force_1 /
                      (device.length_active * resonator.get_alpha());
  complete(description, stiffness, mass, report);
  return report;
}

lumped::DemesEquilibrium find_nearest(const lumped::Demes& demes,
                                      const lumped::DemesRow& row)
{
  const auto equilibria = lumped::find_equilibria(demes, row.drive);
  if (equilibria.empty())
    throw SolverFailed("no vibration modes: the DEMES has no equilibrium at "
                       "the source of the state");
  return *std::min_element(equilibria.begin(), equilibria.end(),
                           [&](const auto& a, const auto& b) {
                             return std::abs(a.angle - row.angle) <
                                    std::abs(b.angle - row.angle);
                           });
}

ModesReport find_modes(const ModesDescription& description,
                       const LumpedDemesDescription& device,
                       const lumped::DemesRow& row)
{
  const lumped::DemesSI si = make_demes_si(device);
  const lumped::Demes demes = lumped::make_demes(si);
  const auto scales = lumped::make_scales(si);
  const auto equilibrium = find_nearest(demes, row);
  const double unit = std::pow(scales.angular_frequency, 2);
  ModesReport report;
  report.time = scales.time * row.time;
  report.mass_unit = "kg m^2";
  report.moved =
      device.film_length * std::abs(equilibrium.stretch - row.stretch);
  LumpedStiffness stiffness;
  const auto& squares = equilibrium.frequencies;
  stiffness.frozen = unit * squares.instantaneous_squared;
  if (demes.viscous_ratio > 0)
  {
    // (23) about xi = lambda: d(xi)/dt = -(4 beta/(S lambda^2)) d(xi).
    report.relaxations.push_back(
        {"network 1", scales.time * demes.relaxation *
                          std::pow(equilibrium.stretch, 2) /
                          (4 * demes.viscous_ratio)});
    stiffness.parts.push_back(
        unit * (squares.instantaneous_squared - squares.relaxed_squared));
  }
  complete(description, stiffness, device.inertia, report);
  return report;
}
} // namespace

RunSummary run_lumped_modes(const Case& run_case, RunOutput& output)
{
  const ModesDescription& description = run_case.modes;
  if (description.near_frequency > 0)
    throw BadInput("a lumped model has one mode: Modes/Near frequency is for "
                   "films and frames");
  const auto visit =
      [&](const auto& device, const auto& run, RunSummary& summary)
  {
    if (summary.status == Status::completed ||
        description.at == ModesDescription::At::start)
      summary.modes =
          find_modes(description, device, get_row(description, run.rows));
    else
      summary.notes.push_back("no vibration modes: the run ended before it "
                              "came to the state");
  };
  if (run_case.model == "demes")
    return visit_demes(run_case, output,
                       [&](const lumped::DemesRun& run, RunSummary& summary)
                       { visit(run_case.lumped_demes, run, summary); });
  return visit_resonator(
      run_case, output,
      [&](const lumped::ResonatorRun& run, RunSummary& summary)
      { visit(run_case.lumped_resonator, run, summary); });
}
} // namespace taut::study
