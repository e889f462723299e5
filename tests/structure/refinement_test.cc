// Adaptive refinement follows the solution.
#include <taut/structure/refinement.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/devices.h"

namespace taut
{
namespace
{
using structure::Structure;

/// A pre-stretched square film, clamped in the west and pulled by a dead load
/// in the east: the field is singular in the corners of the clamped edge.
structure::Device make_device()
{
  structure::Device device;
  device.mesh.degree = 2;
  device.films = {
      testing::make_film(material::NeoHookean{2e4}, 1e-3, {{1.2, 1.2}})};
  // Newton's method finds its way more easily while corners carry compression.
  device.films[0].tension_field = false;
  device.supports = {testing::make_support("west", {{true, true, true}})};
  structure::EdgeLoad load;
  load.name = "pull";
  load.groups = {"east"};
  load.direction = {1, 0, 0};
  load.force = Signal::constant(20);
  device.edge_loads = {load};
  device.supports.push_back(
      testing::make_support("film", {{false, false, true}}));
  return device;
}

/// Solves and gives the energy (J); keeps the solution in `u`.
double solve(Structure& structure, std::vector<double>& u)
{
  structure::QuasiStaticSystem system(structure, {});
  u = system.make_initial_state(0, structure::Start::relaxed, true, {});
  return system.compute_energies(0, u.data()).total();
}

TEST(Refinement, beats_uniform_refinement_at_equal_unknowns)
{
  const auto mesh = testing::make_rectangle(4, 4, 2, .02, .02);
  const auto device = make_device();
  std::vector<double> u;
  testing::Model fine(device, mesh, 4);
  const double reference = solve(*fine.structure, u);
  testing::Model uniform(device, mesh, 2);
  const double uniform_error = solve(*uniform.structure, u) - reference;

  fe::Triangulation triangulation(MPI_COMM_WORLD);
  fe::create_triangulation(mesh, 0, triangulation);
  auto adapted = std::make_unique<Structure>(device, mesh, triangulation);
  double adapted_error = solve(*adapted, u) - reference;
  const structure::LoadHistory history(device);
  for (unsigned int i = 0; i < 5; ++i)
  {
    structure::refine_worst_cells(*adapted, u.data(), history.at(0), 0.15,
                                  triangulation);
    adapted = std::make_unique<Structure>(device, mesh, triangulation);
    const double error = solve(*adapted, u) - reference;
    // Nested spaces: the minimum of the energy can only fall.
    EXPECT_LT(error, adapted_error);
    adapted_error = error;
  }
  EXPECT_LT(adapted->n_free_global(), uniform.structure->n_free_global());
  EXPECT_LT(adapted_error, uniform_error);
}
} // namespace
} // namespace taut
