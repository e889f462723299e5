// Films behind a real source: series resistance and leakage.
#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <cmath>

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
  return 16 * (.04 * .03 / 4) * 2e4 * device.films[0].thickness / (unit * unit);
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
  integrate(system, state.data(), schedule, options, {}, observer);
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
    expected.push_back(t < .01  ? 0
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
    // The tolerance is 1e-8 of the charge at the field 1, which is 22 kV here,
    // per step: some 1e-3 V.
    for (std::size_t i = 0; i < times.size(); ++i)
      EXPECT_NEAR(voltages[i + 1], expected[i], 5e-3) << times[i];
  }
}

TEST(Circuit, LeaksSlowlyAndStartsAtRest)
{
  // The source hardly counts: the film discharges through itself.
  auto device = make_clamped(Signal::steps({0, 1}, {3000, 0}));
  const double C = compute_capacitance(device);
  auto& circuit = device.electrodes[0];
  circuit.series_resistance = 1e9 / C;
  circuit.leakage_resistance = 500 / C;
  testing::Model model(device, make_sheet());
  structure::QuasiStaticSystem system(*model.structure, {});
  const auto voltages = run(system, {1, 100, 600, 2000});
  const double rest = 3000 / (1 + 1e9 / 500);
  EXPECT_NEAR(voltages[0], rest, 1e-9);
  EXPECT_NEAR(voltages[1], rest, 1e-9);
  const double tau = 1 / (1 / 500. + 1e-9);
  for (const auto& [i, t] : {std::pair<int, double>{2, 99}, {3, 599}})
    EXPECT_NEAR(voltages[i], rest * std::exp(-t / tau), 5e-3);
}

/// A bowl with networks and air drag. Left: a circuit whose source jumps, with
/// time constants of 2 and 40 ms; right: a charge that jumps or a voltage.
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
  device.electrodes = {
      testing::make_electrode("left",
                              Signal::steps({0, .004, .02}, {1000, 4000, 500})),
      testing::make_electrode("right", Signal::sine(2500, 1500, 40, .3))};
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

TEST(Circuit, BalanceOfAMotionConvergesWithTheTolerance)
{
  // The charge on the right jumps: work at once; the source on the left jumps:
  // none.
  testing::Model model(make_bowl_device(Control::charge), make_bowl());
  structure::InertialSystem system(*model.structure);
  const auto compute = [&](const double tolerance)
  {
    time::IntegratorOptions options;
    options.position_tolerance = options.global_tolerance = tolerance;
    options.velocity_time = 5e-3;
    return testing::compute_drift(system, .03, options);
  };
  const double coarse = compute(1e-6), fine = compute(1e-8);
  // As with prescribed voltages, see the test of the energy balance.
  EXPECT_LT(fine, 1e-5);
  EXPECT_LT(fine, coarse / 20) << coarse << " " << fine;
}

TEST(Circuit, BalanceHoldsWithoutInertia)
{
  testing::Model model(make_bowl_device(Control::charge), make_bowl());
  structure::QuasiStaticSystem system(*model.structure, {});
  auto options = testing::make_slow_options(1e-8);
  options.global_tolerance = 1e-8;
  EXPECT_LT(testing::compute_drift(system, .03, options), 1e-5);
}

/// The end of a motion of 10 ms.
std::vector<double> move(testing::Model& model)
{
  structure::InertialSystem system(*model.structure);
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  time::IntegratorOptions options;
  options.position_tolerance = options.global_tolerance = 1e-9;
  options.velocity_time = 5e-3;
  time::Schedule schedule;
  schedule.end = .01;
  integrate(system, state.data(), schedule, options, {}, {});
  state.resize(model.structure->n_free());
  return state;
}

TEST(Circuit, WithoutResistanceEqualsPrescribedVoltage)
{
  auto device = make_bowl_device(Control::voltage);
  device.electrodes[0].voltage = Signal::sine(2500, 1500, 60, 1);
  // A time constant of 1e-9 s: the lag turns the phase by 4e-7.
  device.electrodes[0].series_resistance = 10;
  testing::Model circuit(device, make_bowl());
  const auto with = move(circuit);
  device.electrodes[0].control = Control::voltage;
  testing::Model held(device, make_bowl());
  const auto without = move(held);
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < with.size(); ++i)
  {
    difference = std::max(difference, std::abs(with[i] - without[i]));
    size = std::max(size, std::abs(with[i]));
  }
  using dealii::Utilities::MPI::max;
  // Both take steps of their own, with 1e-9 m of error in each: 2e-7 m after
  // all of them, and a sixth of it at a tenth of the tolerance.
  EXPECT_LT(max(difference, MPI_COMM_WORLD), 1e-6);
  EXPECT_GT(max(size, MPI_COMM_WORLD), 5e-3);
}

