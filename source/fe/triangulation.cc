#include <taut/base/exceptions.h>
#include <taut/fe/triangulation.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <set>
#include <utility>

#include <boost/pending/disjoint_sets.hpp>

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

/// Opposite edges of a cell must point to the same side. So each directed edge
/// drags others along from cell to cell, and must not meet its own reverse.
/// deal.II checks this in Debug only.
void check_directions(const MeshData& mesh)
{
  std::map<Edge, std::size_t> numbers;
  const auto get_number = [&](const unsigned int from, const unsigned int to) {
    return numbers.try_emplace({from, to}, numbers.size()).first->second;
  };
  boost::disjoint_sets_with_storage<> bundles(8 * mesh.quads.size());
  for (const MeshQuad& quad : mesh.quads)
    for (const unsigned int v : {0, 1, 2, 3})
      bundles.union_set(
          get_number(quad.vertices[v], quad.vertices[(v + 1) % 4]),
          get_number(quad.vertices[(v + 3) % 4], quad.vertices[(v + 2) % 4]));
  for (const auto& [edge, number] : numbers)
    if (bundles.find_set(number) ==
        bundles.find_set(numbers.at({edge.second, edge.first})))
      throw BadInput("the edges of the mesh cannot be directed such that "
                     "opposite edges of every cell agree (a Moebius strip): "
                     "cut the surface open");
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
  check_directions(mesh);
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

/// The vertices of quads, which come first; p4est allows no others.
std::vector<dealii::Point<3>> make_vertices(const MeshData& mesh)
{
  unsigned int n = 0;
  for (const MeshQuad& quad : mesh.quads)
    for (const unsigned int vertex : quad.vertices)
      n = std::max(n, vertex + 1);
  std::vector<dealii::Point<3>> vertices;
  for (unsigned int v = 0; v < n; ++v)
    vertices.emplace_back(mesh.vertices[v][0], mesh.vertices[v][1],
                          mesh.vertices[v][2]);
  return vertices;
}
} // namespace

void create_triangulation(const MeshData& mesh, const unsigned int refinements,
                          Triangulation& triangulation)
{
  const dealii::SubCellData lines = make_lines(mesh);
  triangulation.create_triangulation(make_vertices(mesh), make_cells(mesh),
                                     lines);
  for (const auto id : triangulation.get_manifold_ids())
    if (id != dealii::numbers::flat_manifold_id)
      triangulation.set_manifold(id, dealii::FlatManifold<2, 3>());
  triangulation.refine_global(refinements);
}
} // namespace taut::fe
