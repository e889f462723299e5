#include <taut/io/film_patches.h>
#include <taut/structure/point_fields.h>

#include <deal.II/fe/fe_tools.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <limits>

namespace taut::io
{
namespace
{
using structure::PointFields;
using structure::Structure;

unsigned int count_networks(const structure::Device& device)
{
  std::size_t n = 0;
  for (const auto& film : device.films)
    n = std::max(n, film.material.networks.size());
  return n;
}

void name_columns(const bool has_velocity, const unsigned int n_networks,
                  PatchColumns& columns)
{
  columns.add_vector("displacement", "m");
  if (has_velocity)
    columns.add_vector("velocity", "m/s");
  columns.add_scalar("stretch_1");
  columns.add_scalar("stretch_2");
  columns.add_scalar("stress_1", "Pa");
  columns.add_scalar("stress_2", "Pa");
  columns.add_scalar("true_field", "V/m");
  columns.add_scalar("breakdown_margin");
  columns.add_scalar("thickness", "m");
  for (unsigned int m = 1; m <= n_networks; ++m)
    for (const char* which : {"1", "2"})
      columns.add_scalar("network_" + std::to_string(m) + "_stretch_" + which);
  columns.add_vector("stress_direction_1");
  columns.add_vector("wrinkle_direction");
  columns.add_scalar("wrinkle_strain");
  columns.add_scalar("tension");
  for (const char* name : {"film", "electrode", "rank"})
    columns.add_scalar(name);
}

/// What is extrapolated from the quadrature points, in the order of columns.
std::vector<double> get_smooth_values(const PointFields& point,
                                      const unsigned int n_networks)
{
  std::vector<double> values{point.stretches[0], point.stretches[1],
                             point.stresses[0],  point.stresses[1],
                             point.true_field,   point.breakdown_margin,
                             point.thickness};
  for (const auto& stretches : point.internal_stretches)
    values.insert(values.end(), stretches.begin(), stretches.end());
  values.resize(values.size() +
                    2 * (n_networks - point.internal_stretches.size()),
                std::numeric_limits<double>::quiet_NaN());
  return values;
}

/// From the quadrature points of a cell to its nodes.
class PointsToNodes
{
public:
  explicit PointsToNodes(const fe::ReferenceElement& element)
      : n_(element.n_nodes), weights_(n_, n_), nearest_(n_)
  {
    dealii::FullMatrix<double> values(n_, n_, element.values.data());
    weights_.invert(values);
    for (unsigned int a = 0; a < n_; ++a)
      for (unsigned int q = 1; q < n_; ++q)
        if (values(q, a) > values(nearest_[a], a))
          nearest_[a] = q;
  }

  /// The point at which the node's shape function is largest.
  unsigned int nearest(const unsigned int node) const
  {
    return nearest_[node];
  }

  /// The polynomial through `values` at the points, at the node.
  std::vector<double>
  extrapolate(const std::vector<std::vector<double>>& values,
              const unsigned int node) const
  {
    std::vector<double> result(values.front().size(), 0.);
    for (unsigned int q = 0; q < n_; ++q)
      for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += weights_(node, q) * values[q][i];
    return result;
  }

private:
  unsigned int n_;
  dealii::FullMatrix<double> weights_;
  std::vector<unsigned int> nearest_;
};

/// Nodal values of the whole film, with ghosts.
struct NodalFields
{
  fe::NodalVector positions;
  /// Without entries if there is no inertia.
  fe::NodalVector velocities;
};

NodalFields compute_nodal_fields(const double time,
                                 structure::StructureSystem& system,
                                 const double* state)
{
  Structure& structure = system.structure();
  const auto loads = system.loads_at(time, state);
  NodalFields fields;
  fields.positions = structure.compute_positions(loads, state);
  if (const double* v = system.velocities(state))
    fields.velocities = structure.compute_velocities(loads, v);
  return fields;
}

void add_vector(const fe::NodalVector& nodal, const fe::LocalNode node,
                std::vector<double>& values)
{
  for (unsigned int d = 0; d < 3; ++d)
    values.push_back(fe::entry(nodal, 3 * node + d));
}

/// Turns cells into patches.
class PatchMaker
{
public:
  PatchMaker(const Structure& structure, const NodalFields& nodal,
             const std::vector<PointFields>& points,
             const unsigned int n_networks)
      : structure_(structure), cells_(structure.cells()), nodal_(nodal),
        points_(points), n_networks_(n_networks), to_nodes_(cells_.element()),
        // deal.II numbers the vertices first, a patch row by row.
        nodes_(dealii::FETools::lexicographic_to_hierarchic_numbering<2>(
            cells_.element().degree)),
        rank_(
            dealii::Utilities::MPI::this_mpi_process(structure.communicator()))
  {
  }

