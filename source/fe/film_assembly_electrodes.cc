#include <taut/fe/film_assembly.h>

#include <deal.II/base/aligned_vector.h>

#include <cmath>
#include <limits>

namespace taut::fe
{
namespace
{
using Buffer = dealii::AlignedVector<double>;

bool is_under(const FilmCells& cells, const FilmBatch& batch,
              const int electrode)
{
  return cells.slots()[batch.slot].electrode == electrode;
}

/// Of the film in a batch, H^2 (m^2).
double square_of_thickness(const FilmCells& cells, const FilmBatch& batch)
{
  return std::pow(cells.films()[cells.slots()[batch.slot].film].thickness, 2);
}
} // namespace

Capacitance compute_capacitance(const FilmCells& cells,
                                const std::vector<BatchLaw>& laws,
                                const int electrode,
                                const NodalVector& positions,
                                const double* internal)
{
  Buffer x(cells.nodal_size()), A(cells.internal_size()), permittivity(8);
  Capacitance sum{0, std::numeric_limits<double>::infinity()};
  for (unsigned int batch = 0; batch < cells.batches().size(); ++batch)
  {
    const FilmBatch& members = cells.batches()[batch];
    if (!is_under(cells, members, electrode))
      continue;
    cells.gather(batch, positions, x.data());
    cells.gather_internal(batch, internal, A.data());
    const LimitCheck check =
        compute_permittivity(cells.geometry(batch), laws[members.slot],
                             x.data(), A.data(), permittivity.data());
    sum.margin = material::get_smaller(sum.margin, check.margin);
    for (unsigned int lane = 0; lane < members.n_cells; ++lane)
      sum.value += permittivity[lane] / square_of_thickness(cells, members);
  }
  return sum;
}

double add_voltage_response(const FilmCells& cells, const VoltageStep& step,
                            const int electrode, const NodalVector& positions,
                            const double* internal, NodalVector& forces)
{
  Buffer x(cells.nodal_size()), lower(cells.nodal_size()),
      higher(cells.nodal_size());
  Buffer A(cells.internal_size()), rates(cells.internal_size());
  double charge = 0;
  for (unsigned int batch = 0; batch < cells.batches().size(); ++batch)
  {
    const FilmBatch& members = cells.batches()[batch];
    if (!is_under(cells, members, electrode))
      continue;
    cells.gather(batch, positions, x.data());
    cells.gather_internal(batch, internal, A.data());
    BatchPower at_lower, at_higher;
    compute_forces(cells.geometry(batch), step.lower_laws[members.slot],
                   x.data(), A.data(), lower.data(), rates.data(), at_lower);
    compute_forces(cells.geometry(batch), step.higher_laws[members.slot],
                   x.data(), A.data(), higher.data(), rates.data(), at_higher);
    for (std::size_t i = 0; i < higher.size(); ++i)
      higher[i] -= lower[i];
    cells.scatter_add(batch, higher.data(), forces);
    for (unsigned int lane = 0; lane < members.n_cells; ++lane)
      charge += (step.higher * at_higher.permittivity[lane] -
                 step.lower * at_lower.permittivity[lane]) /
                square_of_thickness(cells, members);
  }
  return charge;
}
} // namespace taut::fe
