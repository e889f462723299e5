#include <taut/base/exceptions.h>
#include <taut/fe/triangulation.h>

#include <deal.II/fe/fe.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <set>
#include <utility>

namespace taut::fe
{
namespace
{
using Cell = dealii::CellData<2>;
using Edge = std::pair<unsigned int, unsigned int>;

/// Index in MeshQuad::vertices of deal.II's lexicographic vertex.
constexpr std::array<unsigned int, 4> around{{0, 1, 3, 2}};

Cell make_cell(const MeshQuad& quad)
{
  Cell cell(4);
  for (unsigned int v = 0; v < 4; ++v)
    cell.vertices[v] = quad.vertices[around[v]];
  cell.material_id = quad.group_set;
  return cell;
}

/// How many cells meet at each edge.
std::map<Edge, unsigned int> count_cells_at_edges(const MeshData& mesh)
{
  std::map<Edge, unsigned int> counts;
  for (const MeshQuad& quad : mesh.quads)
    for (unsigned int v = 0; v < 4; ++v)
      ++counts[std::minmax({quad.vertices[v], quad.vertices[(v + 1) % 4]})];
  for (const auto& [edge, count] : counts)
    if (count > 2)
      throw BadInput("more than two cells of the mesh meet at one edge: a film "
                     "cannot branch");
  return counts;
}

/// Whether the cell's vertices run in the sense of `quad`.
bool runs_like(const Cell& cell, const MeshQuad& quad)
{
  const auto first =
      std::find(quad.vertices.begin(), quad.vertices.end(), cell.vertices[0]);
  const auto next = (first - quad.vertices.begin() + 1) % 4;
  return quad.vertices[next] == cell.vertices[1];
}

/// Numbers the vertices of each cell such that neighbours agree on the
/// direction of their common edge, as deal.II needs. Exchanging the two unit
/// coordinates of a cell keeps the direction of every edge and turns a mirrored
/// cell back.
std::vector<Cell> make_cells(const MeshData& mesh)
{
  std::vector<Cell> cells;
  for (const MeshQuad& quad : mesh.quads)
    cells.push_back(make_cell(quad));
  dealii::GridTools::consistently_order_cells(cells);
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!runs_like(cells[i], mesh.quads[i]))
      std::swap(cells[i].vertices[1], cells[i].vertices[2]);
  return cells;
}

dealii::SubCellData make_lines(const MeshData& mesh)
{
  const std::map<Edge, unsigned int> counts = count_cells_at_edges(mesh);
  dealii::SubCellData lines;
  for (const MeshLine& mesh_line : mesh.lines)
  {
    const auto& vertices = mesh_line.vertices;
    const bool is_boundary =
        counts.at(std::minmax({vertices[0], vertices[1]})) == 1;
    dealii::CellData<1> line(2);
    line.vertices = {vertices[0], vertices[1]};
    line.manifold_id = mesh_line.group_set;
    line.boundary_id = is_boundary ? mesh_line.group_set
                                   : dealii::numbers::internal_face_boundary_id;
    lines.boundary_lines.push_back(line);
  }
  return lines;
}

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

MeshQuad get_turned_quad(const CellIterator& coarse, const MeshData& mesh)
{
  std::array<unsigned int, 4> vertices;
  for (unsigned int v = 0; v < 4; ++v)
    vertices[v] = coarse->vertex_index(v);
  // Not the coarse cell's id, which is the number of its p4est tree.
  return turn_to_cell(mesh.quads[coarse->index()], vertices);
}
} // namespace

void create_triangulation(const MeshData& mesh, const unsigned int refinements,
                          Triangulation& triangulation)
{
  std::vector<dealii::Point<3>> vertices;
  for (const Coordinates& vertex : mesh.vertices)
    vertices.push_back(to_point(vertex));
  const dealii::SubCellData lines = make_lines(mesh);
  triangulation.create_triangulation(vertices, make_cells(mesh), lines);
  for (const auto id : triangulation.get_manifold_ids())
    if (id != dealii::numbers::flat_manifold_id)
      triangulation.set_manifold(id, dealii::FlatManifold<2, 3>());
  triangulation.refine_global(refinements);
}

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
