// The parametric geometries in meshes/.
#include <taut/io/gmsh_reader.h>

#include <gtest/gtest.h>
#include <io/mesh_measures.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace taut;
using namespace taut::io;
using Parameters = std::map<std::string, double>;

constexpr double pi = 3.14159265358979323846;
/// Round-off of lengths in m that are below .1.
constexpr double tiny = 1e-15;

fe::MeshData read(const std::string& geometry,
                  const Parameters& parameters = {})
{
  return io::read_mesh(std::string(TAUT_MESHES) + "/" + geometry, parameters);
}

TEST(Geometries, resonator_is_the_stretched_film)
{
  const auto mesh = read("resonator.geo", {{"length_passive", 30e-3}});
  // Twice the length, four times the width.
  const double active = 40e-3, passive = 60e-3, side = 80e-3;
  EXPECT_NEAR(compute_area(mesh, "active"), active * side, tiny);
  EXPECT_NEAR(compute_area(mesh, "passive"), passive * side, tiny);
  EXPECT_NEAR(sum_chords(mesh, "bar"), side, tiny);
  EXPECT_NEAR(sum_chords(mesh, "frame_active_end"), side, tiny);
  EXPECT_NEAR(sum_chords(mesh, "frame_passive_end"), side, tiny);
  EXPECT_NEAR(sum_chords(mesh, "frame_sides"), 2 * (active + passive), tiny);
  EXPECT_NEAR(sum_chords(mesh, "frame_sides_active"), 2 * active, tiny);
  EXPECT_NEAR(sum_chords(mesh, "frame_sides_passive"), 2 * passive, tiny);
  // The bar ends on the sides, which have to follow it, or before them.
  EXPECT_NEAR(sum_chords(mesh, "frame_fixed"), 2 * side, tiny);
  EXPECT_NEAR(
      sum_chords(read("resonator.geo", {{"bar_gap", 12e-3}}), "frame_fixed"),
      2 * side + 4 * active, tiny);
  EXPECT_EQ(read("resonator.geo", {{"order", 2}}).order, 2u);
}

