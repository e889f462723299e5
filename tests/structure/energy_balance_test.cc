// The balance of energy, total + dissipated + lost - work = constant, in runs
// with everything that brings energy in or takes it out.
#include <taut/structure/point_fields.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <utility>

#include "structure/balance.h"
#include "structure/viscous_films.h"

namespace taut
{
namespace
{
/// A bowl with two networks, air drag, gravity, pressure, an electrode with an
/// alternating voltage, an edge load and a support that moves by `motion`. It
/// carries compression: a slack film without inertia has no definite shape.
structure::Device make_busy_device(const Signal& motion)
{
  structure::Device device;
  device.films = {
      testing::make_film(material::Gent{2e4, 60}, 1e-3, {{1.6, 1.4}})};
  device.films[0].material.networks = {{material::NeoHookean{1e4}, .004},
                                       {material::NeoHookean{5e3}, .1}};
  device.films[0].tension_field = false;
  device.electrodes = {
      testing::make_electrode("left", Signal::sine(2000, 1500, 40, .3))};
  device.supports = {testing::make_support("west", {{true, true, true}}),
                     testing::make_support("east", {{true, true, true}},
                                           {{".004", ".1*(y - .02)", "-.002"}},
                                           motion)};
  structure::Pressure pressure;
  pressure.name = "below";
  pressure.groups = {"film"};
  pressure.pressure = Signal::sine(10, 10, 25, 0);
  device.pressures = {pressure};
  structure::EdgeLoad load;
  load.name = "pull";
  load.groups = {"north"};
  load.direction = {{0, 1, .3}};
  load.force = Signal::ramp(200, 0, 8);
  device.edge_loads = {load};
  device.environment.gravity = {{0, 0, -9.81}};
  device.environment.air_drag = 2000;
  return device;
}

fe::MeshData make_bowl()
{
  return testing::make_grid(
      3, 3, 2,
      [](const double xi, const double eta) {
        return fe::Coordinates{.05 * xi, .04 * eta, .01 * xi * (1 - xi)};
      });
}

class Balance : public ::testing::TestWithParam<Signal>
{
};

TEST_P(Balance, of_a_motion_converges_with_the_tolerance)
{
  testing::Model model(make_busy_device(GetParam()), make_bowl());
  structure::InertialSystem system(*model.structure);
  const auto compute = [&](const double tolerance)
  {
    time::IntegratorOptions options;
    options.position_tolerance = tolerance;
    options.velocity_time = 5e-3;
    return testing::compute_drift(system, .03, options);
  };
  const double coarse = compute(1e-6), fine = compute(1e-8);
  // Of fourth order the drift falls as tolerance^(4/4) at best, as its 3/4
  // where stiff networks and modes reduce the order: 100^(3/4) = 32.
  EXPECT_LT(fine, 1e-4);
  EXPECT_LT(fine, coarse / 20) << coarse << " " << fine;
}

INSTANTIATE_TEST_SUITE_P(motions, Balance,
                         ::testing::Values(Signal::sine(0, 1, 30, 0),
                                           Signal::table({0, .01, .02, .03},
                                                         {0, .7, -.2, .1})));

/// The shares of the points that are wrinkled and slack.
std::array<double, 2> count_wrinkles(structure::StructureSystem& system,
                                     const double time, const double* state)
{
  std::array<double, 2> share{};
  const auto fields = structure::compute_point_fields(
      system.structure(), system.history().at(time), state,
      system.internal(state));
  for (const auto& point : fields)
  {
    share[0] += point.tension == structure::Tension::wrinkled;
    share[1] += point.tension == structure::Tension::slack;
  }
  return {share[0] / fields.size(), share[1] / fields.size()};
}

TEST(Balance, OfAFilmThatGoesSlackConvergesWithTheTolerance)
{
  auto device =
      make_busy_device(Signal::table({0, .01, .02, .03}, {0, -4, -6, -1}));
  device.films[0].tension_field = true;
  testing::Model model(device, make_bowl());
  structure::InertialSystem system(*model.structure);
  double most_slack = 0;
  const auto watch = [&](const double time, const double* state)
  {
    const auto share = count_wrinkles(system, time, state);
    most_slack = std::max(most_slack, share[1]);
  };
  const auto compute = [&](const double tolerance)
  {
    time::IntegratorOptions options;
    options.position_tolerance = tolerance;
    options.velocity_time = 5e-3;
    return testing::compute_drift(system, .03, options, watch);
  };
  const double coarse = compute(1e-6), fine = compute(1e-8);
  EXPECT_GT(most_slack, .05);
  // The stiffness jumps where the film wrinkles, which leaves less of the
  // order.
  EXPECT_LT(fine, 1e-4);
  EXPECT_LT(fine, coarse / 5) << coarse << " " << fine;
}

TEST(QuasiStaticBalance, holds_without_pressure)
{
  auto device = make_busy_device(Signal::sine(0, 1, 5, 0));
  device.pressures.clear();
  testing::Model model(device, make_bowl());
  structure::QuasiStaticSystem system(*model.structure, {});
  EXPECT_LT(
      testing::compute_drift(system, .2, testing::make_slow_options(1e-8)),
      1e-5);
}

TEST(QuasiStaticBalance, holds_under_pressure_with_a_fixed_rim)
{
  auto device = make_busy_device(Signal());
  device.edge_loads.clear();
  for (const char* side : {"south", "north"})
    device.supports.push_back(
        testing::make_support(side, {{true, true, true}}));
  testing::Model model(device, make_bowl());
  structure::QuasiStaticSystem system(*model.structure, {});
  EXPECT_LT(
      testing::compute_drift(system, .2, testing::make_slow_options(1e-8)),
      1e-5);
}

TEST(Dissipation, IsNeverNegativeInARandomCycle)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> times{0}, values{0};
  for (unsigned int i = 1; i <= 12; ++i)
  {
    times.push_back(.02 * i);
    values.push_back(uniform(generator));
  }
  testing::Model model(make_busy_device(Signal::table(times, values)),
                       make_bowl());
  structure::QuasiStaticSystem system(*model.structure, {});
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  double least = 1, largest = 0;
  time::Observer observer;
  observer.step = [&](const time::Step& step, const auto&)
  {
    std::vector<double> f(state.size());
    system.evaluate(step.end(), step.state(), f.data());
    const double power =
        system.scalars(std::as_const(f).data())[structure::Scalar::dissipated];
    least = std::min(least, power);
    largest = std::max(largest, power);
  };
  time::Schedule schedule;
  schedule.end = times.back();
  integrate(system, state.data(), schedule, testing::make_slow_options(1e-6),
            {}, observer);
  EXPECT_GT(largest, 0);
  EXPECT_GE(least, 0);
}
} // namespace
} // namespace taut
