#include <taut/material/principal.h>
#include <taut/structure/point_fields.h>

#include <algorithm>
#include <cmath>

namespace taut::structure
{
namespace
{
using Metric = material::SymmetricTensor2<double>;
/// Columns of the deformation gradient, [material axis][component].
using Gradient = std::array<Direction, 2>;

/// One point of a film and what it is made of.
struct Point
{
  std::size_t index; ///< among all points of this rank
  unsigned int batch, lane, q;
  const fe::BatchLaw& law;
  const fe::FilmSection& film;
  /// Of its networks.
  const std::vector<Metric>& internal;
};

/// F = sum_a x_a (x) G_a.
Gradient compute_gradient(const fe::FilmCells& cells,
                          const fe::NodalVector& positions, const Point& point)
{
  const fe::BatchGeometry geometry = cells.geometry(point.batch);
  const unsigned int cell = cells.batches()[point.batch].cells[point.lane];
  const auto& nodes = cells.cells()[cell].nodes;
  const double* slope =
      geometry.gradients + 16ul * point.q * geometry.n_nodes + point.lane;
  Gradient F{};
  for (const fe::LocalNode node : nodes)
    for (Direction& column : F)
    {
      for (unsigned int d = 0; d < 3; ++d)
        column[d] += *slope * fe::entry(positions, 3 * node + d);
      slope += 8;
    }
  return F;
}

double dot(const Direction& a, const Direction& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The direction into which F turns a material line.
Direction push_forward(const Gradient& F, const std::array<double, 2>& line)
{
  Direction result;
  for (unsigned int d = 0; d < 3; ++d)
    result[d] = F[0][d] * line[0] + F[1][d] * line[1];
  const double length = std::sqrt(dot(result, result));
  for (double& component : result)
    component /= length;
  return result;
}

double get_nominal_field(const Point& point)
{
  return std::sqrt(point.law.field.nominal_squared);
}

Metric compute_stress(const Point& point, const Metric& C)
{
  return material::stress(*point.law.elastomer, C, point.internal.data(),
                          point.law.field);
}

/// The smaller eigenvalue of S C, accurate also where both are equal.
double compute_smaller_stress(const Metric& C, const Metric& S)
{
  const double xx = S.xx * C.xx + S.xy * C.xy;
  const double yy = S.xy * C.xy + S.yy * C.yy;
  const double xy = S.xx * C.xy + S.xy * C.yy;
  const double yx = S.xy * C.xx + S.yy * C.xy;
  const double half_difference = (xx - yy) / 2;
  const double square = half_difference * half_difference + xy * yx;
  return (xx + yy) / 2 - std::sqrt(std::max(square, 0.));
}

/// The internal variables of all networks of a point of a cell.
void read_internal(const fe::FilmCells& cells, const double* internal,
                   const unsigned int cell, const unsigned int q,
                   std::vector<Metric>& result)
{
  result.resize(cells.n_networks(cell));
  const double* A =
      internal + cells.first_internal(cell) + 3ul * q * result.size();
  for (Metric& tensor : result)
  {
    tensor = {A[0], A[1], A[2]};
    A += 3;
  }
}

/// Calls function(point) for every point of this rank.
template <typename Function>
void for_each_point(const Structure& structure, const LoadState& loads,
                    const double* internal, const Function& function)
{
  const fe::FilmCells& cells = structure.cells();
  const auto laws = structure.make_laws(loads, Networks::as_given);
  const unsigned int n = cells.element().n_nodes;
  std::vector<Metric> A;
  for (unsigned int b = 0; b < cells.batches().size(); ++b)
  {
    const fe::FilmBatch& batch = cells.batches()[b];
    const fe::FilmSection& film = cells.films()[cells.slots()[batch.slot].film];
    for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
      for (unsigned int q = 0; q < n; ++q)
      {
        const unsigned int cell = batch.cells[lane];
        read_internal(cells, internal, cell, q, A);
        function(Point{cell * n + q, b, lane, q, laws[batch.slot], film, A});
      }
  }
}

std::size_t count_points(const Structure& structure)
{
  return structure.cells().cells().size() * structure.cells().element().n_nodes;
}

Metric compute_metric(const Gradient& F)
{
  return {dot(F[0], F[0]), dot(F[1], F[1]), dot(F[0], F[1])};
}

Tension classify(const std::array<double, 2>& stresses)
{
  if (stresses[0] <= 0)
    return Tension::slack;
  return stresses[1] <= 0 ? Tension::wrinkled : Tension::taut;
}

PointFields make_point_fields(const Point& point, const Gradient& F)
{
  const Metric C = compute_metric(F);
  const auto stretches = material::compute_principal_stretches(C);
  const auto stresses =
      material::compute_principal_stresses(C, compute_stress(point, C));
  PointFields fields;
  fields.stretches = stretches.values;
  fields.stresses = stresses.values;
  for (unsigned int i = 0; i < 2; ++i)
  {
    fields.stretch_directions[i] = push_forward(F, stretches.directions[i]);
    fields.stress_directions[i] = push_forward(F, stresses.directions[i]);
  }
  const double field = get_nominal_field(point);
  fields.true_field = material::compute_true_field(C, field);
  fields.breakdown_margin = material::compute_breakdown_margin(
      point.law.elastomer->dielectric, C, field);
  fields.thickness =
      point.film.thickness / std::sqrt(material::compute_determinant(C));
  fields.tension = classify(stresses.values);
  for (const Metric& A : point.internal)
    fields.internal_stretches.push_back(
        material::compute_principal_stretches(material::compute_inverse(A))
            .values);
  return fields;
}
} // namespace

std::vector<CriticalValues> compute_critical_values(Structure& structure,
                                                    const LoadState& loads,
                                                    const double* u,
                                                    const double* internal)
{
  const auto metric = fe::compute_metric(structure.cells(),
                                         structure.compute_positions(loads, u));
  std::vector<CriticalValues> values(count_points(structure));
  for_each_point(
      structure, loads, internal,
      [&](const Point& point)
      {
        const auto& [xx, yy, xy] = metric[point.index];
        const Metric C{xx, yy, xy};
        values[point.index] = {
            compute_smaller_stress(C, compute_stress(point, C)),
            material::compute_true_field(C, get_nominal_field(point))};
      });
  return values;
}

std::vector<PointFields> compute_point_fields(Structure& structure,
                                              const LoadState& loads,
                                              const double* u,
                                              const double* internal)
{
  const auto& positions = structure.compute_positions(loads, u);
  std::vector<PointFields> fields(count_points(structure));
  for_each_point(structure, loads, internal,
                 [&](const Point& point)
                 {
                   fields[point.index] = make_point_fields(
                       point,
                       compute_gradient(structure.cells(), positions, point));
                 });
  return fields;
}
} // namespace taut::structure
