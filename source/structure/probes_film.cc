#include <taut/structure/point_fields.h>
#include <taut/structure/probes.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::structure
{
namespace
{
using Kind = Probe::Kind;
using Tensor = material::SymmetricTensor2<double>;

/// Calls function(cell, q) for the points of a film on this rank.
template <typename Function>
void for_each_point(const fe::FilmCells& cells, const std::size_t film,
                    const Function& function)
{
  for (unsigned int cell = 0; cell < cells.cells().size(); ++cell)
    if (cells.cells()[cell].film == film)
      for (unsigned int q = 0; q < cells.element().n_nodes; ++q)
        function(cell, q);
}

/// The law of a cell among those of all slots.
const fe::BatchLaw& find_law(const fe::FilmCells& cells,
                             const std::vector<fe::BatchLaw>& laws,
                             const unsigned int cell)
{
  const fe::FilmCell& wanted = cells.cells()[cell];
  const auto found = std::find_if(cells.slots().begin(), cells.slots().end(),
                                  [&](const fe::LawSlot& slot) {
                                    return slot.film == wanted.film &&
                                           slot.electrode == wanted.electrode;
                                  });
  return laws[found - cells.slots().begin()];
}

/// Nominal stress along a material axis, |F e_k| S_kk (Pa), with the stress of
/// the wrinkled film, whose metric is `wrinkled`.
double compute_nominal_stress(const fe::FilmCells& cells,
                              const fe::BatchLaw& law, const unsigned int cell,
                              const unsigned int q, const Tensor& C,
                              const Tensor& wrinkled, const double* internal,
                              const unsigned int axis)
{
  std::vector<Tensor> A;
  const double* values =
      internal + cells.first_internal(cell) + 3ul * q * cells.n_networks(cell);
  for (unsigned int m = 0; m < cells.n_networks(cell); ++m)
    A.push_back({values[3 * m], values[3 * m + 1], values[3 * m + 2]});
  const Tensor S =
      material::stress(*law.elastomer, wrinkled, A.data(), law.field);
  return axis == 0 ? std::sqrt(C.xx) * S.xx : std::sqrt(C.yy) * S.yy;
}
} // namespace

double Probes::evaluate_film(const std::size_t probe, const LoadState& loads,
                             const double* u, const double* internal) const
{
  Structure& structure = system_.structure();
  const fe::FilmCells& cells = structure.cells();
  const Probe& description = descriptions_[probe];
  const std::size_t film = targets_[probe];
  const MPI_Comm comm = structure.communicator();
  const unsigned int n = cells.element().n_nodes;
  if (description.kind == Kind::min_principal_stress ||
      description.kind == Kind::max_true_field)
  {
    const auto critical =
        compute_critical_values(structure, loads, u, internal);
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for_each_point(cells, film,
                   [&](const unsigned int cell, const unsigned int q)
                   {
                     const auto& values = critical[cell * n + q];
                     low = std::min(low, values.smaller_stress);
                     high = std::max(high, values.true_field);
                   });
    return description.kind == Kind::max_true_field
               ? dealii::Utilities::MPI::max(high, comm)
               : dealii::Utilities::MPI::min(low, comm);
  }
  const auto metric =
      fe::compute_metric(cells, structure.compute_positions(loads, u));
  const auto laws = structure.make_laws(loads, Networks::as_given);
  const auto wrinkled = fe::compute_wrinkled_metric(
      cells, laws, structure.compute_positions(loads, u), internal);
  double volume = 0, integral = 0;
  for_each_point(cells, film,
                 [&](const unsigned int cell, const unsigned int q)
                 {
                   const auto& [xx, yy, xy] = metric[cell * n + q];
                   const auto& [wrinkled_xx, wrinkled_yy, wrinkled_xy] =
                       wrinkled[cell * n + q];
                   const double value =
                       description.kind == Kind::mean_stretch
                           ? std::sqrt(description.component == 0 ? xx : yy)
                           : compute_nominal_stress(
                                 cells, find_law(cells, laws, cell), cell, q,
                                 {xx, yy, xy},
                                 {wrinkled_xx, wrinkled_yy, wrinkled_xy},
                                 internal, description.component);
                   volume += cells.volume(cell, q);
                   integral += cells.volume(cell, q) * value;
                 });
  return dealii::Utilities::MPI::sum(integral, comm) /
         dealii::Utilities::MPI::sum(volume, comm);
}
} // namespace taut::structure
