// Small meshes made without a mesh generator, and sums over their ranks.
#pragma once

#include <taut/fe/triangulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace taut::fe
{
constexpr double pi = 3.14159265358979323846;
/// Sums of some hundred terms of order one.
constexpr double round_off = 1e-12;

using Map = std::function<Coordinates(double, double)>;

/// A mesh of nx times ny cells: `map` takes the unit square to the surface.
/// The cells begin at different corners, as those of a mesh generator do.
/// With `closed`, the two ends in the first direction are one line.
class Grid
{
public:
  Grid(const unsigned int nx, const unsigned int ny, const unsigned int order,
       Map map, const bool closed = false)
      : nx_(nx), ny_(ny), map_(std::move(map)), closed_(closed)
  {
    mesh.order = order;
    for (unsigned int j = 0; j < ny; ++j)
      for (unsigned int i = 0; i < nx; ++i)
        mesh.quads.push_back(make_quad(i, j));
  }

  unsigned int get_vertex(const unsigned int i, const unsigned int j)
  {
    return get_node(2 * i, 2 * j, vertices_, mesh.vertices);
  }

  MeshQuad& get_quad(const unsigned int i, const unsigned int j)
  {
    return mesh.quads[j * nx_ + i];
  }

  void add_line(const unsigned int i, const unsigned int j,
                const bool along_first, const std::set<std::string>& groups)
  {
    MeshLine line;
    line.vertices = {get_vertex(i, j),
                     get_vertex(i + along_first, j + !along_first)};
    line.group_set = mesh.groups.add(1, groups);
    mesh.lines.push_back(line);
  }

  MeshData mesh;

private:
  using Numbers = std::map<std::pair<unsigned int, unsigned int>, unsigned int>;

  unsigned int get_node(unsigned int i, const unsigned int j, Numbers& numbers,
                        std::vector<Coordinates>& coordinates)
  {
    if (closed_)
      i %= 2 * nx_;
    const auto [entry, is_new] = numbers.try_emplace({i, j}, numbers.size());
    if (is_new)
      coordinates.push_back(map_(.5 * i / nx_, .5 * j / ny_));
    return entry->second;
  }

  MeshQuad make_quad(const unsigned int i, const unsigned int j)
  {
    const unsigned int corners[4][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    const unsigned int middles[4][2] = {{1, 0}, {2, 1}, {1, 2}, {0, 1}};
    const unsigned int first = (i + 3 * j) % 4;
    MeshQuad quad;
    for (unsigned int k = 0; k < 4; ++k)
    {
      const auto& corner = corners[(k + first) % 4];
      const auto& middle = middles[(k + first) % 4];
      quad.vertices[k] = get_node(2 * i + corner[0], 2 * j + corner[1],
                                  vertices_, mesh.vertices);
      quad.middles[k] = get_node(2 * i + middle[0], 2 * j + middle[1], middles_,
                                 mesh.middle_points);
    }
    quad.middles[4] =
        get_node(2 * i + 1, 2 * j + 1, middles_, mesh.middle_points);
    return quad;
  }

  unsigned int nx_;
  unsigned int ny_;
  Map map_;
  bool closed_;
  Numbers vertices_;
  Numbers middles_;
};

inline Coordinates rectangle(const double s, const double t)
{
  return {3 * s, 2 * t, 0};
}

/// Ring of the radii 1 and 2, normal +z.
inline Coordinates ring(const double s, const double t)
{
  const double radius = 2 - t;
  return {radius * std::cos(2 * pi * s), radius * std::sin(2 * pi * s), 0};
}

inline double sum_over_ranks(const double value)
{
  return dealii::Utilities::MPI::sum(value, MPI_COMM_WORLD);
}

/// Refines the cells that `selected` names, once.
inline void refine(Triangulation& triangulation,
                   const std::function<bool(const dealii::Point<3>&)>& selected)
{
  for (const auto& cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && selected(cell->center()))
      cell->set_refine_flag();
  triangulation.execute_coarsening_and_refinement();
}
} // namespace taut::fe