TEST(Circuit, AloneAndTogetherDoTheSame)
{
  std::vector<double> stored, charges;
  for (const MPI_Comm communicator : {MPI_COMM_WORLD, MPI_COMM_SELF})
  {
    testing::Model model(make_bowl_device(Control::charge), make_bowl(), 0, {},
                         communicator);
    structure::InertialSystem system(*model.structure);
    auto state =
        system.make_initial_state(0, structure::Start::unrelaxed, true, {});
    time::IntegratorOptions options;
    options.position_tolerance = 1e-7;
    time::Schedule schedule;
    schedule.end = .012;
    integrate(system, state.data(), schedule, options, {}, {});
    charges.push_back(system.get_charges(state.data())[0]);
    stored.push_back(system.compute_energies(.012, state.data()).stored);
  }
  // Sums in another order; the steps are the same.
  EXPECT_NEAR(charges[0], charges[1], 1e-9 * charges[1]);
  EXPECT_NEAR(stored[0], stored[1], 1e-9 * stored[1]);
}

TEST(Circuit, ARunGoesOnFromACheckpoint)
{
  testing::Model model(make_bowl_device(Control::charge), make_bowl());
  constexpr double middle = .006, end = .012;
  time::IntegratorOptions options;
  options.position_tolerance = 1e-7;
  time::Schedule schedule;
  schedule.end = end;
  schedule.restart_times = {middle};
  structure::InertialSystem system(*model.structure);
  auto whole =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  std::vector<double> checkpoint;
  time::Observer observer;
  observer.checkpoint = [&](double, const double* state)
  { checkpoint.assign(state, state + whole.size()); };
  integrate(system, whole.data(), schedule, options, {}, observer);
  ASSERT_EQ(checkpoint.size(), whole.size());
  // A structure of its own, which has seen no voltage before.
  testing::Model other(make_bowl_device(Control::charge), make_bowl());
  structure::InertialSystem resumed(*other.structure);
  resumed.history().enter_interval(middle);
  schedule.start = middle;
  schedule.restart_times.clear();
  integrate(resumed, checkpoint.data(), schedule, options, {}, {});
  // Round-off: two ranks sum in an order of their own in every run, which moves
  // positions far less than the tolerance.
  for (std::size_t i = 0; i < model.structure->n_free(); ++i)
    EXPECT_NEAR(checkpoint[i], whole[i], 1e-10);
  const double charge = system.get_charges(whole.data())[0];
  EXPECT_GT(charge, 0);
  EXPECT_NEAR(resumed.get_charges(checkpoint.data())[0], charge, 1e-9 * charge);
}

TEST(Circuit, SolveInvertsTheSystemWithInertia)
{
  auto device = make_bowl_device(Control::charge);
  device.films[0].material.networks.clear();
  testing::Model model(device, make_bowl());
  structure::InertialSystem system(*model.structure);
  const auto y =
      system.make_initial_state(.005, structure::Start::unrelaxed, true, {});
  const std::size_t size = y.size();
  const std::size_t end = size - system.layout().scalars;
  // Of the size of the rates and of what they do in 1/alpha.
  constexpr double alpha = 300;
  std::vector<double> r(size, 0.);
  for (std::size_t i = 0; i < end; ++i)
    r[i] =
        std::sin(double(3 * i)) * (i < model.structure->n_free()       ? 1e-3
                                   : i < 2 * model.structure->n_free() ? 1e-4
                                                                       : 10.);
  std::vector<double> d(size), b(size), plus(size), minus(size), moved(y);
  system.prepare(.005, y.data(), alpha);
  system.solve(r.data(), d.data());
  constexpr double h = 1e-3;
  for (std::size_t i = 0; i < size; ++i)
    moved[i] = y[i] + h * d[i];
  system.evaluate(.005, moved.data(), plus.data());
  for (std::size_t i = 0; i < size; ++i)
    moved[i] = y[i] - h * d[i];
  system.evaluate(.005, moved.data(), minus.data());
  system.multiply_mass(d.data(), b.data());
  // Positions, velocities and the charge are of different sizes.
  std::array<double, 3> defect{}, largest{};
  for (std::size_t i = 0; i < end; ++i)
  {
    const std::size_t block =
        std::min<std::size_t>(i / model.structure->n_free(), 2);
    const double left = alpha * b[i] - (plus[i] - minus[i]) / (2 * h);
    defect[block] = std::max(defect[block], std::abs(left - r[i]));
    largest[block] = std::max(largest[block], std::abs(r[i]));
  }
  for (const unsigned int block : {0, 1, 2})
    EXPECT_LE(defect[block], 1e-8 * largest[block]) << block;
}
} // namespace
} // namespace taut
