// Pull-in of films that creep or swing, against closed forms of homogeneous
// neo-Hookean films. Units: modulus, thickness and square are 1.
#include <gtest/gtest.h>

#include <cmath>

#include "structure/pull_in.h"
#include "structure/viscous_films.h"

namespace taut::pull_in_in_time
{
namespace
{
using testing::find_root;
using testing::make_pull_in;

/// A Zener film, tau = 1, total modulus 1, half of it elastic.
structure::Device make_zener(const double field)
{
  auto device = testing::make_sheet(
      {{material::NeoHookean{.5}}, {{material::NeoHookean{.5}, 1}}, {}, 1}, {});
  device.electrodes = {testing::make_electrode(
      "film",
      Signal::constant(testing::make_voltage(device.films[0], field, 1)))};
  return device;
}

TEST(PullIn, CreepEndsAtTheReferenceTimes)
{
  struct Reference
  {
    double field, time;
  };
  for (const auto& [field, time] :
       {Reference{.6, 1.48996387}, Reference{.65, .42371682}})
  {
    auto device = make_zener(field);
    // The share vanishes as the root of the time that is left: of two
    // thresholds, one half the other, the times tell the end to their cube.
    device.events = {make_pull_in(.008), make_pull_in(.004)};
    device.events[0].fatal = false;
    testing::Model model(device, testing::make_sheet_mesh());
    structure::QuasiStaticSystem system(*model.structure, {});
    structure::Probes probes(system);
    structure::Watches watches(system, probes);
    auto state =
        system.make_initial_state(0, structure::Start::unrelaxed, true, {});
    std::vector<double> passages;
    time::Observer observer;
    observer.event = [&](const time::Event& event, const double*)
    { passages.push_back(event.time); };
    time::Schedule schedule;
    schedule.end = 1.1 * time;
    const auto result = integrate(system, state.data(), schedule,
                                  testing::make_slow_options(1e-9),
                                  watches.make_time_watches(), observer);
    EXPECT_EQ(result.outcome, time::Outcome::stopped_by_event);
    ASSERT_EQ(passages.size(), 2u);
    EXPECT_NEAR(passages[1] + (passages[1] - passages[0]) / 3, time,
                1e-5 * time);
  }
}

TEST(PullIn, StifferFilmCreepsToItsRelaxedStateWithoutIt)
{
  // chi = .8, Et = .5: l = 1.07812829.
  auto device = make_zener(.5);
  device.films[0].material.springs = {material::NeoHookean{.8}};
  device.films[0].material.networks = {{material::NeoHookean{.2}, 1}};
  device.events = {make_pull_in(.004)};
  testing::Model model(device, testing::make_sheet_mesh());
  structure::QuasiStaticSystem system(*model.structure, {});
  structure::Probes probes(system);
  structure::Watches watches(system, probes);
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  time::Schedule schedule;
  schedule.end = 40;
  const auto result = integrate(system, state.data(), schedule,
                                testing::make_slow_options(1e-8),
                                watches.make_time_watches(), {});
  EXPECT_EQ(result.outcome, time::Outcome::completed);
  EXPECT_NEAR(watches.report(0, 40, state.data()).value,
              1 - 3 * .25 * std::pow(1.07812829, 2) /
                      (.8 * (1 + 5 * std::pow(1.07812829, -6)) +
                       .2 * 6 / std::pow(1.07812829, 2)),
              1e-5);
}

/// One cell that swings evenly after a step of voltage.
struct Swing
{
  explicit Swing(const double e)
  {
    auto device =
        testing::make_sheet({{material::NeoHookean{1}}, {}, {}, 1}, {});
    device.mesh.degree = 1;
    device.films[0].tension_field = false;
    device.electrodes = {testing::make_electrode(
        "film", Signal::constant(
                    testing::make_voltage(device.films[0], std::sqrt(e), 1)))};
    device.events = {make_pull_in()};
    testing::Model model(device, testing::make_rectangle(1, 1, 1, 1, 1));
    structure::InertialSystem system(*model.structure);
    structure::Probes probes(system);
    structure::Watches watches(system, probes);
    auto state =
        system.make_initial_state(0, structure::Start::relaxed, false, {});
    const auto get_stretch = [&](const double* y)
    {
      const auto loads = system.history().at(0);
      // One rank has the cell.
      double stretch = 0;
      for (const auto& C :
           fe::compute_metric(model.structure->cells(),
                              model.structure->compute_positions(loads, y)))
        stretch = std::sqrt(C[0]);
      return dealii::Utilities::MPI::max(stretch, MPI_COMM_WORLD);
    };
    time::Observer observer;
    observer.event = [&](const time::Event&, const double* y)
    { event_stretch = get_stretch(y); };
    observer.step =
        [&](const time::Step& step, const time::IntegratorStatistics&)
    { largest_stretch = std::max(largest_stretch, get_stretch(step.state())); };
    time::Schedule schedule;
    schedule.end = 20;
    time::IntegratorOptions options;
    options.position_tolerance = 1e-8;
    integrate(system, state.data(), schedule, options,
              watches.make_time_watches(), observer);
  }
  double event_stretch = 0, largest_stretch = 0;
};

double compute_potential(const double l, const double e)
{
  return l * l + std::pow(l, -4) / 2 - e * std::pow(l, 4) / 2;
}

/// The unstable equilibrium.
double find_barrier(const double e)
{
  return find_root([=](const double l)
                   { return std::pow(l, -2) - std::pow(l, -8) - e; },
                   std::pow(4, 1. / 6), 3);
}

double find_inflection(const double e)
{
  return find_root([=](const double l)
                   { return 1 + 5 * std::pow(l, -6) - 3 * e * l * l; },
                   1, 3);
}

TEST(PullIn, OfASwingingFilmIsThePassageOfItsBarrier)
{
  // A step of voltage throws the film over its barrier from this field on.
  const double limit = find_root(
      [](const double e) {
        return compute_potential(1, e) - compute_potential(find_barrier(e), e);
      },
      .3, .47);
  const Swing beyond(1.02 * limit);
  EXPECT_NEAR(beyond.event_stretch, find_barrier(1.02 * limit), 1e-5);
  // It turns beyond the inflection, where the tangent is negative, and comes
  // back.
  const Swing below(.98 * limit);
  EXPECT_EQ(below.event_stretch, 0);
  EXPECT_GT(below.largest_stretch, 1.01 * find_inflection(.98 * limit));
  EXPECT_LT(below.largest_stretch, find_barrier(.98 * limit));
}

TEST(PullIn, WithoutABarrierItIsTheLossOfStiffness)
{
  const Swing swing(.6);
  EXPECT_NEAR(swing.event_stretch, find_inflection(.6), 1e-5);
}
} // namespace
} // namespace taut::pull_in_in_time
