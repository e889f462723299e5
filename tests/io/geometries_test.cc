// The parametric geometries in meshes/.
#include <taut/io/gmsh_reader.h>

#include <gtest/gtest.h>
#include <io/mesh_measures.h>

#include <cmath>

namespace
{
using namespace taut;
using namespace taut::io;
using Parameters = std::map<std::string, double>;

constexpr double pi = 3.14159265358979323846;

fe::MeshData read(const std::string& geometry,
                  const Parameters& parameters = {})
{
  return io::read_mesh(std::string(TAUT_MESHES) + "/" + geometry, parameters);
}

TEST(Geometries, resonator_is_the_stretched_film)
{
  const auto mesh = read("resonator.geo", {{"length_passive", 30e-3}});
  // Twice the length, four times the width.
  const double active = 40e-3, passive = 60e-3, side = 80e-3, tiny = 1e-15;
  EXPECT_NEAR(compute_area(mesh, "active"), active * side, tiny);
  EXPECT_NEAR(compute_area(mesh, "passive"), passive * side, tiny);
  EXPECT_NEAR(sum_chords(mesh, "bar"), side, tiny);
  EXPECT_NEAR(sum_chords(mesh, "frame_active_end"), side, tiny);
  EXPECT_NEAR(sum_chords(mesh, "frame_passive_end"), side, tiny);
  EXPECT_NEAR(sum_chords(mesh, "frame_sides"), 2 * (active + passive), tiny);
  EXPECT_NEAR(sum_chords(mesh, "frame_sides_active"), 2 * active, tiny);
  EXPECT_NEAR(sum_chords(mesh, "frame_sides_passive"), 2 * passive, tiny);
  EXPECT_EQ(read("resonator.geo", {{"order", 2}}).order, 2u);
}

TEST(Geometries, sheet_has_four_edges_and_corners)
{
  const auto mesh = read("sheet.geo", {{"length", 3}, {"width", 2}});
  EXPECT_NEAR(compute_area(mesh, "film"), 6, 1e-13);
  for (const std::string edge : {"bottom", "top"})
    EXPECT_NEAR(sum_chords(mesh, edge), 3, 1e-14);
  for (const std::string edge : {"left", "right"})
    EXPECT_NEAR(sum_chords(mesh, edge), 2, 1e-14);
  EXPECT_EQ(fe::get_group_points(mesh, "top_right"),
            (std::vector<fe::Coordinates>{{3, 2, 0}}));
}

/// Quadratic edges miss the area of a smooth surface by the fourth power of
/// their length: halving them gains four bits.
void expect_fourth_order(const std::string& geometry, const Parameters& coarse,
                         const Parameters& fine, const double exact)
{
  const double coarse_error =
      exact - compute_area(read(geometry, coarse), "film");
  const double fine_error = exact - compute_area(read(geometry, fine), "film");
  EXPECT_NEAR(std::log2(coarse_error / fine_error), 4, .2);
}

TEST(Geometries, curved_areas_converge_with_order_four)
{
  expect_fourth_order(
      "circle.geo", {{"radius", 1}, {"cells_around", 1}, {"cells_radial", 1}},
      {{"radius", 1}, {"cells_around", 2}, {"cells_radial", 2}}, pi);
  expect_fourth_order("annulus.geo", {{"inner_radius", 1}, {"outer_radius", 2}},
                      {{"inner_radius", 1},
                       {"outer_radius", 2},
                       {"cells_around", 8},
                       {"cells_radial", 8}},
                      3 * pi);
  expect_fourth_order("balloon.geo", {{"radius", 1}, {"cells", 2}},
                      {{"radius", 1}, {"cells", 4}}, pi / 2);
}

TEST(Geometries, disc_has_a_vertex_in_its_centre)
{
  const auto mesh = read("circle.geo");
  double nearest = 1;
  for (const auto& vertex : mesh.vertices)
    nearest = std::min(nearest, to_point(vertex).norm());
  EXPECT_LT(nearest, 1e-15);
}

/// The smallest sine of an angle between two edges of a cell.
double find_sharpest_angle(const fe::MeshData& mesh)
{
  double smallest = 1;
  for (const fe::MeshQuad& quad : mesh.quads)
    for (unsigned int v = 0; v < 4; ++v)
    {
      const auto x = to_point(mesh.vertices[quad.vertices[v]]);
      const auto next = to_point(mesh.vertices[quad.vertices[(v + 1) % 4]]) - x;
      const auto last = to_point(mesh.vertices[quad.vertices[(v + 3) % 4]]) - x;
      smallest =
          std::min(smallest, dealii::cross_product_3d(next, last).norm() /
                                 (next.norm() * last.norm()));
    }
  return smallest;
}

/// All angles between 45 and 135 degrees.
TEST(Geometries, cells_of_curved_shapes_are_well_shaped)
{
  for (const std::string geometry :
       {"circle.geo", "annulus.geo", "balloon.geo"})
    EXPECT_GT(find_sharpest_angle(read(geometry)), std::sqrt(.5)) << geometry;
}

TEST(Geometries, balloon_is_an_eighth_of_a_sphere_with_normals_outwards)
{
  const auto mesh = read("balloon.geo", {{"radius", 2}, {"cells", 4}});
  double furthest = 0;
  for (const auto* coordinates : {&mesh.vertices, &mesh.middle_points})
    for (const auto& x : *coordinates)
      furthest = std::max(furthest, std::abs(to_point(x).norm() - 2));
  EXPECT_LT(furthest, 1e-14);
  // Each projection is a quarter of a disc; its curved edges miss order four.
  const auto integral = integrate_normal(mesh, "film");
  for (unsigned int d = 0; d < 3; ++d)
    EXPECT_NEAR(integral[1 + d], pi, 1e-3);
  for (const std::string pole : {"pole_x", "pole_y", "pole_z"})
    EXPECT_EQ(fe::get_group_points(mesh, pole).size(), 1u);
  for (unsigned int d = 0; d < 3; ++d)
  {
    const std::string edge = "symmetry_" + std::string(1, "xyz"[d]);
    const auto ids = mesh.groups.get_ids(1, edge);
    for (const fe::MeshLine& line : mesh.lines)
    {
      const double distance = mesh.middle_points[line.middle][d];
      EXPECT_EQ(std::abs(distance) < 1e-15, ids.count(line.group_set) > 0);
    }
  }
}
} // namespace
