#include <taut/fe/reference_positions.h>
#include <taut/fe/triangulation.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/affine_constraints.h>

#include <fe/surface_grids.h>
#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace taut::fe;
using dealii::Point;
using dealii::Tensor;

constexpr double ring_area = 3 * pi;

/// Band of a unit sphere between the heights -1/2 and 1/2, normal outwards.
Coordinates band(const double s, const double t)
{
  const double height = t - .5, radius = std::sqrt(1 - height * height);
  return {radius * std::cos(2 * pi * s), radius * std::sin(2 * pi * s), height};
}
constexpr double band_area = 2 * pi;

/// Nodal positions of a Q2 element and the area that they span.
class CurvedSurface
{
public:
  CurvedSurface(const Triangulation& triangulation, const MeshData& mesh)
      : dof_handler(triangulation)
  {
    dof_handler.distribute_dofs(element);
    positions = compute_reference_positions(dof_handler, mesh);
  }

  template <typename Cell>
  Tensor<1, 3> compute_normal(const Cell& cell, const Point<2>& unit_point)
  {
    std::vector<dealii::types::global_dof_index> dofs(
        element.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    Tensor<1, 3> tangents[2];
    for (unsigned int i = 0; i < dofs.size(); ++i)
      for (unsigned int d = 0; d < 2; ++d)
        tangents[d] +=
            element.shape_grad(i, unit_point)[d] * positions.at(dofs[i]);
    return dealii::cross_product_3d(tangents[0], tangents[1]);
  }

  double compute_area()
  {
    const dealii::QGauss<2> quadrature(4);
    double area = 0;
    for (const auto& cell : dof_handler.active_cell_iterators())
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        if (cell->is_locally_owned())
          area += quadrature.weight(q) *
                  compute_normal(cell, quadrature.point(q)).norm();
    return sum_over_ranks(area);
  }

  dealii::FE_Q<2, 3> element{2};
  dealii::DoFHandler<2, 3> dof_handler;
  std::map<dealii::types::global_dof_index, Point<3>> positions;
};

double compute_area(const MeshData& mesh, const unsigned int refinements)
{
  Triangulation triangulation(MPI_COMM_WORLD);
  create_triangulation(mesh, refinements, triangulation);
  return CurvedSurface(triangulation, mesh).compute_area();
}

/// Quadratic edges miss a curve of length h by h^4 (the cubic term of the
/// interpolation error is odd and cancels in the area).
TEST(ReferencePositions, area_of_curved_cells_converges_with_order_four)
{
  const auto check = [](const Map& map, const double exact)
  {
    const double coarse = compute_area(Grid(8, 2, 2, map, true).mesh, 0);
    const double fine = compute_area(Grid(16, 4, 2, map, true).mesh, 0);
    const double order = std::log2((exact - coarse) / (exact - fine));
    EXPECT_NEAR(order, 4, .15);
  };
  check(ring, ring_area);
  check(band, band_area);
}

/// The plane ring has a polynomial area element, which the quadrature
/// integrates exactly on every level.
TEST(ReferencePositions, refinement_keeps_the_curved_surface_exactly)
{
  const MeshData mesh = Grid(8, 2, 2, ring, true).mesh;
  const double area = compute_area(mesh, 0);
  EXPECT_GT(std::abs(area - ring_area), 1e-4);
  EXPECT_NEAR(compute_area(mesh, 1), area, round_off);
  EXPECT_NEAR(compute_area(mesh, 3), area, round_off);
}

TEST(ReferencePositions, hanging_nodes_lie_on_the_edge_of_their_neighbour)
{
  const MeshData mesh = Grid(8, 2, 2, band, true).mesh;
  Triangulation triangulation(MPI_COMM_WORLD);
  create_triangulation(mesh, 0, triangulation);
  refine(triangulation, [](const Point<3>& x) { return x[0] > 0; });
  refine(triangulation, [](const Point<3>& x) { return x[0] > .5; });
  CurvedSurface surface(triangulation, mesh);

  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(surface.dof_handler,
                                                  relevant);
  dealii::AffineConstraints<double> constraints(relevant);
  dealii::DoFTools::make_hanging_node_constraints(surface.dof_handler,
                                                  constraints);
  constraints.close();
  double checked = 0;
  for (const auto& [dof, position] : surface.positions)
    if (const auto* entries = constraints.get_constraint_entries(dof))
    {
      Tensor<1, 3> gap = position;
      for (const auto& [other, weight] : *entries)
        gap -= weight * surface.positions.at(other);
      EXPECT_LT(gap.norm(), round_off);
      ++checked;
    }
  EXPECT_GT(sum_over_ranks(checked), 0);
}

TEST(ReferencePositions, straight_cells_carry_points_in_equal_parts)
{
  const MeshData mesh = Grid(3, 2, 1, rectangle).mesh;
  Triangulation triangulation(MPI_COMM_WORLD);
  create_triangulation(mesh, 1, triangulation);
  for (const auto& [dof, x] : CurvedSurface(triangulation, mesh).positions)
  {
    EXPECT_NEAR(4 * x[0], std::round(4 * x[0]), round_off);
    EXPECT_NEAR(4 * x[1], std::round(4 * x[1]), round_off);
  }
  EXPECT_NEAR(compute_area(mesh, 2), 6, round_off);
}

TEST(ReferencePositions, normals_follow_the_sense_of_the_quads)
{
  Grid grid(8, 2, 2, ring, true);
  for (unsigned int j = 0; j < 2; ++j)
  {
    MeshQuad& quad = grid.get_quad(3, j);
    std::swap(quad.vertices[1], quad.vertices[3]);
    std::swap(quad.middles[0], quad.middles[3]);
    std::swap(quad.middles[1], quad.middles[2]);
    quad.group_set = grid.mesh.groups.add(2, {"turned"});
  }
  const auto turned = grid.mesh.groups.get_ids(2, "turned");
  Triangulation triangulation(MPI_COMM_WORLD);
  create_triangulation(grid.mesh, 1, triangulation);
  CurvedSurface surface(triangulation, grid.mesh);
  for (const auto& cell : surface.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const double sense = turned.count(cell->material_id()) > 0 ? -1 : 1;
      EXPECT_GT(sense * surface.compute_normal(cell, {.5, .5})[2], 0);
    }
}
} // namespace
