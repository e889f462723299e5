#include <taut/base/exceptions.h>
#include <taut/fe/triangulation.h>
#include <taut/io/gmsh_reader.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_q.h>

#include <gtest/gtest.h>
#include <io/mesh_folder.h>
#include <io/mesh_measures.h>

#include <cmath>

namespace
{
using namespace taut;
using namespace taut::io;
using Names = std::vector<std::string>;
using GmshReader = MeshFolder;

constexpr unsigned int points = 0, lines = 1, surfaces = 2;

template <typename Element>
std::vector<std::vector<unsigned int>>
get_numbers(const std::vector<Element>& elements)
{
  std::vector<std::vector<unsigned int>> numbers;
  for (const Element& element : elements)
  {
    numbers.emplace_back(element.vertices.begin(), element.vertices.end());
    numbers.back().push_back(element.group_set);
  }
  return numbers;
}

/// A .msh in text holds 16 digits.
void expect_near(const std::vector<fe::Coordinates>& a,
                 const std::vector<fe::Coordinates>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_LT(to_point(a[i]).distance(to_point(b[i])), 1e-15);
}

void expect_equal(const fe::MeshData& a, const fe::MeshData& b)
{
  EXPECT_EQ(a.order, b.order);
  expect_near(a.vertices, b.vertices);
  expect_near(a.middle_points, b.middle_points);
  EXPECT_TRUE(a.groups == b.groups);
  EXPECT_EQ(get_numbers(a.quads), get_numbers(b.quads));
  EXPECT_EQ(get_numbers(a.lines), get_numbers(b.lines));
  EXPECT_EQ(get_numbers(a.free_lines), get_numbers(b.free_lines));
  EXPECT_EQ(a.only_lines, b.only_lines);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.quads.size(); ++i)
    EXPECT_EQ(a.quads[i].middles, b.quads[i].middles);
  for (std::size_t i = 0; i < a.free_lines.size(); ++i)
    EXPECT_EQ(a.free_lines[i].middle, b.free_lines[i].middle);
  for (std::size_t i = 0; i < a.points.size(); ++i)
    EXPECT_EQ(a.points[i].vertex, b.points[i].vertex);
}

TEST_F(GmshReader, keeps_names_overlapping_groups_and_interior_lines)
{
  const fe::MeshData mesh = read_text(grouped);
  EXPECT_EQ(mesh.groups.get_names(surfaces), (Names{"all", "left"}));
  EXPECT_EQ(mesh.groups.get_names(lines),
            (Names{"77", "lower", "lower left", "middle"}));
  EXPECT_EQ(mesh.groups.get_names(points), (Names{"corner"}));
  const double round_off = 1e-14;
  EXPECT_NEAR(compute_area(mesh, "left"), 1, round_off);
  EXPECT_NEAR(compute_area(mesh, "all"), 2, round_off);
  EXPECT_NEAR(sum_chords(mesh, "lower"), 2, round_off);
  EXPECT_NEAR(sum_chords(mesh, "lower left"), 1, round_off);
  EXPECT_NEAR(sum_chords(mesh, "middle"), 1, round_off);
  EXPECT_NEAR(sum_chords(mesh, "77"), 1, round_off);
  EXPECT_EQ(fe::get_group_points(mesh, "corner"),
            (std::vector<fe::Coordinates>{{2, 1, 0}}));
}

TEST_F(GmshReader, normals_are_those_of_gmsh)
{
  const auto mesh =
      read_text(grouped + "ReverseMesh Surface {1};\nMesh.ElementOrder = 2;\n");
  EXPECT_NEAR(integrate_normal(mesh, "left")[3], -1, 1e-14);
  EXPECT_NEAR(integrate_normal(mesh, "all")[3], 0, 1e-14);
}

