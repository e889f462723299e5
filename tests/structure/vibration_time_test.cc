// A device that leaves an equilibrium along a mode swings as the mode says.
#include <gtest/gtest.h>

#include <cmath>

#include "structure/frame_motion.h"
#include "structure/vibrations.h"
#include <boost/math/constants/constants.hpp>

namespace taut
{
namespace
{
constexpr double quarter_turn = boost::math::constants::half_pi<double>();
/// Largest velocity of a mode over its frequency, so its displacement; of the
/// square of it is what the mode leaves out.
constexpr double amplitude = 1e-5;

/// Starts with the velocity of each mode and looks at it a quarter of a period
/// later: its displacement is largest and its velocity gone.
void expect_quarter_periods(const structure::Device& device,
                            const fe::MeshData& mesh, const unsigned int count)
{
  testing::Model model(device, mesh);
  structure::InertialSystem system(*model.structure);
  time::PathOptions path;
  path.newton.tolerance = 1e-13;
  const auto rest =
      system.make_initial_state(0, structure::Start::relaxed, true, path);
  structure::Vibration vibration(*model.structure,
                                 system.loads_at(0, rest.data()), rest.data(),
                                 system.internal(rest.data()));
  time::ModeOptions modes_wanted;
  modes_wanted.count = count;
  const auto modes = time::find_modes(vibration, modes_wanted).modes;
  ASSERT_EQ(modes.size(), count);
  const std::size_t n = model.structure->n_free();
  std::vector<double> inertia(n), displacement(n);
  for (const auto& mode : modes)
  {
    const double omega = std::sqrt(mode.square);
    const double size =
        amplitude /
        vibration.compute_largest(vibration.compute_motion(mode.shape.data()));
    auto state = rest;
    for (std::size_t i = 0; i < n; ++i)
      state[n + i] = size * omega * mode.shape[i];
    time::Schedule schedule;
    schedule.end = quarter_turn / omega;
    auto options = testing::make_motion_options(1e-6 * amplitude);
    options.velocity_time = 1 / omega;
    options.first_step = .01 / omega;
    time::integrate(system, state.data(), schedule, options, {}, {});
    for (std::size_t i = 0; i < n; ++i)
      displacement[i] = state[i] - rest[i];
    vibration.multiply_mass(mode.shape.data(), inertia.data());
    const double tolerance = 1e-4;
    EXPECT_NEAR(vibration.multiply(displacement.data(), inertia.data()) / size,
                1, tolerance)
        << "at " << omega << " rad/s";
    EXPECT_NEAR(vibration.multiply(state.data() + n, inertia.data()) /
                    (size * omega),
                0, tolerance)
        << "at " << omega << " rad/s";
    vibration.multiply_mass(displacement.data(), inertia.data());
    // Nothing went into other motions.
    EXPECT_NEAR(vibration.multiply(displacement.data(), inertia.data()) / size /
                    size,
                1, tolerance);
  }
}

TEST(ModeInTime, FilmWithABarThatTurns)
{
  structure::Device device;
  device.mesh.degree = 2;
  device.films = {
      testing::make_film(material::NeoHookean{1}, .1, {{1.6, 1.2}})};
  device.films[0].material.density = 1;
  device.films[0].tension_field = false;
  // Nothing relaxes while these swing.
  device.films[0].material.networks = {{material::NeoHookean{1}, 1e9}};
  device.electrodes = {testing::make_electrode(
      "left", Signal::constant(testing::make_voltage(device.films[0], .1, 2)))};
  device.supports = {testing::make_support("west", {{true, true, true}}),
                     testing::make_support("east", {{true, true, true}})};
  device.bars = {testing::make_bar("middle", .2)};
  expect_quarter_periods(device, testing::make_rectangle(4, 2, 1, 2, 1), 6);
}

TEST(ModeInTime, BentBeamWithATipMass)
{
  structure::Device device;
  auto section = testing::make_stiffnesses(1e4, 1e4, 1, 1, 2);
  section.mass_per_length = 1;
  section.rotary_inertia = {{3e-3, 1e-3, 2e-3}};
  device.frames = {testing::make_frame("beam", section)};
  device.supports = {testing::make_clamp("root")};
  device.point_loads = {testing::make_point_load("tip", {0, .3, 1})};
  device.point_loads[0].force = Signal::constant(1.5);
  structure::PointMass mass;
  mass.name = "tip";
  mass.groups = {"tip"};
  mass.mass = .5;
  mass.rotary_inertia = {{.05, .02, .01}};
  device.masses = {mass};
  auto mesh = testing::make_line_mesh();
  const auto ends = testing::add_line(
      mesh, "beam", 4, testing::make_straight({0, 0, 0}, {1, 0, 0}));
  testing::name_point(mesh, ends[0], "root");
  testing::name_point(mesh, ends[1], "tip");
  fe::add_empty_surface(mesh);
  expect_quarter_periods(device, mesh, 4);
}
} // namespace
} // namespace taut
