#include <taut/fe/film_assembly.h>
#include <taut/material/limits.h>
#include <taut/material/wrinkles.h>

#include <deal.II/base/aligned_vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::fe
{
namespace
{
using Buffer = dealii::AlignedVector<double>;

/// Below zero if it is lost.
double get_margin(const double margin)
{
  return std::isnan(margin) ? -1. : margin;
}

/// Three of the numbers [..][3][lane].
material::SymmetricTensor2<double>
get_lane(const Buffer& tensors, const std::size_t index, const unsigned lane)
{
  const double* const first = tensors.data() + 24 * index + lane;
  return {first[0], first[8], first[16]};
}

/// What is beyond its limit, in which cell of a batch.
struct Excess
{
  unsigned int lane;
  std::string text;
};

Excess find_excess(const FilmCells& cells, const BatchLaw& law,
                   const unsigned int batch, const LimitCheck& check,
                   const NodalVector& positions, const double* internal)
{
  if (check.wrinkles_grow)
    return {check.lane, "the wrinkled film widens without end"};
  const material::Elastomer& elastomer = *law.elastomer;
  Buffer x(cells.nodal_size()), A(cells.internal_size());
  Buffer C(24 * cells.element().n_nodes);
  cells.gather(batch, positions, x.data());
  cells.gather_internal(batch, internal, A.data());
  compute_wrinkled_metric(cells.geometry(batch), law, x.data(), A.data(),
                          C.data());
  Excess excess{0, ""};
  double least = std::numeric_limits<double>::infinity();
  for (unsigned int lane = 0; lane < cells.batches()[batch].n_cells; ++lane)
  {
    const std::size_t n_networks = elastomer.networks.size();
    std::vector<material::SymmetricTensor2<double>> inner;
    for (std::size_t m = 0; m < n_networks; ++m)
      inner.push_back(get_lane(A, n_networks * check.point + m, lane));
    const auto metric = get_lane(C, check.point, lane);
    const double margin = get_margin(
        material::limit_margin(elastomer, metric, inner.data(), law.field));
    if (margin < least)
      excess = {lane, material::describe_limit(elastomer, metric, inner.data(),
                                               law.field)};
    least = std::min(margin, least);
  }
  return excess;
}

LimitReport make_report(const FilmCells& cells, const BatchLaw& law,
                        const unsigned int batch, const LimitCheck& check,
                        const NodalVector& positions, const double* internal)
{
  const FilmBatch& members = cells.batches()[batch];
  LimitReport report{get_margin(check.margin),
                     cells.slots()[members.slot].film};
  if (report.margin > 0)
    return report;
  const Excess excess =
      find_excess(cells, law, batch, check, positions, internal);
  report.excess = excess.text;
  report.place = cells.mesh_point(members.cells[excess.lane], check.point);
  return report;
}
} // namespace

std::vector<BatchLaw> make_laws(const FilmCells& cells,
                                const std::vector<double>& voltages)
{
  std::vector<BatchLaw> laws;
  for (const auto& slot : cells.slots())
  {
    const FilmSection& film = cells.films()[slot.film];
    const double field =
        slot.electrode < 0 ? 0. : voltages[slot.electrode] / film.thickness;
    laws.push_back({film.elastomer,
                    {field * field, film.temperature},
                    film.tension_field
                        ? material::get_wrinkle_stiffness(*film.elastomer)
                        : 0.});
  }
  return laws;
}

LimitReport add_internal_forces(const FilmCells& cells,
                                const std::vector<BatchLaw>& laws,
                                const NodalVector& positions,
                                const double* internal, NodalVector& forces,
                                double* rates, FilmPowers& powers)
{
  Buffer x(cells.nodal_size()), f(cells.nodal_size());
  Buffer A(cells.internal_size()), dA(cells.internal_size());
  powers.dissipation = 0;
  powers.permittivity.assign(cells.slots().size(), 0.);
  LimitReport report;
  for (unsigned int batch = 0; batch < cells.batches().size(); ++batch)
  {
    const FilmBatch& members = cells.batches()[batch];
    cells.gather(batch, positions, x.data());
    cells.gather_internal(batch, internal, A.data());
    BatchPower power;
    const LimitCheck check =
        compute_forces(cells.geometry(batch), laws[members.slot], x.data(),
                       A.data(), f.data(), dA.data(), power);
    if (get_margin(check.margin) < report.margin)
      report = make_report(cells, laws[members.slot], batch, check, positions,
                           internal);
    cells.scatter_add(batch, f.data(), forces);
    cells.scatter_internal(batch, dA.data(), rates);
    for (unsigned int lane = 0; lane < members.n_cells; ++lane)
    {
      powers.dissipation += power.dissipation[lane];
      powers.permittivity[members.slot] += power.permittivity[lane];
    }
  }
  return report;
}

void add_pressure_forces(const FilmCells& cells,
                         const std::vector<PressureLoad>& pressures,
                         const NodalVector& positions, NodalVector& forces)
{
  const ReferenceElement& element = cells.element();
  Buffer x(cells.nodal_size()), f(cells.nodal_size());
  for (const auto& load : pressures)
    for (const auto& lanes : load.batches)
    {
      cells.gather(lanes.batch, positions, x.data());
      compute_pressure_forces(element.n_nodes, element.values.data(),
                              element.gradients.data(), element.weights.data(),
                              lanes.active.data(), x.data(), load.pressure,
                              f.data());
      cells.scatter_add(lanes.batch, f.data(), forces);
    }
}

void add_stiffness(const FilmCells& cells, const std::vector<BatchLaw>& laws,
                   const std::vector<PressureLoad>& pressures,
                   const TangentRequest& request, TangentMatrix& matrix)
{
  const ReferenceElement& element = cells.element();
  Buffer x(cells.nodal_size()), A(cells.internal_size());
  Buffer K(8 * 9 * element.n_nodes * element.n_nodes);
  std::vector<std::vector<std::pair<const PressureLoad*, unsigned int>>>
      pressures_of(cells.batches().size());
  for (const auto& load : pressures)
    for (unsigned int i = 0; i < load.batches.size(); ++i)
      pressures_of[load.batches[i].batch].push_back({&load, i});
  for (unsigned int batch = 0; batch < cells.batches().size(); ++batch)
  {
    const BatchLaw& law = laws[cells.batches()[batch].slot];
    cells.gather(batch, *request.positions, x.data());
    cells.gather_internal(batch, request.internal, A.data());
    const double mass_factor =
        request.inertia
            ? request.alpha *
                  (request.alpha + request.air_drag / law.elastomer->density)
            : 0.;
    const bool turns = matrix.turns(batch);
    compute_stiffness(cells.geometry(batch), law, element.values.data(),
                      turns ? 0. : mass_factor, x.data(), A.data(),
                      request.alpha, request.symmetric, K.data());
    for (const auto& [load, i] : pressures_of[batch])
      add_pressure_stiffness(element.n_nodes, element.values.data(),
                             element.gradients.data(), element.weights.data(),
                             load->batches[i].active.data(), x.data(),
                             load->pressure, request.symmetric, K.data());
    matrix.add_batch(batch, K.data(), request.symmetric, request.positions);
    if (turns && mass_factor != 0)
    {
      compute_mass(cells.geometry(batch), element.values.data(),
                   mass_factor * law.elastomer->density, K.data());
      matrix.add_batch(batch, K.data(), true, nullptr);
    }
  }
}

void add_mass(const FilmCells& cells, const std::vector<double>& densities,
              TangentMatrix& matrix)
{
  const ReferenceElement& element = cells.element();
  Buffer M(8 * 9 * element.n_nodes * element.n_nodes);
  for (unsigned int batch = 0; batch < cells.batches().size(); ++batch)
  {
    compute_mass(cells.geometry(batch), element.values.data(),
                 densities[cells.slots()[cells.batches()[batch].slot].film],
                 M.data());
    matrix.add_batch(batch, M.data(), true, nullptr);
  }
}

void add_mass_product(const FilmCells& cells,
                      const std::vector<double>& densities,
                      const NodalVector& x, NodalVector& result)
{
  const ReferenceElement& element = cells.element();
  const unsigned int n = element.n_nodes;
  for (unsigned int index = 0; index < cells.cells().size(); ++index)
  {
    const FilmCell& cell = cells.cells()[index];
    for (unsigned int q = 0; q < n; ++q)
    {
      const double* values = &element.values[q * n];
      const double mass = densities[cell.film] * cells.volume(index, q);
      for (unsigned int d = 0; d < 3; ++d)
      {
        double at_point = 0;
        for (unsigned int b = 0; b < n; ++b)
          at_point += values[b] * entry(x, 3 * cell.nodes[b] + d);
        for (unsigned int a = 0; a < n; ++a)
          entry(result, 3 * cell.nodes[a] + d) += mass * values[a] * at_point;
      }
    }
  }
}

void add_force_change(const FilmCells& cells, const std::vector<BatchLaw>& laws,
                      const NodalVector& positions, const double* internal,
                      const double alpha, const double* r, NodalVector& forces)
{
  Buffer x(cells.nodal_size()), f(cells.nodal_size());
  Buffer A(cells.internal_size()), b(cells.internal_size());
  for (unsigned int batch = 0; batch < cells.batches().size(); ++batch)
  {
    const BatchLaw& law = laws[cells.batches()[batch].slot];
    if (law.elastomer->networks.empty())
      continue;
    cells.gather(batch, positions, x.data());
    cells.gather_internal(batch, internal, A.data());
    cells.gather_internal(batch, r, b.data());
    compute_force_change(cells.geometry(batch), law, x.data(), A.data(), alpha,
                         b.data(), f.data());
    cells.scatter_add(batch, f.data(), forces);
  }
}

void compute_internal_change(const FilmCells& cells,
                             const std::vector<BatchLaw>& laws,
                             const NodalVector& positions,
                             const double* internal, const double alpha,
                             const NodalVector& dx, const double* r,
                             double* change)
{
  Buffer x(cells.nodal_size()), step(cells.nodal_size());
  Buffer A(cells.internal_size()), b(cells.internal_size()),
      dA(cells.internal_size());
  for (unsigned int batch = 0; batch < cells.batches().size(); ++batch)
  {
    const BatchLaw& law = laws[cells.batches()[batch].slot];
    if (law.elastomer->networks.empty())
      continue;
    cells.gather(batch, positions, x.data());
    cells.gather(batch, dx, step.data());
    cells.gather_internal(batch, internal, A.data());
    cells.gather_internal(batch, r, b.data());
    compute_internal_change(cells.geometry(batch), law, x.data(), A.data(),
                            alpha, step.data(), b.data(), dA.data());
    cells.scatter_internal(batch, dA.data(), change);
  }
}

FilmEnergy compute_energy(const FilmCells& cells,
                          const std::vector<BatchLaw>& laws,
                          const NodalVector& positions, const double* internal)
{
  Buffer x(cells.nodal_size()), A(cells.internal_size());
  FilmEnergy sum;
  sum.electric.assign(cells.slots().size(), 0.);
  for (unsigned int batch = 0; batch < cells.batches().size(); ++batch)
  {
    const FilmBatch& members = cells.batches()[batch];
    cells.gather(batch, positions, x.data());
    cells.gather_internal(batch, internal, A.data());
    BatchEnergy energy;
    compute_energy(cells.geometry(batch), laws[members.slot], x.data(),
                   A.data(), energy);
    for (unsigned int lane = 0; lane < members.n_cells; ++lane)
    {
      sum.at_voltage += energy.at_voltage[lane];
      sum.stored += energy.stored[lane];
      sum.electric[members.slot] +=
          energy.stored[lane] - energy.at_voltage[lane];
    }
  }
  return sum;
}

namespace
{
/// Gathers what compute(batch, positions, metric) gives for the points of each
/// batch.
template <typename Compute>
std::vector<std::array<double, 3>> collect_metric(const FilmCells& cells,
                                                  const NodalVector& positions,
                                                  const Compute& compute)
{
  const unsigned int n = cells.element().n_nodes;
  Buffer x(cells.nodal_size()), C(8 * 3 * n);
  std::vector<std::array<double, 3>> metric(cells.cells().size() * n);
  for (unsigned int batch = 0; batch < cells.batches().size(); ++batch)
  {
    const FilmBatch& members = cells.batches()[batch];
    cells.gather(batch, positions, x.data());
    compute(batch, x.data(), C.data());
    for (unsigned int lane = 0; lane < members.n_cells; ++lane)
      for (unsigned int q = 0; q < n; ++q)
        for (unsigned int i = 0; i < 3; ++i)
          metric[members.cells[lane] * n + q][i] = C[(3 * q + i) * 8 + lane];
  }
  return metric;
}
} // namespace

std::vector<std::array<double, 3>> compute_metric(const FilmCells& cells,
                                                  const NodalVector& positions)
{
  return collect_metric(
      cells, positions,
      [&](const unsigned int batch, const double* x, double* C)
      { compute_metric(cells.geometry(batch), x, C); });
}

std::vector<std::array<double, 3>>
compute_wrinkled_metric(const FilmCells& cells,
                        const std::vector<BatchLaw>& laws,
                        const NodalVector& positions, const double* internal)
{
  Buffer A(cells.internal_size());
  return collect_metric(
      cells, positions,
      [&](const unsigned int batch, const double* x, double* C)
      {
        const BatchLaw& law = laws[cells.batches()[batch].slot];
        cells.gather_internal(batch, internal, A.data());
        compute_wrinkled_metric(cells.geometry(batch), law, x, A.data(), C);
      });
}

void set_relaxed(const FilmCells& cells, const std::vector<BatchLaw>& laws,
                 const NodalVector& positions, double* internal)
{
  const unsigned int n = cells.element().n_nodes;
  const auto metric = compute_wrinkled_metric(cells, laws, positions, internal);
  for (unsigned int cell = 0; cell < cells.cells().size(); ++cell)
  {
    const auto& networks =
        cells.films()[cells.cells()[cell].film].elastomer->networks;
    double* A = internal + cells.first_internal(cell);
    for (unsigned int q = 0; q < n; ++q)
      for (const material::Network& network : networks)
      {
        const auto& [xx, yy, xy] = metric[cell * n + q];
        const auto at_rest = material::relaxed_internal(
            network, material::SymmetricTensor2<double>{xx, yy, xy});
        *A++ = at_rest.xx;
        *A++ = at_rest.yy;
        *A++ = at_rest.xy;
      }
  }
}

void set_unrelaxed(const FilmCells& cells, double* internal)
{
  for (std::size_t i = 0; i < cells.n_internal(); i += 3)
  {
    internal[i] = internal[i + 1] = 1;
    internal[i + 2] = 0;
  }
}
} // namespace taut::fe
