#include <taut/base/exceptions.h>
#include <taut/fe/film_cells.h>
#include <taut/fe/vector3.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace taut::fe
{
namespace
{
using Vector3 = std::array<double, 3>;

Vector3 scaled(const Vector3& a, const double factor)
{
  return {a[0] * factor, a[1] * factor, a[2] * factor};
}

std::string place(const Vector3& x)
{
  return "(" + std::to_string(x[0]) + ", " + std::to_string(x[1]) + ", " +
         std::to_string(x[2]) + ") m";
}

/// Point of the mesh, its tangents and what follows from them.
struct SurfacePoint
{
  Vector3 position{}, xi{}, eta{};
};

SurfacePoint make_surface_point(const ReferenceElement& element,
                                const unsigned int q,
                                const std::vector<LocalNode>& nodes,
                                const std::vector<Vector3>& positions)
{
  SurfacePoint point;
  for (unsigned int a = 0; a < element.n_nodes; ++a)
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double x = positions[nodes[a]][d];
      const unsigned int i = q * element.n_nodes + a;
      point.position[d] += element.values[i] * x;
      point.xi[d] += element.gradients[2 * i] * x;
      point.eta[d] += element.gradients[2 * i + 1] * x;
    }
  return point;
}

/// Tangent unit vectors: the film's axis projected into the surface, and the
/// one across it.
std::array<Vector3, 2> make_axes(const SurfacePoint& point, const Vector3& axis,
                                 const double orientation)
{
  const Vector3 normal = scaled(cross(point.xi, point.eta), orientation);
  const double area = std::sqrt(dot(normal, normal));
  if (!(area > 0))
    throw BadInput("the mesh has a cell without area at " +
                   place(point.position));
  const Vector3 n = scaled(normal, 1 / area);
  Vector3 e1 = axis;
  for (unsigned int d = 0; d < 3; ++d)
    e1[d] -= dot(axis, n) * n[d];
  const double length = std::sqrt(dot(e1, e1));
  if (length < 1e-6 * std::sqrt(dot(axis, axis)))
    throw BadInput("the film's axis is normal to its surface at " +
                   place(point.position) + "; choose one that is not");
  e1 = scaled(e1, 1 / length);
  return {e1, cross(n, e1)};
}
} // namespace

FilmCells::FilmCells(const unsigned int degree, std::vector<FilmSection> films,
                     std::vector<FilmCell> cells,
                     const std::vector<Vector3>& mesh_positions)
    : element_(degree), films_(std::move(films)), cells_(std::move(cells))
{
  for (unsigned int cell = 0; cell < cells_.size(); ++cell)
  {
    first_internal_.push_back(n_internal_);
    n_internal_ += 3ul * element_.n_nodes * n_networks(cell);
  }
  make_batches();
  compute_geometry(mesh_positions);
}

unsigned int FilmCells::n_networks(const unsigned int cell) const
{
  return films_[cells_[cell].film].elastomer->networks.size();
}

void FilmCells::make_batches()
{
  std::map<std::pair<unsigned int, int>, std::vector<unsigned int>> by_slot;
  for (unsigned int cell = 0; cell < cells_.size(); ++cell)
    by_slot[{cells_[cell].film, cells_[cell].electrode}].push_back(cell);
  batch_and_lane_.resize(cells_.size());
  for (const auto& [key, members] : by_slot)
  {
    slots_.push_back({key.first, key.second});
    for (std::size_t first = 0; first < members.size(); first += 8)
    {
      FilmBatch batch;
      batch.n_cells = std::min<std::size_t>(8, members.size() - first);
      batch.slot = slots_.size() - 1;
      for (unsigned int lane = 0; lane < 8; ++lane)
        batch.cells[lane] = members[first + std::min(lane, batch.n_cells - 1)];
      for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
        batch_and_lane_[batch.cells[lane]] = {batches_.size(), lane};
      max_batch_internal_ =
          std::max(max_batch_internal_,
                   std::size_t(8 * 3) * element_.n_nodes *
                       films_[key.first].elastomer->networks.size());
      batches_.push_back(batch);
    }
  }
}

void FilmCells::compute_geometry(const std::vector<Vector3>& mesh_positions)
{
  const unsigned int n = element_.n_nodes;
  gradients_.resize(batches_.size() * 16 * n * n, 0.);
  volumes_.resize(batches_.size() * 8 * n, 0.);
  frames_.resize(cells_.size() * n);
  for (unsigned int b = 0; b < batches_.size(); ++b)
    for (unsigned int lane = 0; lane < 8; ++lane)
    {
      const unsigned int index = batches_[b].cells[lane];
      const FilmCell& cell = cells_[index];
      const FilmSection& film = films_[cell.film];
      for (unsigned int q = 0; q < n; ++q)
      {
        const auto point =
            make_surface_point(element_, q, cell.nodes, mesh_positions);
        const auto axes = make_axes(point, film.axis, cell.orientation);
        // Tangents in the material axes, their determinant and inverse.
        const double t11 = dot(axes[0], point.xi);
        const double t12 = dot(axes[0], point.eta);
        const double t21 = dot(axes[1], point.xi);
        const double t22 = dot(axes[1], point.eta);
        const double det = t11 * t22 - t12 * t21;
        for (unsigned int a = 0; a < n; ++a)
        {
          const double g_xi = element_.gradients[2 * (q * n + a)];
          const double g_eta = element_.gradients[2 * (q * n + a) + 1];
          double* g = &gradients_[((b * n + q) * n + a) * 16 + lane];
          g[0] = film.pre_stretch[0] * (t22 * g_xi - t21 * g_eta) / det;
          g[8] = film.pre_stretch[1] * (-t12 * g_xi + t11 * g_eta) / det;
        }
        if (lane < batches_[b].n_cells)
          volumes_[(b * n + q) * 8 + lane] =
              element_.weights[q] * std::abs(det) * film.thickness /
              (film.pre_stretch[0] * film.pre_stretch[1]);
        auto& frame = frames_[index * n + q];
        std::copy_n(point.position.begin(), 3, frame.begin());
        std::copy_n(axes[0].begin(), 3, frame.begin() + 3);
        std::copy_n(axes[1].begin(), 3, frame.begin() + 6);
      }
    }
}

