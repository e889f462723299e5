#include <taut/base/exceptions.h>
#include <taut/structure/structure.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::structure
{
namespace
{
bool any_is_given(const LoadState& loads)
{
  return std::any_of(loads.charge_is_given.begin(), loads.charge_is_given.end(),
                     [](const bool given) { return given; });
}
} // namespace

void Structure::make_source_scales()
{
  const std::size_t n = device_.electrodes.size();
  voltage_scales_.assign(n, 0.);
  charge_scales_.assign(n, 0.);
  last_voltages_.assign(n, 0.);
  for (const auto& cell : cells_->cells())
  {
    if (cell.electrode < 0)
      continue;
    const Film& film = device_.films[cell.film];
    const material::SymmetricTensor2<double> one{1, 1, 0},
        metric{film.pre_stretch[0] * film.pre_stretch[0],
               film.pre_stretch[1] * film.pre_stretch[1], 0};
    const material::Field field{0, film.temperature.value(0)};
    const double nominal_field =
        std::sqrt(material::shear_modulus(film.material) /
                  material::charge_density(film.material, one, field, 1.));
    double& voltage = voltage_scales_[cell.electrode];
    voltage = std::max(voltage, nominal_field * film.thickness);
    const auto index = &cell - cells_->cells().data();
    for (unsigned int q = 0; q < cells_->element().n_nodes; ++q)
      charge_scales_[cell.electrode] +=
          material::charge_density(film.material, metric, field,
                                   nominal_field) *
          cells_->volume(index, q) / film.thickness;
  }
  dealii::Utilities::MPI::sum(charge_scales_, communicator(), charge_scales_);
  dealii::Utilities::MPI::max(voltage_scales_, communicator(), voltage_scales_);
}

/// Nothing where the film cannot bear the voltage.
std::optional<double>
Structure::compute_capacitance(const unsigned int electrode,
                               const LoadState& loads, const double* internal,
                               const Networks networks) const
{
  const auto own = fe::compute_capacitance(*cells_, make_laws(loads, networks),
                                           electrode, positions_, internal);
  const double margin = std::isnan(own.margin) ? -1. : own.margin;
  if (!(dealii::Utilities::MPI::min(margin, communicator()) > 0))
    return std::nullopt;
  return sum(own.value);
}

LoadState Structure::resolve_voltages(LoadState loads, const double* u,
                                      const double* internal,
                                      const Networks networks)
{
  if (!any_is_given(loads))
    return loads;
  compute_positions(loads, u);
  for (unsigned int e = 0; e < loads.voltages.size(); ++e)
  {
    if (!loads.charge_is_given[e])
      continue;
    const auto capacitance_of = [&](const double voltage)
    {
      loads.voltages[e] = voltage;
      return compute_capacitance(e, loads, internal, networks);
    };
    loads.voltages[e] =
        find_voltage(capacitance_of, loads.charges[e], last_voltages_[e],
                     device_.electrodes[e].name);
    last_voltages_[e] = loads.voltages[e];
  }
  return loads;
}

void Structure::add_source_powers(const LoadState& loads, Powers& powers) const
{
  const auto charges = compute_charges(loads);
  for (unsigned int e = 0; e < charges.size(); ++e)
  {
    const Electrode& electrode = device_.electrodes[e];
    powers.work += loads.voltages[e] * loads.charge_rates[e] -
                   charges[e] * loads.voltage_rates[e];
    if (electrode.control != Electrode::Control::circuit)
      continue;
    const auto currents = compute_currents(electrode, loads.source_voltages[e],
                                           loads.voltages[e]);
    powers.work += loads.source_voltages[e] * currents.source;
    powers.resistance +=
        (loads.source_voltages[e] - loads.voltages[e]) * currents.source +
        loads.voltages[e] * currents.leakage;
  }
}

SourceBorder::Column Structure::make_column(const unsigned int electrode,
                                            const LoadState& loads,
                                            const Networks networks)
{
  // Forces are quadratic in the voltage where the film is taut, so that
  // central differences are exact; elsewhere their error is of the square of
  // the step.
  constexpr double relative = 1e-4;
  const double voltage = loads.voltages[electrode];
  const double step =
      relative *
      std::max(std::abs(voltage), relative * voltage_scales_[electrode]);
  LoadState lower = loads, higher = loads;
  lower.voltages[electrode] = voltage - step;
  higher.voltages[electrode] = voltage + step;
  const auto lower_laws = make_laws(lower, networks);
  const auto higher_laws = make_laws(higher, networks);
  auto change = nodes().make_vector();
  const double charge = fe::add_voltage_response(
      *cells_, {voltage - step, voltage + step, lower_laws, higher_laws},
      electrode, tangent_positions_, tangent_internal_.data(), change);
  fe::collect_forces(nodes(), &tangent_positions_, change);
  change.compress(dealii::VectorOperation::add);
  SourceBorder::Column column;
  column.electrode = electrode;
  for (const unsigned int entry : free_)
    column.b.push_back(-fe::entry(change, entry) / (2 * step));
  column.capacitance = sum(charge) / (2 * step);
  column.conductance = get_conductance(device_.electrodes[electrode]);
  if (!(column.capacitance > 0))
    throw StepRejected("the capacitance of electrode '" +
                       device_.electrodes[electrode].name +
                       "' is not positive");
  return column;
}

void Structure::make_border(const LoadState& loads, const Networks networks,
                            const double alpha)
{
  border_.reset(communicator(), alpha);
  for (unsigned int e = 0; e < loads.voltages.size(); ++e)
    if (loads.charge_is_given[e])
      border_.add(make_column(e, loads, networks));
}

void Structure::solve(const double* r, double* d)
{
  solve_with(*solver_, r, d);
  border_.correct(d);
}

void Structure::solve(const double* r, double* d, std::vector<double>& circuits)
{
  std::vector<double> forces(r, r + n_free());
  border_.add_residuals(circuits, forces.data());
  solve(forces.data(), d);
  border_.compute_charge_changes(d, circuits);
}

int Structure::count_negative_eigenvalues()
{
  return solver_->count_negative_eigenvalues() -
         border_.count_removed_negative_eigenvalues();
}
} // namespace taut::structure
