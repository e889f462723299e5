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
/// Lee's frame: two legs of length 120 with a rigid corner, both ends hinged,
/// and a dead load along the column at 24 from the corner. E = 720, A = 6,
/// I = 2, nu = 0.3, shear factor 1.
std::unique_ptr<Model> make_lee(const unsigned int n)
{
  structure::Device device;
  constexpr double E = 720, A = 6, I = 2, G = E / 2.6;
  auto frame =
      make_frame("column", make_stiffnesses(E * A, G * A, G * I, E * I, E * I));
  frame.groups = {"column", "inner", "outer"};
  frame.normal = {{0, 1, 0}};
  device.frames = {frame};
  auto plane = make_support("column", {{false, true, false}});
  plane.groups = frame.groups;
  plane.held_rotations = {{true, false, true}};
  device.supports = {plane, make_support("foot", {{true, true, true}}),
                     make_support("wall", {{true, true, true}})};
  device.point_loads = {make_point_load("place", {0, 0, -1})};
  device.point_loads[0].force = make_slope(1);
  auto mesh = make_line_mesh();
  const auto column =
      add_line(mesh, "column", 5 * n, make_straight({0, 0, 0}, {0, 0, 120}));
  const auto inner =
      add_line(mesh, "inner", n, make_straight({0, 0, 120}, {24, 0, 120}));
  const auto outer = add_line(mesh, "outer", 4 * n,
                              make_straight({24, 0, 120}, {120, 0, 120}));
  name_point(mesh, column[0], "foot");
  name_point(mesh, inner[1], "place");
  name_point(mesh, outer[1], "wall");
  fe::add_empty_surface(mesh);
  return std::make_unique<Model>(device, mesh);
}

TEST(Continuation, LeesFrameSnapsAtTheReferenceLoads)
{
  const auto model = make_lee(12);
  Path path(*model->structure);
  const auto statistics = path.follow(0, 2);
  EXPECT_EQ(statistics.end, time::CurveEnd::reached);
  const auto limits = path.select(Kind::limit);
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_NEAR(limits[0].parameter / 1.85465587, 1, 1e-6);
  EXPECT_NEAR(limits[1].parameter / -.93961424, 1, 1e-6);
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
} // namespace
} // namespace taut::testing
