#include <taut/base/exceptions.h>
#include <taut/material/principal.h>
#include <taut/material/tension_field.h>
#include <taut/structure/point_fields.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

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
  double field_rate; ///< |d(V/H)/dt| (V/(m s))
  double humidity;   ///< of the air, 0 to 1
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

material::Exposure get_exposure(const Point& point)
{
  return {get_nominal_field(point), point.field_rate, point.film.thickness,
          point.law.field.temperature, point.humidity};
}

bool has_tension_field(const Point& point)
{
  return point.law.wrinkle_stiffness > 0;
}

Metric compute_stress(const Point& point, const Metric& C)
{
  return material::stress(*point.law.elastomer, C, point.internal.data(),
                          point.law.field);
}

/// The eigenvalues of S C, the larger first, accurate also where both are
/// equal.
std::array<double, 2> compute_stresses(const Metric& C, const Metric& S)
{
  const double xx = S.xx * C.xx + S.xy * C.xy;
  const double yy = S.xy * C.xy + S.yy * C.yy;
  const double xy = S.xx * C.xy + S.xy * C.yy;
  const double yx = S.xy * C.xx + S.yy * C.xy;
  const double mean = (xx + yy) / 2;
  const double half_difference = (xx - yy) / 2;
  const double square = half_difference * half_difference + xy * yx;
  const double radius = std::sqrt(std::max(square, 0.));
  return {mean + radius, mean - radius};
}

Tension classify(const std::array<double, 2>& stresses)
{
  if (stresses[0] <= 0)
    return Tension::slack;
  return stresses[1] <= 0 ? Tension::wrinkled : Tension::taut;
}

/// What a point carries.
struct State
{
  Tension tension;
  Metric flat_stress; ///< without wrinkles
  Metric metric;      ///< C*, of the film with its wrinkles
  Metric stress;
  /// C^-1 E C^-1; its principal values in the metric C are those of C^-1 E.
  Metric wrinkles;
};

State compute_state(const Point& point, const Metric& C)
{
  const Metric S = compute_stress(point, C);
  State state{classify(compute_stresses(C, S)), S, C, S, {0, 0, 0}};
  if (!has_tension_field(point))
    return state;
  const auto wrinkles =
      material::find_wrinkles(*point.law.elastomer, C, point.internal.data(),
                              point.law.field, S, point.law.wrinkle_stiffness);
  state.tension = wrinkles.slack      ? Tension::slack
                  : wrinkles.wrinkled ? Tension::wrinkled
                                      : Tension::taut;
  state.metric = wrinkles.metric;
  state.stress = compute_stress(point, state.metric);
  state.wrinkles =
      material::sandwich(material::compute_inverse(C),
                         material::compute_wrinkle_strain(wrinkles, C));
  return state;
}

CriticalValues make_critical_values(const Point& point, const Metric& C)
{
  const State state = compute_state(point, C);
  double larger = compute_stresses(C, state.stress)[0];
  if (has_tension_field(point) && state.tension == Tension::slack)
    larger = -material::shear_modulus(*point.law.elastomer) *
             compute_stresses(C, state.wrinkles)[1];
  return {compute_stresses(C, state.flat_stress)[1], larger,
          material::compute_true_field(state.metric, get_nominal_field(point))};
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

double compute_field_rate(const fe::FilmCells& cells, const LoadState& loads,
                          const fe::LawSlot& slot)
{
  if (slot.electrode < 0)
    return 0;
  return std::abs(loads.voltage_rates[slot.electrode]) /
         cells.films()[slot.film].thickness;
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
    const fe::LawSlot& slot = cells.slots()[batch.slot];
    const fe::FilmSection& film = cells.films()[slot.film];
    const double field_rate = compute_field_rate(cells, loads, slot);
    for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
      for (unsigned int q = 0; q < n; ++q)
      {
        const unsigned int cell = batch.cells[lane];
        read_internal(cells, internal, cell, q, A);
        function(Point{cell * n + q, b, lane, q, laws[batch.slot], film, A,
                       field_rate, loads.film_humidities[slot.film]});
      }
  }
}

