// Snap-through in time, watched by the speed of a probe.
#include <taut/base/exceptions.h>
#include <taut/structure/watches.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/frames.h"
#include "structure/watch_refusal.h"

namespace taut::testing::snap
{
namespace
{
constexpr double height = .05;
constexpr double load_rate = 5; ///< (N/s)

/// A shallow arch of half a sine, pinned at both ends, pushed down at its top.
fe::MeshData make_arch_mesh()
{
  auto mesh = make_line_mesh();
  const auto curve = [](const double s) {
    return fe::Coordinates{s, 0, height * std::sin(M_PI * s)};
  };
  const auto ends = add_line(mesh, "arch", 8, curve);
  name_point(mesh, ends[0], "left");
  name_point(mesh, ends[1], "right");
  name_point(mesh, 4, "top");
  fe::add_empty_surface(mesh);
  return mesh;
}

structure::Device make_arch()
{
  structure::Device device;
  auto section = make_stiffnesses(1e4, 1e4, 1, 1, 1);
  section.mass_per_length = .01;
  section.rotary_inertia = {1e-6, 1e-6, 1e-6};
  device.frames = {make_frame("arch", section)};
  // So much that it does not swing on the other side.
  device.frames[0].mass_damping = 400;
  device.supports = {make_support("left", {{true, true, true}}),
                     make_support("right", {{true, true, true}}),
                     make_support("arch", {{false, true, false}})};
  for (auto& support : device.supports)
    support.held_rotations = {{true, false, true}};
  device.point_loads = {make_point_load("top", {0, 0, -1})};
  device.point_loads[0].force = Signal::ramp(load_rate, 0, 1e9);
  structure::Probe probe;
  probe.name = "top";
  probe.kind = structure::Probe::Kind::displacement;
  probe.of = "top";
  probe.component = 2;
  device.probes = {probe};
  probe.name = "speed";
  probe.kind = structure::Probe::Kind::velocity;
  device.probes.push_back(probe);
  structure::EventDescription event;
  event.name = "snap";
  event.kind = structure::EventDescription::Kind::snap_through;
  event.of = "top";
  event.threshold = .2;
  device.events = {event};
  return device;
}

/// The load at which the top of the arch has no equilibrium nearby any more.
double find_limit_load()
{
  auto device = make_arch();
  device.events.clear();
  device.probes.clear();
  const Model model(device, make_arch_mesh());
  structure::LoadHistory history(model.structure->device());
  history.enter_interval(0);
  structure::Equilibrium problem(*model.structure, history,
                                 structure::Networks::as_given, nullptr);
  std::vector<double> u(model.structure->n_free(), 0.);
  time::PathOptions options;
  options.first_step = options.largest_step = .2;
  options.smallest_step = 1e-4;
  options.newton.max_step = .01;
  double reached = 0;
  EXPECT_THROW(follow_path(problem, 0, 100, u.data(), options,
                           [&](const double load, const double*)
                           { reached = load; }),
               SolverFailed);
  return reached * load_rate;
}

struct Course
{
  explicit Course(const double end)
  {
    const Model model(make_arch(), make_arch_mesh());
    structure::InertialSystem system(*model.structure);
    structure::Probes probes(system);
    structure::Watches watches(system, probes);
    auto state =
        system.make_initial_state(0, structure::Start::relaxed, true, {});
    time::Observer observer;
    observer.event = [&](const time::Event& event, const double* y)
    {
      times.push_back(event.time);
      reports.push_back(watches.report(0, event.time, y));
      tops.push_back(probes.evaluate(event.time, y)[0]);
    };
    observer.step =
        [&](const time::Step& step, const time::IntegratorStatistics&)
    {
      const auto values = probes.evaluate(step.end(), step.state());
      largest_error = std::max(
          largest_error,
          std::abs(1 - std::abs(values[1]) / .2 -
                   watches.compute_margin(0, step.end(), step.state())));
      last_top = values[0];
    };
    time::Schedule schedule;
    schedule.end = end;
    time::IntegratorOptions options;
    options.position_tolerance = 1e-6;
    integrate(system, state.data(), schedule, options,
              watches.make_time_watches(), observer);
  }
  std::vector<double> times, tops;
  std::vector<structure::EventReport> reports;
  double largest_error = 0, last_top = 0;
};

TEST(SnapThrough, OfAnArchIsReportedOnceBeyondItsLimitLoad)
{
  const double limit = find_limit_load();
  const Course run(1.1 * limit / load_rate);
  // The probe's rate is its velocity, differences to 1e-10 of it.
  EXPECT_LT(run.largest_error, 1e-7);
  ASSERT_EQ(run.times.size(), 1u);
  EXPECT_GT(run.times[0] * load_rate, .99 * limit);
  EXPECT_LT(run.times[0] * load_rate, 1.05 * limit);
  EXPECT_NEAR(run.reports[0].value, .2, 1e-6);
  EXPECT_EQ(run.reports[0].place, "top");
  // Still on its way down, then on the other side.
  EXPECT_GT(run.tops[0], -1.2 * height);
  EXPECT_LT(run.last_top, -2 * height);
}

std::string get_refusal(const structure::Device& device, const bool inertia)
{
  const Model model(device, make_arch_mesh());
  structure::InertialSystem inertial(*model.structure);
  auto without = device;
  without.probes.resize(1);
  const Model other(without, make_arch_mesh());
  structure::QuasiStaticSystem quasi_static(*other.structure, {});
  structure::StructureSystem& system =
      inertia ? static_cast<structure::StructureSystem&>(inertial)
              : quasi_static;
  return get_watch_refusal(system);
}

TEST(SnapThrough, RefusesWhatCannotBeWatched)
{
  auto device = make_arch();
  expect_contains(get_refusal(device, false), "without inertia");
  device.events[0].threshold = 0;
  expect_contains(get_refusal(device, true), "above 0");
  device.events[0].threshold = .2;
  device.events[0].of = "tip";
  expect_contains(get_refusal(device, true), "did you mean 'top'");
  device.events[0].kind = structure::EventDescription::Kind::probe_above;
  expect_contains(get_refusal(device, true), "there is no probe 'tip'");
}
} // namespace
} // namespace taut::testing::snap