TEST_F(GmshReader, joins_surfaces_that_touch_and_drops_unused_nodes)
{
  const auto mesh = read_text(R"(
Point(99) = {5, 5, 5};
For i In {0 : 1}
  Point(10 * i + 1) = {i, 0, 0}; Point(10 * i + 2) = {i + 1, 0, 0};
  Point(10 * i + 3) = {i + 1, 1, 0}; Point(10 * i + 4) = {i, 1, 0};
  Line(10 * i + 1) = {10 * i + 1, 10 * i + 2};
  Line(10 * i + 2) = {10 * i + 2, 10 * i + 3};
  Line(10 * i + 3) = {10 * i + 3, 10 * i + 4};
  Line(10 * i + 4) = {10 * i + 4, 10 * i + 1};
  Curve Loop(i + 1) = {10 * i + 1 : 10 * i + 4}; Plane Surface(i + 1) = {i + 1};
EndFor
Transfinite Curve {:} = 3; Transfinite Surface {:}; Recombine Surface {:};
Geometry.AutoCoherence = 0;
Physical Surface("film") = {1, 2};
Physical Curve("seen from the left") = {2};
Physical Curve("seen from the right") = {14};
)");
  EXPECT_EQ(mesh.vertices.size(), 15u);
  EXPECT_EQ(mesh.lines.size(), 2u);
  EXPECT_NEAR(sum_chords(mesh, "seen from the left"), 1, 1e-14);
  EXPECT_NEAR(sum_chords(mesh, "seen from the right"), 1, 1e-14);
}

/// A quarter of a ring as a mast on the corner (2, 1, 0), two cells, and a line
/// across both squares whose ends are corners of cells.
const std::string with_frame = grouped + R"(
Point(20) = {2 * size, size, size}; Point(21) = {2 * size, 2 * size, size};
Circle(20) = {4, 20, 21}; Line(21) = {1, 4};
Transfinite Curve {20} = 3; Transfinite Curve {21} = 2;
Physical Curve("mast") = {20}; Physical Curve("frame") = {1, 20, 21};
Physical Point("top") = {21};
)";

TEST_F(GmshReader, lines_beside_the_film_are_free_lines)
{
  const fe::MeshData film = read_text(grouped);
  const fe::MeshData mesh = read_text(with_frame, {{"order", 2}});
  EXPECT_FALSE(mesh.only_lines);
  EXPECT_EQ(get_numbers(mesh.quads), get_numbers(film.quads));
  EXPECT_EQ(mesh.lines.size(), film.lines.size());
  ASSERT_EQ(mesh.free_lines.size(), 3u);
  // Two vertices more than those of the film, and behind them.
  EXPECT_EQ(mesh.vertices.size(), film.vertices.size() + 2);
  const double round_off = 1e-14;
  EXPECT_NEAR(sum_chords(mesh, "frame"), 1, round_off);
  EXPECT_NEAR(sum_chords(mesh, mesh.free_lines, "mast"), 4 * std::sin(M_PI / 8),
              round_off);
  EXPECT_NEAR(sum_chords(mesh, mesh.free_lines, "frame"),
              4 * std::sin(M_PI / 8) + std::sqrt(5.), round_off);
  const auto mast = mesh.groups.get_ids(1, "mast");
  for (const fe::MeshLine& line : mesh.free_lines)
    if (mast.count(line.group_set) > 0)
    {
      const fe::Coordinates& middle = mesh.middle_points.at(line.middle);
      EXPECT_NEAR(std::hypot(middle[1] - 1, middle[2] - 1), 1, round_off);
    }
  const auto top = fe::get_group_points(mesh, "top");
  ASSERT_EQ(top.size(), 1u);
  EXPECT_NEAR(to_point(top[0]).distance({2, 2, 1}), 0, round_off);
}

TEST_F(GmshReader, refinement_leaves_free_lines_alone)
{
  const fe::MeshData mesh = read_text(with_frame, {{"order", 2}});
  fe::Triangulation triangulation(MPI_COMM_WORLD);
  fe::create_triangulation(mesh, 2, triangulation);
  EXPECT_EQ(triangulation.n_global_active_cells(), 16 * mesh.quads.size());
  dealii::DoFHandler<2, 3> dof_handler(triangulation);
  dof_handler.distribute_dofs(dealii::FE_Q<2, 3>(2));
  // The positions find their coarse cell: all lie in the plane of the film.
  double highest = 0, furthest = 0;
  for (const auto& [dof, x] :
       fe::compute_reference_positions(dof_handler, mesh))
  {
    highest = std::max(highest, std::abs(x[2]));
    furthest = std::max(furthest, x[0]);
  }
  EXPECT_EQ(highest, 0);
  EXPECT_EQ(dealii::Utilities::MPI::max(furthest, MPI_COMM_WORLD), 2);
}