  dealii::DataOutBase::Patch<2, 3> make(const unsigned int cell,
                                        const unsigned int n_columns) const
  {
    const unsigned int n = cells_.element().n_nodes;
    std::vector<std::vector<double>> smooth;
    for (unsigned int q = 0; q < n; ++q)
      smooth.push_back(get_smooth_values(points_[cell * n + q], n_networks_));
    dealii::DataOutBase::Patch<2, 3> patch;
    patch.patch_index = cell;
    patch.reference_cell = dealii::ReferenceCells::Quadrilateral;
    patch.n_subdivisions = cells_.element().degree;
    patch.points_are_available = true;
    patch.data.reinit(n_columns + 3, n);
    for (unsigned int i = 0; i < n; ++i)
    {
      const auto values = make_column(cell, nodes_[i], smooth);
      for (unsigned int row = 0; row < values.size(); ++row)
        patch.data(row, i) = values[row];
    }
    set_vertices(patch);
    return patch;
  }

private:
  /// All values of one node and its position in the mesh.
  std::vector<double>
  make_column(const unsigned int cell, const unsigned int a,
              const std::vector<std::vector<double>>& smooth) const
  {
    const fe::FilmCell& film_cell = cells_.cells()[cell];
    const fe::LocalNode node = film_cell.nodes[a];
    const auto& mesh_position = structure_.nodes().mesh_position[node];
    std::vector<double> values;
    add_vector(nodal_.positions, node, values);
    for (unsigned int d = 0; d < 3; ++d)
      values[d] -= mesh_position[d];
    if (nodal_.velocities.size() > 0)
      add_vector(nodal_.velocities, node, values);
    const auto extrapolated = to_nodes_.extrapolate(smooth, a);
    values.insert(values.end(), extrapolated.begin(), extrapolated.end());
    const PointFields& nearest =
        points_[cell * smooth.size() + to_nodes_.nearest(a)];
    for (const auto& direction :
         {nearest.stress_directions[0], nearest.wrinkle_direction})
      values.insert(values.end(), direction.begin(), direction.end());
    values.push_back(nearest.wrinkle_strain);
    values.push_back(static_cast<double>(nearest.tension));
    values.push_back(film_cell.film);
    values.push_back(film_cell.electrode);
    values.push_back(rank_);
    values.insert(values.end(), mesh_position.begin(), mesh_position.end());
    return values;
  }

  static void set_vertices(dealii::DataOutBase::Patch<2, 3>& patch)
  {
    const unsigned int last = patch.n_subdivisions;
    const unsigned int first_row = patch.data.n_rows() - 3;
    for (unsigned int vertex = 0; vertex < 4; ++vertex)
      for (unsigned int d = 0; d < 3; ++d)
        patch.vertices[vertex][d] = patch.data(
            first_row + d, last * ((vertex & 1) + (vertex >> 1) * (last + 1)));
  }

  const Structure& structure_;
  const fe::FilmCells& cells_;
  const NodalFields& nodal_;
  const std::vector<PointFields>& points_;
  const unsigned int n_networks_;
  const PointsToNodes to_nodes_;
  const std::vector<unsigned int> nodes_;
  const unsigned int rank_;
};
} // namespace

FilmPatches make_film_patches(const double time,
                              structure::StructureSystem& system,
                              const double* state)
{
  Structure& structure = system.structure();
  const NodalFields nodal = compute_nodal_fields(time, system, state);
  const auto points = structure::compute_point_fields(
      structure, system.loads_at(time, state), state, system.internal(state));
  const unsigned int n_networks = count_networks(structure.device());
  FilmPatches film;
  name_columns(nodal.velocities.size() > 0, n_networks, film);
  const PatchMaker maker(structure, nodal, points, n_networks);
  for (unsigned int cell = 0; cell < structure.cells().cells().size(); ++cell)
    film.patches.push_back(maker.make(cell, film.names.size()));
  return film;
}
} // namespace taut::io
