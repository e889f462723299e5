#include <taut/time/continuation.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/patchwork.h"
#include "structure/paths.h"

// Static paths through limit points against references of 1e-8 or better that
// were derived with independent codes; the same on one and two ranks.
namespace taut::testing
{
namespace
{
TEST(Continuation, LeesFrameSnapsAtTheReferenceLoads)
{
  const auto model = make_lee(4);
  Path path(*model->structure);
  const auto statistics = path.follow(0, 2);
  EXPECT_EQ(statistics.end, time::CurveEnd::reached);
  const auto limits = path.select(Kind::limit);
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_NEAR(limits[0].parameter / 1.85465587, 1, 1e-4);
  EXPECT_NEAR(limits[1].parameter / -.93961424, 1, 1e-4);
  // Unstable between its limit points only.
  double last = 0;
  for (const auto& point : path.points)
    if (point.kind == Kind::regular)
    {
      const bool between = point.arc_length > limits[0].arc_length &&
                           point.arc_length < limits[1].arc_length;
      EXPECT_EQ(point.negative_eigenvalues, between ? 1 : 0) << point.parameter;
      EXPECT_GT(point.arc_length, last - 1e-12);
      last = point.arc_length;
    }
  // Where the device snaps to.
  const auto landings = path.select(Kind::landing);
  ASSERT_EQ(landings.size(), 1u);
  EXPECT_NEAR(landings[0].parameter, limits[0].parameter, 1e-12);
}

/// An eighth of a closed neo-Hookean sphere; modulus, radius and thickness are
/// 1, so that p = 2 (l^-1 - l^-7).
std::unique_ptr<Model> make_sphere(const unsigned int n)
{
  structure::Device device;
  device.films = {make_film(material::NeoHookean{1}, 1, {{1, 1}})};
  device.films[0].axis = {{.3, .5, -.8}};
  device.supports = {make_support("x0", {{true, false, false}}),
                     make_support("y0", {{false, true, false}}),
                     make_support("z0", {{false, false, true}})};
  device.pressures = {make_pressure("film", make_slope(1))};
  return std::make_unique<Model>(device, make_octant(n));
}

TEST(Continuation, ABalloonHasItsLargestPressureAtTheReference)
{
  const auto model = make_sphere(2);
  Path path(*model->structure);
  path.options.most_points = 40;
  // From below: Newton starts where a little gas holds the shape.
  path.follow(.25, 2);
  const auto limits = path.select(Kind::limit);
  ASSERT_GE(limits.size(), 1u);
  // Meshed with the order 4 of Q2; test of the path, not of the mesh.
  EXPECT_NEAR(limits[0].parameter, 1.2394629024, 1e-3);
}
/// A clamped sheet of stretched film with fibres, partly moved.
double compute_film_energy(const std::array<double, 2>& pre_stretch,
                           const double share, std::vector<double>& forces)
{
  structure::Device device;
  device.films = {make_film(material::NeoHookean{3e4}, 1e-3, pre_stretch)};
  device.films[0].tension_field = false;
  device.films[0].fibre_modulus = 1e4;
  device.films[0].axis = {{1, .3, 0}};
  device.films[0].pre_stretch_share = Signal::constant(share);
  device.supports = {make_support("west", {{true, true, true}})};
  const Model model(device, make_bent_sheet(2));
  auto& structure = *model.structure;
  structure::LoadHistory history(device);
  std::vector<double> u(structure.n_free()), internal;
  for (std::size_t i = 0; i < u.size(); ++i)
  {
    const unsigned int entry = structure.free_unknowns()[i];
    const auto& X = structure.nodes().mesh_position[entry / 3];
    u[i] = .1 * X[0] * (entry % 3 + X[1] / .03);
  }
  forces.resize(u.size());
  structure.compute_forces(history.at(0), u.data(), internal.data(),
                           structure::Networks::relaxed, forces.data(),
                           nullptr);
  return structure
      .compute_energies(history.at(0), u.data(), nullptr, internal.data())
      .stored;
}

TEST(Continuation, AShareOfThePreStretchIsALowerPreStretch)
{
  std::vector<double> shared, lower;
  const double energy = compute_film_energy({{3, 1.4}}, .25, shared);
  const double expected = compute_film_energy({{1.5, 1.1}}, 1, lower);
  EXPECT_NEAR(energy / expected, 1, 1e-13);
  ASSERT_EQ(shared.size(), lower.size());
  double largest = 0;
  for (const double force : lower)
    largest = std::max(largest, std::abs(force));
  for (std::size_t i = 0; i < lower.size(); ++i)
    EXPECT_NEAR(shared[i], lower[i], 1e-12 * largest);
}
} // namespace
} // namespace taut::testing
