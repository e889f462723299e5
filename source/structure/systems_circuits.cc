#include <taut/structure/systems.h>

namespace taut::structure
{
LoadState StructureSystem::loads_at(const double time, const double* state)
{
  LoadState loads = history_.at(time);
  give_charges(structure_.device().electrodes, get_charges(state), loads);
  return structure_.resolve_voltages(loads, state, internal(state),
                                     Networks::as_given);
}

std::vector<double> StructureSystem::get_charges(const double* state) const
{
  std::vector<double> charges(structure_.device().electrodes.size(), 0.);
  if (circuits_.empty())
    return charges;
  const double* globals = internal(state) + structure_.n_internal();
  if (layout().globals > 0)
    for (std::size_t k = 0; k < circuits_.size(); ++k)
      charges[circuits_[k]] =
          globals[k] * structure_.charge_scales()[circuits_[k]];
  return dealii::Utilities::MPI::broadcast(communicator(), charges);
}

void StructureSystem::set_charges(const std::vector<double>& charges,
                                  double* state) const
{
  double* globals = internal(state) + structure_.n_internal();
  if (layout().globals > 0)
    for (std::size_t k = 0; k < circuits_.size(); ++k)
      globals[k] =
          charges[circuits_[k]] / structure_.charge_scales()[circuits_[k]];
}

void StructureSystem::set_circuit_rates(const LoadState& loads, double* f) const
{
  const auto& electrodes = structure_.device().electrodes;
  std::vector<double> rates(electrodes.size(), 0.);
  for (const unsigned int e : circuits_)
  {
    const auto currents = compute_currents(
        electrodes[e], loads.source_voltages[e], loads.voltages[e]);
    rates[e] = currents.source - currents.leakage;
  }
  set_charges(rates, f);
}

void StructureSystem::set_relaxed(const double time, double* state)
{
  const LoadState loads = structure_.resolve_voltages(
      history_.at(time), state, internal(state), Networks::relaxed);
  fe::set_relaxed(structure_.cells(),
                  structure_.make_laws(loads, Networks::relaxed),
                  structure_.compute_positions(loads, state), internal(state));
}

void StructureSystem::set_circuits_at_rest(const double time, double* state)
{
  if (circuits_.empty())
    return;
  const LoadState loads = structure_.resolve_voltages(
      history_.at(time), state, internal(state), Networks::as_given);
  std::vector<double> unused(structure_.n_free());
  structure_.compute_forces(loads, state, internal(state), Networks::as_given,
                            unused.data(), nullptr);
  set_charges(structure_.compute_charges(loads), state);
}
} // namespace taut::structure
