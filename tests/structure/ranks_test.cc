// The same device on all ranks together and on each alone: equilibrium,
// energies and a short motion.
#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "structure/statics.h"

namespace taut
{
namespace
{
/// Two films with networks, hanging nodes, an electrode, pressure, weight, an
/// edge load and a bar.
std::unique_ptr<testing::Model> make_resonator(const MPI_Comm communicator)
{
  structure::Device device;
  auto film = testing::make_film(material::Gent{2e4, 60}, 1e-3, {{1.5, 1.6}});
  film.material.networks = {{material::NeoHookean{1e4}, .01}};
  film.groups = {"left"};
  device.films.push_back(film);
  film.name = "second";
  film.groups = {"right"};
  film.material.springs = {material::MooneyRivlin{1e4, 3e3}};
  device.films.push_back(film);
  device.electrodes = {
      testing::make_electrode("left", Signal::sine(2500, 1000, 20, 0))};
  device.supports = {testing::make_support("west", {{true, true, true}}),
                     testing::make_support("east", {{true, true, true}})};
  device.pressures = {testing::make_pressure("film", Signal::constant(10))};
  device.bars = {testing::make_bar("middle", 1e-2)};
  device.environment.air_drag = 100;
  device.environment.gravity = {{0, 3, -9.81}};
  structure::EdgeLoad load;
  load.name = "pull";
  load.groups = {"north", "middle"};
  load.direction = {{0, 1, .2}};
  load.force = Signal::constant(3);
  device.edge_loads = {load};
  return std::make_unique<testing::Model>(
      device, testing::make_rectangle(4, 4, 2, .06, .04), 0,
      [](fe::Triangulation& triangulation)
      { testing::refine_corner(triangulation, .06, .04); },
      communicator);
}

using Positions = std::map<std::array<long, 3>, std::array<double, 3>>;

/// Positions of this rank's own film nodes by their place in the mesh.
Positions get_positions(structure::Structure& structure,
                        const structure::LoadState& loads, const double* u)
{
  const auto& x = structure.compute_positions(loads, u);
  const auto& nodes = structure.nodes();
  Positions positions;
  for (fe::LocalNode node = 0; node < nodes.n_owned; ++node)
  {
    bool is_bar = false;
    for (const auto& bar : nodes.bars)
      is_bar = is_bar || node == bar.centre || node == bar.director;
    if (is_bar)
      continue;
    std::array<long, 3> key;
    std::array<double, 3> value;
    for (unsigned int c = 0; c < 3; ++c)
    {
      key[c] = std::lround(nodes.mesh_position[node][c] * 1e9);
      value[c] = fe::entry(x, 3 * node + c);
    }
    positions[key] = value;
  }
  return positions;
}

/// What a device does on a communicator.
struct Motion
{
  explicit Motion(const MPI_Comm communicator)
      : model(make_resonator(communicator)), system(*model->structure)
  {
    state = system.make_initial_state(0, structure::Start::unrelaxed, true, {});
    record(0);
    time::IntegratorOptions options;
    options.position_tolerance = 1e-7;
    time::Schedule schedule;
    schedule.end = .02;
    integrate(system, state.data(), schedule, options, {}, {});
    record(schedule.end);
  }
  void record(const double time)
  {
    energies.push_back(system.compute_energies(time, state.data()));
    positions.push_back(get_positions(*model->structure,
                                      system.history().at(time), state.data()));
  }

  std::unique_ptr<testing::Model> model;
  structure::InertialSystem system;
  std::vector<double> state;
  /// At the start and at the end.
  std::vector<structure::Energies> energies;
  std::vector<Positions> positions;
};

TEST(Ranks, alone_and_together_do_the_same)
{
  Motion together(MPI_COMM_WORLD), alone(MPI_COMM_SELF);
  // Sums in another order; the steps are the same.
  constexpr double tolerance = 1e-10;
  for (const unsigned int i : {0, 1})
  {
    const auto& a = together.energies[i];
    const auto& b = alone.energies[i];
    EXPECT_NEAR(a.stored, b.stored, tolerance * b.stored);
    EXPECT_NEAR(a.electric, b.electric, tolerance * b.stored);
    EXPECT_NEAR(a.kinetic, b.kinetic, tolerance * b.stored);
    for (const auto& [place, x] : together.positions[i])
    {
      const auto other = alone.positions[i].find(place);
      ASSERT_NE(other, alone.positions[i].end());
      for (unsigned int c = 0; c < 3; ++c)
        EXPECT_NEAR(x[c], other->second[c], tolerance * .06);
    }
  }
  EXPECT_GT(alone.energies[1].kinetic, 1e-6 * alone.energies[1].stored);
}
} // namespace
} // namespace taut