TEST(Geometries, resonator_leaves_a_margin_round_its_electrode)
{
  // The bar ends inside of the electrode, at its edge, outside of it, at the
  // frame.
  for (const double gap : {12e-3, 5e-3, 2e-3, 0.})
  {
    const auto mesh =
        read("resonator.geo", {{"margin", 5e-3}, {"bar_gap", gap}});
    const double active = (40e-3 - 5e-3) * (80e-3 - 2 * 5e-3);
    EXPECT_NEAR(compute_area(mesh, "active"), active, tiny) << gap;
    EXPECT_NEAR(compute_area(mesh, "margin_active"), 40e-3 * 80e-3 - active,
                tiny);
    EXPECT_NEAR(compute_area(mesh, "passive"), 40e-3 * 80e-3, tiny);
    EXPECT_NEAR(integrate_normal(mesh, "active")[3], active, tiny);
    EXPECT_NEAR(sum_chords(mesh, "bar"), 80e-3 - 2 * gap, tiny) << gap;
    EXPECT_NEAR(sum_chords(mesh, "frame_active_end"), 80e-3, tiny);
    EXPECT_NEAR(sum_chords(mesh, "frame_passive_end"), 80e-3, tiny);
    EXPECT_NEAR(sum_chords(mesh, "frame_sides_active"), 80e-3, tiny);
    EXPECT_NEAR(sum_chords(mesh, "frame_sides_passive"), 80e-3, tiny);
  }
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

std::size_t count_lines(const fe::MeshData& mesh,
                        const std::vector<fe::MeshLine>& lines,
                        const std::string& group)
{
  const auto ids = mesh.groups.get_ids(1, group);
  return std::count_if(lines.begin(), lines.end(),
                       [&](const auto& line)
                       { return ids.count(line.group_set) > 0; });
}

dealii::Point<3> get_point(const fe::MeshData& mesh, const std::string& group)
{
  const auto points = fe::get_group_points(mesh, group);
  EXPECT_EQ(points.size(), 1u) << group;
  return to_point(points.at(0));
}

TEST(Geometries, demes_has_a_film_in_its_hole_and_legs_beside_it)
{
  const Parameters sizes{{"hole_length", 60e-3}, {"hole_width", 30e-3},
                         {"leg_width", 8e-3},    {"cells_along", 5},
                         {"cells_across", 4},    {"cells_leg", 10},
                         {"cells_bar", 2}};
  const auto mesh = read("demes.geo", sizes);
  EXPECT_NEAR(compute_area(mesh, "film"), 60e-3 * 30e-3, tiny);
  EXPECT_EQ(mesh.quads.size(), 6 * 4u);
  EXPECT_NEAR(integrate_normal(mesh, "film")[3], 60e-3 * 30e-3, tiny);
  for (const std::string line : {"end_left", "end_right", "film_middle_across"})
    EXPECT_NEAR(sum_chords(mesh, line), 30e-3, tiny) << line;
  for (const std::string line : {"side_front", "side_back"})
    EXPECT_NEAR(sum_chords(mesh, line), 60e-3, tiny) << line;
  for (const std::string leg : {"leg_front", "leg_back"})
  {
    EXPECT_NEAR(sum_chords(mesh, mesh.free_lines, leg), 60e-3, tiny);
    EXPECT_EQ(count_lines(mesh, mesh.free_lines, leg), 10u);
    EXPECT_EQ(count_lines(mesh, mesh.lines, leg), 0u);
  }
  for (const std::string bar : {"bar_left", "bar_right"})
  {
    EXPECT_NEAR(sum_chords(mesh, mesh.free_lines, bar), 2 * 4e-3, tiny);
    EXPECT_EQ(count_lines(mesh, mesh.free_lines, bar), 4u);
  }
  EXPECT_NEAR(get_point(mesh, "leg_back_middle").distance({0, 19e-3, 0}), 0,
              tiny);
  EXPECT_NEAR(get_point(mesh, "end_left_middle").distance({-30e-3, 0, 0}), 0,
              tiny);
  EXPECT_NEAR(get_point(mesh, "film_middle").norm(), 0, tiny);
  EXPECT_NEAR(
      get_point(mesh, "corner_right_front").distance({30e-3, -15e-3, 0}), 0,
      tiny);
}

TEST(Geometries, demes_legs_stand_off_and_hang_over)
{
  const auto mesh = read("demes.geo", {{"stand_off", 20e-3},
                                       {"leg_distance", 15e-3},
                                       {"overhang", 5e-3},
                                       {"cells_overhang", 2}});
  EXPECT_NEAR(get_point(mesh, "leg_front_middle").distance({0, -35e-3, -20e-3}),
              0, tiny);
  EXPECT_NEAR(sum_chords(mesh, mesh.free_lines, "bar_left"), 2 * 25e-3, tiny);
  EXPECT_NEAR(sum_chords(mesh, mesh.free_lines, "overhang"), 4 * 5e-3, tiny);
  EXPECT_EQ(count_lines(mesh, mesh.free_lines, "overhang"), 8u);
}

TEST(Geometries, demes_legs_without_distance_are_the_edges_of_the_film)
{
  const auto mesh = read("demes.geo", {{"leg_distance", 0}});
  EXPECT_TRUE(mesh.free_lines.empty());
  for (const std::string leg : {"leg_front", "leg_back"})
    EXPECT_NEAR(sum_chords(mesh, leg), 40e-3, tiny);
  EXPECT_FALSE(mesh.groups.has(1, "bar_left"));
  EXPECT_NEAR(get_point(mesh, "leg_front_middle").distance({0, -20e-3, 0}), 0,
              tiny);
}

TEST(Geometries, strip_lies_above_one_beam)
{
  const auto mesh =
      read("strip.geo",
           {{"stand_off", 7e-3}, {"cells_beam", 12}, {"cells_along", 3}});
  EXPECT_EQ(mesh.quads.size(), 3u);
  EXPECT_NEAR(compute_area(mesh, "film"), 40e-3 * 40e-3, tiny);
  EXPECT_EQ(mesh.free_lines.size(), 12u);
  EXPECT_NEAR(sum_chords(mesh, mesh.free_lines, "beam"), 40e-3, tiny);
  for (const std::string end : {"end_left", "end_right"})
    EXPECT_NEAR(sum_chords(mesh, end), 40e-3, tiny);
  EXPECT_NEAR(get_point(mesh, "beam_left").distance({-20e-3, 0, -7e-3}), 0,
              tiny);
  EXPECT_NEAR(get_point(mesh, "beam_middle").distance({0, 0, -7e-3}), 0, tiny);
  EXPECT_NEAR(get_point(mesh, "beam_right").distance({20e-3, 0, -7e-3}), 0,
              tiny);
  // In the plane of the film, the two still share no vertex.
  EXPECT_EQ(read("strip.geo", {{"stand_off", 0}, {"cells_beam", 12}})
                .free_lines.size(),
            12u);
}

TEST(Geometries, beam_is_straight_or_an_arc)
{
  const auto straight = read("beam.geo", {{"length", 2}, {"cells", 6}});
  EXPECT_TRUE(straight.only_lines);
  EXPECT_EQ(straight.free_lines.size(), 6u);
  EXPECT_NEAR(get_point(straight, "end").distance({2, 0, 0}), 0, 1e-14);
  const double radius = 4 / pi; // of a right angle
  const auto arc = read("beam.geo", {{"length", 2}, {"angle", 90}});
  for (const std::string point : {"start", "middle", "end"})
    EXPECT_NEAR(get_point(arc, point).distance({0, radius, 0}), radius, 1e-14);
  EXPECT_NEAR(get_point(arc, "end").distance({radius, radius, 0}), 0, 1e-14);
  EXPECT_EQ(arc.order, 2u);
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
