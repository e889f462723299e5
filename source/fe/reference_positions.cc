#include <taut/fe/reference_positions.h>

#include <deal.II/fe/fe.h>

#include <algorithm>

namespace taut::fe
{
namespace
{
dealii::Point<3> to_point(const Coordinates& x)
{
  return {x[0], x[1], x[2]};
}

/// The Lagrange polynomials of degree 1 or 2 on [0, 1]: the nodes are the two
/// ends and, for degree 2, the middle.
std::array<double, 3> compute_polynomials(const unsigned int degree,
                                          const double x)
{
  if (degree == 1)
    return {{1 - x, x, 0}};
  return {{(1 - x) * (1 - 2 * x), x * (2 * x - 1), 4 * x * (1 - x)}};
}

/// A quad with its nodes turned to the local numbering of a coarse cell.
MeshQuad turn_to_cell(const MeshQuad& quad,
                      const std::array<unsigned int, 4>& cell_vertices)
{
  MeshQuad turned = quad;
  const auto begin = quad.vertices.begin();
  const unsigned int shift =
      std::find(begin, quad.vertices.end(), cell_vertices[0]) - begin;
  for (unsigned int v = 0; v < 4; ++v)
  {
    turned.vertices[v] = quad.vertices[(v + shift) % 4];
    turned.middles[v] = quad.middles[(v + shift) % 4];
  }
  return turned;
}

using CellIterator = dealii::TriaIterator<dealii::CellAccessor<2, 3>>;

/// The square that a descendant fills in the unit coordinates of its coarse
/// cell.
struct UnitSquare
{
  dealii::Point<2> corner;
  double size = 1;
};

/// Walks up to the coarse ancestor, which `cell` becomes.
UnitSquare find_unit_square(CellIterator& cell)
{
  UnitSquare square;
  while (cell->level() > 0)
  {
    const CellIterator parent = cell->parent();
    for (unsigned int child = 0; child < parent->n_children(); ++child)
      if (parent->child(child) == cell)
        for (unsigned int d = 0; d < 2; ++d)
          square.corner[d] = (square.corner[d] + (child >> d & 1)) / 2;
    square.size /= 2;
    cell = parent;
  }
  return square;
}

/// Coarse cells keep the index at which they were created; the coarse cell of
/// their CellId counts the trees of p4est instead.
MeshQuad get_turned_quad(const CellIterator& coarse, const MeshData& mesh)
{
  std::array<unsigned int, 4> vertices;
  for (unsigned int v = 0; v < 4; ++v)
    vertices[v] = coarse->vertex_index(v);
  return turn_to_cell(mesh.quads[coarse->index()], vertices);
}
} // namespace

dealii::Point<3> compute_position(const MeshData& mesh, const MeshQuad& quad,
                                  const dealii::Point<2>& unit_point)
{
  const auto first = compute_polynomials(mesh.order, unit_point[0]);
  const auto second = compute_polynomials(mesh.order, unit_point[1]);
  dealii::Point<3> position;
  const auto add = [&](const double weight, const Coordinates& node)
  { position += weight * (to_point(node) - dealii::Point<3>()); };
  for (unsigned int v = 0; v < 4; ++v)
    add(first[v == 1 || v == 2] * second[v > 1],
        mesh.vertices[quad.vertices[v]]);
  if (mesh.order == 1)
    return position;
  const std::array<double, 5> weights{
      {first[2] * second[0], first[1] * second[2], first[2] * second[1],
       first[0] * second[2], first[2] * second[2]}};
  for (unsigned int m = 0; m < weights.size(); ++m)
    add(weights[m], mesh.middle_points[quad.middles[m]]);
  return position;
}

std::map<dealii::types::global_dof_index, dealii::Point<3>>
compute_reference_positions(const dealii::DoFHandler<2, 3>& dof_handler,
                            const MeshData& mesh)
{
  const auto& support_points = dof_handler.get_fe().get_unit_support_points();
  std::map<dealii::types::global_dof_index, dealii::Point<3>> positions;
  std::vector<dealii::types::global_dof_index> dofs(support_points.size());
  for (const auto& cell : dof_handler.active_cell_iterators())
  {
    if (cell->is_artificial())
      continue;
    CellIterator coarse = cell;
    const UnitSquare square = find_unit_square(coarse);
    const MeshQuad quad = get_turned_quad(coarse, mesh);
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
      positions[dofs[i]] = compute_position(
          mesh, quad, square.corner + square.size * support_points[i]);
  }
  return positions;
}
} // namespace taut::fe
