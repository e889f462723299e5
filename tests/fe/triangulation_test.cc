#include <taut/base/exceptions.h>
#include <taut/fe/triangulation.h>

#include <deal.II/base/mpi.h>

#include <fe/surface_grids.h>
#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace taut::fe;
using dealii::Point;

double sum_areas(const Triangulation& triangulation, const MeshGroups& groups,
                 const std::string& group)
{
  const auto ids = groups.get_ids(2, group);
  double area = 0;
  for (const auto& cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && ids.count(cell->material_id()) > 0)
      area += cell->measure();
  return sum_over_ranks(area);
}

/// An interior line is seen from two sides, each of which counts half.
double sum_lengths(const Triangulation& triangulation, const MeshGroups& groups,
                   const std::string& group)
{
  const auto ids = groups.get_ids(1, group);
  double length = 0;
  for (const auto& cell : triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators())
      if (cell->is_locally_owned() && ids.count(face->manifold_id()) > 0)
        length += (face->at_boundary() ? 1 : .5) * face->measure();
  return sum_over_ranks(length);
}

/// Two strips with a bar between them, the left one 1 long, the right one 2.
MeshData make_strips()
{
  Grid grid(3, 2, 1, rectangle);
  MeshGroups& groups = grid.mesh.groups;
  for (unsigned int j = 0; j < 2; ++j)
    for (unsigned int i = 0; i < 3; ++i)
      grid.get_quad(i, j).group_set = i == 0 ? groups.add(2, {"left", "film"})
                                             : groups.add(2, {"right", "film"});
  for (unsigned int j = 0; j < 2; ++j)
  {
    grid.add_line(0, j, false, {"frame", "end"});
    grid.add_line(1, j, false, {"bar"});
  }
  for (unsigned int i = 0; i < 3; ++i)
    grid.add_line(i, 0, true, {"frame"});
  return grid.mesh;
}

TEST(Triangulation, keeps_areas_and_lengths_of_groups_under_refinement)
{
  const MeshData mesh = make_strips();
  Triangulation triangulation(MPI_COMM_WORLD);
  create_triangulation(mesh, 0, triangulation);
  const std::map<std::string, double> areas{
      {"left", 2}, {"right", 4}, {"film", 6}};
  const std::map<std::string, double> lengths{
      {"frame", 5}, {"end", 2}, {"bar", 2}};
  for (unsigned int level = 0; level < 3; ++level)
  {
    for (const auto& [group, area] : areas)
      EXPECT_NEAR(sum_areas(triangulation, mesh.groups, group), area,
                  round_off);
    for (const auto& [group, length] : lengths)
      EXPECT_NEAR(sum_lengths(triangulation, mesh.groups, group), length,
                  round_off);
    refine(triangulation, [](const Point<3>& x) { return x[0] < 1.6; });
  }
}

TEST(Triangulation, gives_boundary_lines_their_group_set_as_boundary_id)
{
  const MeshData mesh = make_strips();
  Triangulation triangulation(MPI_COMM_WORLD);
  create_triangulation(mesh, 1, triangulation);
  unsigned int mistakes = 0;
  for (const auto& cell : triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators())
      if (face->at_boundary() &&
          mesh.groups.get_set(1, face->boundary_id()) !=
              mesh.groups.get_set(1, face->manifold_id()))
        ++mistakes;
  EXPECT_EQ(mistakes, 0u);
}

TEST(Triangulation, is_the_same_on_all_ranks_after_a_broadcast)
{
  const bool is_reader =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const MeshData mesh = dealii::Utilities::MPI::broadcast(
      MPI_COMM_WORLD, is_reader ? make_strips() : MeshData());
  Triangulation triangulation(MPI_COMM_WORLD);
  create_triangulation(mesh, 2, triangulation);
  EXPECT_NEAR(sum_areas(triangulation, mesh.groups, "left"), 2, round_off);
  EXPECT_NEAR(sum_lengths(triangulation, mesh.groups, "bar"), 2, round_off);
}

TEST(Triangulation, refuses_three_cells_at_one_edge)
{
  MeshData mesh = Grid(2, 1, 1, rectangle).mesh;
  Grid grid(2, 1, 1, rectangle);
  const unsigned int low = grid.get_vertex(1, 0), high = grid.get_vertex(1, 1);
  mesh.vertices.push_back({1.5, 0, 1});
  mesh.vertices.push_back({1.5, 2, 1});
  MeshQuad fin;
  fin.vertices = {low, 6, 7, high};
  mesh.quads.push_back(fin);
  Triangulation triangulation(MPI_COMM_WORLD);
  EXPECT_THROW(create_triangulation(mesh, 0, triangulation), taut::BadInput);
}

/// A strip of one cell across, closed after half a turn: the edges across it
/// cannot all point to the same side.
TEST(Triangulation, refuses_a_moebius_strip)
{
  MeshData mesh;
  const unsigned int n = 8;
  for (unsigned int i = 0; i < n; ++i)
    for (const double side : {-.3, .3})
    {
      const double angle = 2 * pi * i / n, radius = 1 + side * cos(angle / 2);
      mesh.vertices.push_back({radius * std::cos(angle),
                               radius * std::sin(angle),
                               side * std::sin(angle / 2)});
    }
  for (unsigned int i = 0; i < n; ++i)
  {
    MeshQuad quad;
    quad.vertices = {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1};
    if (i + 1 == n)
      quad.vertices = {2 * i, 1, 0, 2 * i + 1};
    mesh.quads.push_back(quad);
  }
  Triangulation triangulation(MPI_COMM_WORLD);
  EXPECT_THROW(create_triangulation(mesh, 0, triangulation), taut::BadInput);
}
} // namespace
