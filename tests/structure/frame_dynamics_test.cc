#include <gtest/gtest.h>

#include <cmath>

#include "structure/balance.h"
#include "structure/frames.h"
#include <boost/math/constants/constants.hpp>

// Motion of geometrically exact beams.
namespace taut::testing
{
namespace
{
constexpr double pi = boost::math::constants::pi<double>();

double compute_balance(structure::StructureSystem& system, const double time,
                       const double* state)
{
  const auto s = get_scalars(system, state);
  return system.compute_energies(time, state).total() +
         s[structure::Scalar::lost] - s[structure::Scalar::work];
}

/// Two legs of length 10 at a right angle, clamped at the end of the first; a
/// force out of their plane acts on the elbow, rises to 50 at t = 1 and is gone
/// at t = 2 (Simo and Vu-Quoc 1988).
structure::Device make_right_angle_device()
{
  structure::Device device;
  auto section = make_stiffnesses(1e6, 1e6, 1e3, 1e3, 1e3);
  section.mass_per_length = 1;
  section.rotary_inertia = {{20, 10, 10}};
  device.frames = {make_frame("frame", section)};
  device.supports = {make_clamp("root")};
  device.point_loads = {make_point_load("elbow", {0, 0, 1})};
  device.point_loads[0].force = Signal::table({0, 1, 2}, {0, 50, 0});
  return device;
}

fe::MeshData make_right_angle_mesh(const unsigned int n)
{
  auto mesh = make_line_mesh();
  const auto first =
      add_line(mesh, "frame", n, make_straight({0, 0, 0}, {10, 0, 0}));
  const auto second =
      add_line(mesh, "frame", n, make_straight({10, 0, 0}, {10, 10, 0}));
  name_point(mesh, first[0], "root");
  name_point(mesh, first[1], "elbow");
  name_point(mesh, second[1], "tip");
  fe::add_empty_surface(mesh);
  return mesh;
}

TEST(RightAngleCantilever, MovesAsPublishedAndKeepsItsEnergy)
{
  Model model(make_right_angle_device(), make_right_angle_mesh(5));
  structure::InertialSystem system(*model.structure);
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, false, {});
  time::IntegratorOptions options;
  options.position_tolerance = 1e-4;
  options.velocity_time = 1;
  options.first_step = 1e-3;
  time::Schedule schedule;
  schedule.end = 15;
  // Read off the published curve, which is good to 1 to 2 %.
  const std::array<std::array<double, 2>, 5> published{{{{3.04, 3.67}},
                                                        {{4.57, 6.37}},
                                                        {{6.58, 8.32}},
                                                        {{10.33, 1.15}},
                                                        {{14.43, -9.21}}}};
  for (const auto& [time, position] : published)
    schedule.output_times.push_back(time);
  double energy = 0, drift = 0, balance = 0;
  time::Observer observer;
  std::size_t row = 0;
  observer.output = [&](const double time, const double* y)
  {
    if (row == published.size() ||
        std::abs(time - published[row][0]) > 1e-9)
      return;
    const double z = get_frame_position(*model.structure,
                                        system.history().at(time), y,
                                        "elbow")[2];
    std::cerr << time << " " << z << " tip " << get_frame_position(*model.structure,
                                        system.history().at(time), y,
                                        "tip")[2] << "\n";
    EXPECT_NEAR(z, published[row++][1], .02 * 9.21);
  };
  observer.step = [&](const time::Step& step, const time::IntegratorStatistics& st)
  {
    balance = std::max(balance, std::abs(compute_balance(
                                    system, step.end(), step.state())));
    if (step.end() < 2)
      return;
    const double now =
        system.compute_energies(step.end(), step.state()).total();
    if (energy == 0)
      energy = now;
    drift = std::max(drift, std::abs(now - energy));
    if (step.end() > 14.99) std::cerr << st.steps << " " << st.factorisations << "\n";
  };
  integrate(system, state.data(), schedule, options, {}, observer);
  EXPECT_EQ(row, published.size());
  std::cerr << energy << " " << drift << " " << balance << "\n";
  EXPECT_LT(drift, 1e-4 * energy);
  EXPECT_LT(balance, 1e-4 * energy);
}
} // namespace
} // namespace taut::testing