/// The same for a function that asks laws with a range. Throws on every rank,
/// with the place, where one is left on any.
template <typename Function>
void for_each_point_within_laws(const Structure& structure,
                                const LoadState& loads, const double* internal,
                                const Function& function)
{
  const fe::FilmCells& cells = structure.cells();
  std::string refusal;
  for_each_point(structure, loads, internal,
                 [&](const Point& point)
                 {
                   if (!refusal.empty())
                     return;
                   try
                   {
                     function(point);
                   }
                   catch (const StepRejected& rejected)
                   {
                     const auto place = cells.mesh_point(
                         point.index / cells.element().n_nodes, point.q);
                     refusal = std::string(rejected.what()) + "; near (" +
                               std::to_string(place[0]) + ", " +
                               std::to_string(place[1]) + ", " +
                               std::to_string(place[2]) + ") m of the mesh";
                   }
                 });
  const auto refusals =
      dealii::Utilities::MPI::all_gather(structure.communicator(), refusal);
  for (const std::string& one : refusals)
    if (!one.empty())
      throw StepRejected(one);
}

std::size_t count_points(const Structure& structure)
{
  return structure.cells().cells().size() * structure.cells().element().n_nodes;
}

Metric compute_metric(const Gradient& F)
{
  return {dot(F[0], F[0]), dot(F[1], F[1]), dot(F[0], F[1])};
}

/// What is only shown does not end a run.
double show_breakdown_margin(const Point& point, const Metric& C)
{
  try
  {
    return material::compute_breakdown_margin(point.law.elastomer->dielectric,
                                              C, get_exposure(point));
  }
  catch (const StepRejected&)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

PointFields make_point_fields(const Point& point, const Gradient& F)
{
  const Metric C = compute_metric(F);
  const State state = compute_state(point, C);
  const auto stretches = material::compute_principal_stretches(C);
  const auto stresses = material::compute_principal_stresses(C, state.stress);
  PointFields fields;
  fields.stretches = stretches.values;
  fields.stresses = stresses.values;
  for (unsigned int i = 0; i < 2; ++i)
  {
    fields.stretch_directions[i] = push_forward(F, stretches.directions[i]);
    fields.stress_directions[i] = push_forward(F, stresses.directions[i]);
  }
  fields.true_field =
      material::compute_true_field(state.metric, get_nominal_field(point));
  fields.breakdown_margin = show_breakdown_margin(point, state.metric);
  fields.thickness = point.film.thickness /
                     std::sqrt(material::compute_determinant(state.metric));
  fields.tension = state.tension;
  const auto wrinkles = material::compute_principal_stresses(C, state.wrinkles);
  fields.wrinkle_strain = std::sqrt(1 + wrinkles.values[0]) - 1;
  fields.wrinkle_direction = {0, 0, 0};
  if (fields.wrinkle_strain > 0)
    fields.wrinkle_direction = push_forward(F, wrinkles.directions[0]);
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
        values[point.index] = make_critical_values(point, {xx, yy, xy});
      });
  return values;
}

std::vector<BreakdownValues> compute_breakdown_values(Structure& structure,
                                                      const LoadState& loads,
                                                      const double* u,
                                                      const double* internal)
{
  const auto metric = fe::compute_wrinkled_metric(
      structure.cells(), structure.make_laws(loads, Networks::as_given),
      structure.compute_positions(loads, u), internal);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<BreakdownValues> values(count_points(structure), {1, infinity});
  for_each_point_within_laws(
      structure, loads, internal,
      [&](const Point& point)
      {
        const auto exposure = get_exposure(point);
        if (exposure.nominal_field == 0)
          return;
        const auto& [xx, yy, xy] = metric[point.index];
        const Metric C = {xx, yy, xy};
        const auto& dielectric = point.law.elastomer->dielectric;
        values[point.index] = {
            material::compute_breakdown_margin(dielectric, C, exposure),
            material::compute_strength(dielectric, C, exposure)};
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
