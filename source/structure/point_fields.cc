#include <taut/material/principal.h>
#include <taut/structure/point_fields.h>

#include <cmath>

namespace taut::structure
{
namespace
{
using Metric = material::SymmetricTensor2<double>;
/// Columns of the deformation gradient, [material axis][component].
using Gradient = std::array<Direction, 2>;

/// F = sum_a x_a (x) G_a in every lane of point `q`.
Gradient compute_gradient(const fe::BatchGeometry& geometry,
                          const std::vector<double>& positions,
                          const unsigned int q, const unsigned int lane)
{
  Gradient F{};
  for (unsigned int a = 0; a < geometry.n_nodes; ++a)
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
      const double slope =
          geometry
              .gradients[((q * geometry.n_nodes + a) * 2 + axis) * 8 + lane];
      for (unsigned int d = 0; d < 3; ++d)
        F[axis][d] += slope * positions[(3 * a + d) * 8 + lane];
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

/// Where a point lies and what it is made of.
struct Place
{
  const fe::BatchLaw& law;
  const fe::FilmSection& film;
  /// Of its networks.
  std::vector<Metric> internal;
};

double get_nominal_field(const Place& place)
{
  return std::sqrt(place.law.field.nominal_squared);
}

Metric compute_stress(const Place& place, const Metric& C)
{
  return material::stress(*place.law.elastomer, C, place.internal.data(),
                          place.law.field);
}

std::vector<Metric> get_internal(const fe::FilmCells& cells,
                                 const double* internal,
                                 const unsigned int cell, const unsigned int q)
{
  std::vector<Metric> result(cells.n_networks(cell));
  const double* A =
      internal + cells.first_internal(cell) + 3ul * q * result.size();
  for (Metric& tensor : result)
  {
    tensor = {A[0], A[1], A[2]};
    A += 3;
  }
  return result;
}

/// Calls function(index, place, F) for every point of this rank.
template <typename Function>
void for_each_point(Structure& structure, const LoadState& loads,
                    const double* u, const double* internal,
                    const Function& function)
{
  const fe::FilmCells& cells = structure.cells();
  const auto laws = structure.make_laws(loads, Networks::as_given);
  const auto& nodal = structure.compute_positions(loads, u);
  const unsigned int n = cells.element().n_nodes;
  std::vector<double> positions(cells.nodal_size());
  for (unsigned int b = 0; b < cells.batches().size(); ++b)
  {
    const fe::FilmBatch& batch = cells.batches()[b];
    cells.gather(b, nodal, positions.data());
    for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
      for (unsigned int q = 0; q < n; ++q)
      {
        const unsigned int cell = batch.cells[lane];
        function(cell * n + q,
                 Place{laws[batch.slot],
                       cells.films()[cells.cells()[cell].film],
                       get_internal(cells, internal, cell, q)},
                 compute_gradient(cells.geometry(b), positions, q, lane));
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

PointFields make_point_fields(const Place& place, const Gradient& F)
{
  const Metric C = compute_metric(F);
  const auto stretches = material::compute_principal_stretches(C);
  const auto stresses =
      material::compute_principal_stresses(C, compute_stress(place, C));
  PointFields fields;
  fields.stretches = stretches.values;
  fields.stresses = stresses.values;
  for (unsigned int i = 0; i < 2; ++i)
  {
    fields.stretch_directions[i] = push_forward(F, stretches.directions[i]);
    fields.stress_directions[i] = push_forward(F, stresses.directions[i]);
  }
  const double field = get_nominal_field(place);
  fields.true_field = material::compute_true_field(C, field);
  fields.breakdown_margin = material::compute_breakdown_margin(
      place.law.elastomer->dielectric, C, field);
  fields.thickness =
      place.film.thickness / std::sqrt(material::compute_determinant(C));
  fields.tension = classify(stresses.values);
  for (const Metric& A : place.internal)
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
  std::vector<CriticalValues> values(count_points(structure));
  for_each_point(
      structure, loads, u, internal,
      [&](const std::size_t point, const Place& place, const Gradient& F)
      {
        const Metric C = compute_metric(F);
        values[point] = {
            material::compute_principal_stresses(C, compute_stress(place, C))
                .values[1],
            material::compute_true_field(C, get_nominal_field(place))};
      });
  return values;
}

std::vector<PointFields> compute_point_fields(Structure& structure,
                                              const LoadState& loads,
                                              const double* u,
                                              const double* internal)
{
  std::vector<PointFields> fields(count_points(structure));
  for_each_point(
      structure, loads, u, internal,
      [&](const std::size_t point, const Place& place, const Gradient& F)
      { fields[point] = make_point_fields(place, F); });
  return fields;
}
} // namespace taut::structure
