#include <gtest/gtest.h>

#include <cmath>

#include "structure/frame_motion.h"

// The right-angle cantilever of Simo and Vu-Quoc (1988): two legs of length 10,
// clamped at the end of the first; a force out of their plane acts on the
// elbow, rises to 50 at t = 1 and is gone at t = 2.
namespace taut::testing
{
namespace
{
structure::Device make_right_angle_device(const double peak)
{
  structure::Device device;
  auto section = make_stiffnesses(1e6, 1e6, 1e3, 1e3, 1e3);
  section.mass_per_length = 1;
  section.rotary_inertia = {{20, 10, 10}};
  device.frames = {make_frame("frame", section)};
  device.supports = {make_clamp("root")};
  device.point_loads = {make_point_load("elbow", {0, 0, 1})};
  device.point_loads[0].force = Signal::table({0, 1, 2}, {0, peak, 0});
  return device;
}

fe::MeshData make_right_angle_mesh()
{
  auto mesh = make_line_mesh();
  const auto first =
      add_line(mesh, "frame", 5, make_straight({0, 0, 0}, {10, 0, 0}));
  const auto second =
      add_line(mesh, "frame", 5, make_straight({10, 0, 0}, {10, 10, 0}));
  name_point(mesh, first[0], "root");
  name_point(mesh, first[1], "elbow");
  name_point(mesh, second[1], "tip");
  fe::add_empty_surface(mesh);
  return mesh;
}

struct Row
{
  double time;
  const char* group;
  double z;
};

/// Compares the height of points at times with `rows`, in order of time;
/// returns the largest changes of the energy after the load and of the balance,
/// over the energy.
std::array<double, 2> run(const double peak, const double tolerance,
                          const std::vector<Row>& rows, const double accuracy)
{
  Model model(make_right_angle_device(peak), make_right_angle_mesh());
  structure::InertialSystem system(*model.structure);
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, false, {});
  time::Schedule schedule;
  schedule.end = 15;
  for (const auto& row : rows)
    if (schedule.output_times.empty() ||
        row.time > schedule.output_times.back())
      schedule.output_times.push_back(row.time);
  std::size_t next = 0;
  time::Observer observer;
  observer.output = [&](const double time, const double* y)
  {
    for (; next < rows.size() && rows[next].time < time + 1e-9; ++next)
      EXPECT_NEAR(get_frame_position(*model.structure,
                                     system.history().at(time), y,
                                     rows[next].group)[2],
                  rows[next].z, accuracy)
          << rows[next].group << " at " << time;
  };
  double energy = 0, drift = 0, balance = 0;
  observer.step = [&](const time::Step& step, const auto&)
  {
    balance = std::max(
        balance, std::abs(compute_balance(system, step.end(), step.state())));
    if (step.end() < 2)
      return;
    const double now =
        system.compute_energies(step.end(), step.state()).total();
    if (energy == 0)
      energy = now;
    drift = std::max(drift, std::abs(now - energy));
  };
  integrate(system, state.data(), schedule, make_motion_options(tolerance), {},
            observer);
  EXPECT_EQ(next, rows.size());
  return {drift / energy, balance / energy};
}

TEST(RightAngleCantilever, MovesAsPublishedAndKeepsItsEnergy)
{
  // The figures of the publication, as digitised for the tests of AeroBeams.jl:
  // 4 % of the amplitude, 9.7.
  const auto [drift, balance] = run(50, 1e-6,
                                    {{3.0479, "elbow", 5.5035},
                                     {5.7128, "elbow", 2.5742},
                                     {6.5982, "tip", 7.8164},
                                     {7.6655, "tip", 8.2947},
                                     {8.1480, "elbow", 1.4557},
                                     {9.6302, "tip", 5.6705},
                                     {10.310, "elbow", -3.6585},
                                     {10.819, "elbow", -3.8714},
                                     {12.150, "tip", -4.0660},
                                     {13.694, "elbow", 1.1610},
                                     {14.643, "tip", -8.6171}},
                                    .04 * 9.7);
  EXPECT_LT(drift, 1e-4);
  EXPECT_LT(balance, 1e-4);
}

TEST(RightAngleCantilever, MovesAsALinearFrameUnderSmallLoads)
{
  // A linear Timoshenko frame of 60 two-node elements, consistent mass,
  // Newmark's average acceleration with steps of .02.
  const auto [drift, balance] = run(.05, 1e-8,
                                    {{3.04, "elbow", .0061854},
                                     {6.58, "elbow", .0026464},
                                     {6.58, "tip", .0075344},
                                     {14.44, "tip", -.0117319}},
                                    2e-3 * .0117);
  EXPECT_LT(drift, 1e-4);
  EXPECT_LT(balance, 1e-4);
}
} // namespace
} // namespace taut::testing