/// A portal of two posts and a beam.
const std::string portal = R"(
DefineConstant[ order = 1 ];
Point(1) = {0, 0, 0}; Point(2) = {0, 0, 2}; Point(3) = {3, 0, 2};
Point(4) = {3, 0, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4};
Transfinite Curve {1 : 3} = 5;
Physical Curve("posts") = {1, 3}; Physical Curve("frame") = {1 : 3};
Physical Point("feet") = {1, 4};
Mesh.ElementOrder = order;
)";

TEST_F(GmshReader, a_mesh_of_lines_gets_one_cell_that_touches_nothing)
{
  for (const unsigned int order : {1, 2})
  {
    const fe::MeshData mesh = read_text(portal, {{"order", order}});
    EXPECT_TRUE(mesh.only_lines);
    EXPECT_EQ(mesh.order, order);
    ASSERT_EQ(mesh.quads.size(), 1u);
    EXPECT_TRUE(mesh.groups.get_set(surfaces, mesh.quads[0].group_set).empty());
    EXPECT_TRUE(mesh.lines.empty());
    EXPECT_NEAR(sum_chords(mesh, mesh.free_lines, "posts"), 4, 1e-14);
    EXPECT_NEAR(sum_chords(mesh, mesh.free_lines, "frame"), 7, 1e-14);
    EXPECT_EQ(fe::get_group_points(mesh, "feet"),
              (std::vector<fe::Coordinates>{{0, 0, 0}, {3, 0, 0}}));
    const double size = std::sqrt(13.);
    for (const fe::MeshLine& line : mesh.free_lines)
    {
      for (const unsigned int vertex : mesh.quads[0].vertices)
        for (const unsigned int end : line.vertices)
          EXPECT_GT(to_point(mesh.vertices[vertex])
                        .distance(to_point(mesh.vertices[end])),
                    .5 * size);
    }
    fe::Triangulation triangulation(MPI_COMM_WORLD);
    fe::create_triangulation(mesh, 1, triangulation);
    EXPECT_EQ(triangulation.n_global_active_cells(), 4u);
    dealii::DoFHandler<2, 3> dof_handler(triangulation);
    dof_handler.distribute_dofs(dealii::FE_Q<2, 3>(order));
    for (const auto& [dof, x] :
         fe::compute_reference_positions(dof_handler, mesh))
      EXPECT_GT(x[0], 3 + .49 * size);
  }
}

TEST_F(GmshReader, all_versions_of_msh_hold_the_mesh_of_the_geometry)
{
  for (const std::string& text :
       {grouped, grouped + "Mesh.ElementOrder = 2;\n",
        with_frame + "Mesh.ElementOrder = 2;\n", portal})
  {
    const fe::MeshData mesh = read_text(text);
    for (const double version : {2.2, 4.1})
      for (const bool binary : {false, true})
        expect_equal(
            mesh,
            io::read_mesh(write_msh(text, version, binary, "mesh.msh"), {}));
  }
}

TEST_F(GmshReader, parameters_replace_those_of_the_geometry_once)
{
  const auto changed = read_text(grouped, {{"size", .25}, {"cells", 3}});
  EXPECT_EQ(changed.quads.size(), 18u);
  EXPECT_NEAR(compute_area(changed, "all"), 2 * .0625, 1e-15);
  const auto original = read_text(grouped);
  EXPECT_EQ(original.quads.size(), 8u);
  EXPECT_NEAR(compute_area(original, "all"), 2, 1e-14);
}

TEST_F(GmshReader, includes_are_found_beside_the_geometry)
{
  write("part.geo", squares);
  const auto mesh =
      read_text("Include \"part.geo\";\n" + grouped.substr(squares.size()),
                {{"cells", 1}});
  EXPECT_EQ(mesh.quads.size(), 2u);
}

TEST_F(GmshReader, prints_nothing)
{
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  read_text(grouped);
  EXPECT_THROW(read_text("Line(1) = {1, 2};"), BadInput);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(GmshReader, a_mesh_read_on_one_rank_is_whole_on_all)
{
  const bool is_reader =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const std::string text = with_frame + "Mesh.ElementOrder = 2;\n";
  expect_equal(dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD,
                                                 is_reader ? read_text(text)
                                                           : fe::MeshData()),
               read_text(text));
}
} // namespace
