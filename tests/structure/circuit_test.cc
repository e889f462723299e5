// Films behind a real source: series resistance and leakage.
#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "structure/balance.h"
#include "structure/viscous_films.h"

namespace taut
{
namespace
{
using Control = structure::Electrode::Control;

/// A clamped film of VHB size, 40 mm by 30 mm and 1 mm thick, stretched 2 by 2:
/// flat and uniform, it never moves.
structure::Device make_clamped(const Signal& source)
{
  structure::Device device;
  device.films = {
      testing::make_film(material::NeoHookean{2e4}, 1e-3, {{2, 2}})};
  device.electrodes = {testing::make_electrode("film", source)};
  device.electrodes[0].control = Control::circuit;
  for (const char* edge : {"west", "east", "south", "north"})
    device.supports.push_back(
        testing::make_support(edge, {{true, true, true}}));
  return device;
}

fe::MeshData make_sheet()
{
  return testing::make_rectangle(2, 2, 2, .04, .03);
}

double compute_capacitance(const structure::Device& device)
{
  const double unit = testing::make_voltage(device.films[0], 1, 2e4);
  return 16 * (.04 * .03 / 4) * 2e4 * device.films[0].thickness /
         (unit * unit);
}

/// The film's voltages at the times, by either system.
std::vector<double> run(structure::StructureSystem& system,
                        const std::vector<double>& times)
{
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  time::IntegratorOptions options;
  if (!system.has_inertia())
    options.method = time::Method::bdf;
  options.position_tolerance = 1e-9;
  options.global_tolerance = 1e-8;
  std::vector<double> voltages;
  time::Observer observer;
  observer.output = [&](const double time, const double* y)
  { voltages.push_back(system.loads_at(time, y).voltages[0]); };
  time::Schedule schedule;
  schedule.end = times.back();
  schedule.output_times = times;
  const auto result = integrate(system, state.data(), schedule, options, {}, observer);
  std::cerr << "steps " << result.statistics.steps << "\n";
  return voltages;
}

TEST(Circuit, ChargesAndLeaksAsTheClosedForm)
{
  // On at 0.01 s, off at 0.2 s.
  auto device = make_clamped(Signal::steps({0, .01, .2}, {0, 3000, 0}));
  const double C = compute_capacitance(device);
  auto& circuit = device.electrodes[0];
  circuit.series_resistance = .02 / C;
  circuit.leakage_resistance = .06 / C;
  testing::Model model(device, make_sheet());
  const double tau = .015, rest = 3000 * .75;
  std::vector<double> times, expected;
  for (unsigned int i = 0; i <= 40; ++i)
  {
    const double t = .01 * i + .005;
    times.push_back(t);
    const double off = rest * (1 - std::exp(-.19 / tau));
    expected.push_back(t < .01 ? 0
                       : t < .2 ? rest * (1 - std::exp(-(t - .01) / tau))
                                : off * std::exp(-(t - .2) / tau));
  }
  structure::InertialSystem inertial(*model.structure);
  structure::QuasiStaticSystem slow(*model.structure, {});
  for (structure::StructureSystem* system :
       std::initializer_list<structure::StructureSystem*>{&inertial, &slow})
  {
    const auto voltages = run(*system, times);
    ASSERT_EQ(voltages.size(), times.size() + 1);
    double worst = 0;
    for (std::size_t i = 0; i < times.size(); ++i)
      worst = std::max(worst, std::abs(voltages[i + 1] - expected[i]));
    std::cerr << "worst " << worst << "\n";
    EXPECT_LT(worst, 1e-5 * rest);
  }
}

/// A bowl with networks and air drag. Left: a circuit whose source jumps and
/// swings, with time constants of 2 and 40 ms; right: a charge that does.
structure::Device make_bowl_device(const Control right)
{
  structure::Device device;
  device.films = {
      testing::make_film(material::Gent{2e4, 60}, 1e-3, {{1.6, 1.4}})};
  device.films[0].material.networks = {{material::NeoHookean{1e4}, .004},
                                       {material::NeoHookean{5e3}, .1}};
  device.films[0].tension_field = false;
  device.supports = {testing::make_support("west", {{true, true, true}}),
                     testing::make_support("east", {{true, true, true}})};
  device.environment.air_drag = 2000;
  const Signal source = Signal::parse("sine(2500, 1500, 40, 0.3)");
  device.electrodes = {
      testing::make_electrode("left", Signal::steps({0, .004, .02}, {1000, 4000, 500})),
      testing::make_electrode("right", source)};
  device.electrodes[0].control = Control::circuit;
  // The capacitance of a half is about 1.1e-10 F.
  device.electrodes[0].series_resistance = 2e7;
  device.electrodes[0].leakage_resistance = 4e8;
  device.electrodes[1].control = right;
  device.electrodes[1].charge = Signal::steps({0, .01}, {1e-7, 3e-7});
  return device;
}

fe::MeshData make_bowl()
{
  return testing::make_grid(
      4, 3, 2,
      [](const double xi, const double eta) {
        return fe::Coordinates{.05 * xi, .04 * eta, .01 * xi * (1 - xi)};
      });
}

TEST(Circuit, balance)
{
  for (const Control right : {Control::voltage, Control::charge})
  for (const bool circuit : {true, false}) {
    auto device = make_bowl_device(right);
    if (!circuit) device.electrodes[0].control = Control::voltage;
    testing::Model model(device, make_bowl());
    structure::InertialSystem system(*model.structure);
    structure::QuasiStaticSystem slow(*model.structure, {});
    for (const double tolerance : {1e-6, 1e-8})
    {
      time::IntegratorOptions options;
      options.position_tolerance = tolerance;
      options.global_tolerance = tolerance;
      options.velocity_time = 5e-3;
      std::cerr << int(right) << circuit << " " << tolerance << " "
                << testing::compute_drift(system, .03, options);
      auto o2 = testing::make_slow_options(tolerance);
      o2.global_tolerance = tolerance;
      std::cerr << " slow " << testing::compute_drift(slow, .03, o2) << std::endl;
    }
  }
}
} // namespace
} // namespace taut