void FilmCells::set_pre_stretch(const unsigned int film,
                                const std::array<double, 2>& pre_stretch)
{
  if (films_[film].pre_stretch == pre_stretch)
    return;
  const std::size_t n = element_.n_nodes;
  const auto scale =
      [n](const std::array<double, 2>& stretch, const double* plain_gradients,
          const double* plain_volumes, double* gradients, double* volumes)
  {
    for (std::size_t i = 0; i < 16 * n * n; ++i)
      gradients[i] = stretch[i / 8 % 2] * plain_gradients[i];
    for (std::size_t i = 0; i < 8 * n; ++i)
      volumes[i] = plain_volumes[i] / (stretch[0] * stretch[1]);
  };
  if (plain_gradients_.empty())
  {
    plain_gradients_ = gradients_;
    plain_volumes_ = volumes_;
    for (std::size_t b = 0; b < batches_.size(); ++b)
    {
      const auto& [first, second] =
          films_[slots_[batches_[b].slot].film].pre_stretch;
      scale({1 / first, 1 / second}, &gradients_[b * 16 * n * n],
            &volumes_[b * 8 * n], &plain_gradients_[b * 16 * n * n],
            &plain_volumes_[b * 8 * n]);
    }
  }
  films_[film].pre_stretch = pre_stretch;
  for (std::size_t b = 0; b < batches_.size(); ++b)
    if (slots_[batches_[b].slot].film == film)
      scale(pre_stretch, &plain_gradients_[b * 16 * n * n],
            &plain_volumes_[b * 8 * n], &gradients_[b * 16 * n * n],
            &volumes_[b * 8 * n]);
}

BatchGeometry FilmCells::geometry(const unsigned int batch) const
{
  const unsigned int n = element_.n_nodes;
  return {n, &gradients_[batch * 16ul * n * n], &volumes_[batch * 8ul * n]};
}

double FilmCells::volume(const unsigned int cell, const unsigned int q) const
{
  const auto [batch, lane] = batch_and_lane_[cell];
  return volumes_[(batch * element_.n_nodes + q) * 8 + lane];
}

Vector3 FilmCells::mesh_point(const unsigned int cell,
                              const unsigned int q) const
{
  const auto& frame = frames_[cell * element_.n_nodes + q];
  return {frame[0], frame[1], frame[2]};
}

std::array<Vector3, 2> FilmCells::axes(const unsigned int cell,
                                       const unsigned int q) const
{
  const auto& frame = frames_[cell * element_.n_nodes + q];
  return {Vector3{frame[3], frame[4], frame[5]},
          Vector3{frame[6], frame[7], frame[8]}};
}

void FilmCells::gather(const unsigned int batch, const NodalVector& nodal,
                       double* values) const
{
  for (unsigned int lane = 0; lane < 8; ++lane)
  {
    const FilmCell& cell = cells_[batches_[batch].cells[lane]];
    for (unsigned int a = 0; a < element_.n_nodes; ++a)
      for (unsigned int d = 0; d < 3; ++d)
        values[(3 * a + d) * 8 + lane] = entry(nodal, 3 * cell.nodes[a] + d);
  }
}

void FilmCells::gather_internal(const unsigned int batch,
                                const double* internal, double* values) const
{
  for (unsigned int lane = 0; lane < 8; ++lane)
  {
    const unsigned int cell = batches_[batch].cells[lane];
    const double* from = internal + first_internal_[cell];
    const unsigned int n = 3 * element_.n_nodes * n_networks(cell);
    for (unsigned int i = 0; i < n; ++i)
      values[8 * i + lane] = from[i];
  }
}

void FilmCells::scatter_add(const unsigned int batch, const double* values,
                            NodalVector& nodal) const
{
  for (unsigned int lane = 0; lane < batches_[batch].n_cells; ++lane)
  {
    const FilmCell& cell = cells_[batches_[batch].cells[lane]];
    for (unsigned int a = 0; a < element_.n_nodes; ++a)
      for (unsigned int d = 0; d < 3; ++d)
        entry(nodal, 3 * cell.nodes[a] + d) += values[(3 * a + d) * 8 + lane];
  }
}

void FilmCells::scatter_internal(const unsigned int batch, const double* values,
                                 double* internal) const
{
  for (unsigned int lane = 0; lane < batches_[batch].n_cells; ++lane)
  {
    const unsigned int cell = batches_[batch].cells[lane];
    double* to = internal + first_internal_[cell];
    const unsigned int n = 3 * element_.n_nodes * n_networks(cell);
    for (unsigned int i = 0; i < n; ++i)
      to[i] = values[8 * i + lane];
  }
}
} // namespace taut::fe
