#include <taut/base/exceptions.h>
#include <taut/structure/structure.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace taut::structure
{
namespace
{
/// Throws on every rank, with film, place and values of the worst, if any rank
/// has a law beyond its limit or wrinkles without end.
void refuse_beyond_limit(const fe::LimitReport& limit, const Device& device,
                         const MPI_Comm comm)
{
  if (dealii::Utilities::MPI::min(limit.margin, comm) > 0)
    return;
  const auto margins = dealii::Utilities::MPI::all_gather(comm, limit.margin);
  const unsigned int worst =
      std::min_element(margins.begin(), margins.end()) - margins.begin();
  std::ostringstream message;
  if (!limit.excess.empty())
    message << "film '" << device.films[limit.film].name << "' at ("
            << limit.place[0] << ", " << limit.place[1] << ", "
            << limit.place[2] << ") m of the mesh: " << limit.excess;
  throw StepRejected(
      dealii::Utilities::MPI::broadcast(comm, message.str(), worst));
}
} // namespace

MPI_Comm Structure::communicator() const
{
  return nodes().partitioner->get_mpi_communicator();
}

double Structure::sum(const double local) const
{
  return dealii::Utilities::MPI::sum(local, communicator());
}

std::size_t Structure::n_free_global() const
{
  return dealii::Utilities::MPI::sum(free_.size(), communicator());
}

void Structure::restrict(const fe::NodalVector& nodal, double* free) const
{
  for (std::size_t i = 0; i < free_.size(); ++i)
    free[i] = fe::entry(nodal, free_[i]);
}

void Structure::prolong(const double* free, fe::NodalVector& nodal) const
{
  for (std::size_t i = 0; i < free_.size(); ++i)
    fe::entry(nodal, free_[i]) = free[i];
}

const fe::NodalVector& Structure::compute_positions(const LoadState& loads,
                                                    const double* u)
{
  set_pre_stretches(loads);
  positions_.zero_out_ghost_values();
  for (fe::LocalNode node = 0; node < nodes().n_owned; ++node)
    for (unsigned int c = 0; c < 3; ++c)
      fe::entry(positions_, 3 * node + c) = nodes().mesh_position[node][c];
  for (const auto& held : device_nodes_.moving)
    if (held.node < nodes().n_owned)
      fe::entry(positions_, 3 * held.node + held.component) +=
          held.shape * loads.amplitudes[held.support];
  for (std::size_t i = 0; i < free_.size(); ++i)
    fe::entry(positions_, free_[i]) += u[i];
  positions_.update_ghost_values();
  fe::distribute_positions(nodes(), positions_);
  return positions_;
}

fe::NodalVector Structure::compute_velocities(const LoadState& loads,
                                              const double* v)
{
  auto velocities = nodes().make_vector();
  for (const auto& held : device_nodes_.moving)
    if (held.node < nodes().n_owned)
      fe::entry(velocities, 3 * held.node + held.component) +=
          held.shape * loads.amplitude_rates[held.support];
  prolong(v, velocities);
  velocities.update_ghost_values();
  fe::distribute_change(nodes(), &positions_, velocities);
  return velocities;
}

void Structure::add_bar_forces(fe::NodalVector& forces) const
{
  // The spring k/8 (|d|^2/l^2 - 1)^2 l^2 that holds the director's length l.
  for (const auto& bar : nodes().bars)
  {
    if (bar.director >= nodes().n_owned)
      continue;
    double square = 0;
    for (unsigned int c = 0; c < 3; ++c)
      square += std::pow(fe::entry(positions_, 3 * bar.director + c), 2);
    const double tension = 0.5 * bar.length_stiffness *
                           (square / (bar.half_length * bar.half_length) - 1);
    for (unsigned int c = 0; c < 3; ++c)
      fe::entry(forces, 3 * bar.director + c) -=
          tension * fe::entry(positions_, 3 * bar.director + c);
  }
}

void Structure::set_dead_forces(const LoadState& loads)
{
  // Entry by entry: an assignment of vectors leaves the shares at ghosts out.
  for (std::size_t i = 0; i < 3 * nodes().n_local; ++i)
  {
    double& force = fe::entry(dead_forces_, i);
    force = fe::entry(weight_, i);
    for (unsigned int k = 0; k < edges_.size(); ++k)
      force += loads.edge_forces[k] * fe::entry(edges_[k], i);
  }
  point_forces_->add_forces(loads, positions_, true, false, dead_forces_);
  if (rest_load_ != std::array<double, 3>{})
    frames_->add_line_load(rest_load_, dead_forces_);
}

void Structure::compute_forces(const LoadState& loads, const double* u,
                               const double* internal, const Networks networks,
                               double* forces, double* rates)
{
  compute_positions(loads, u);
  const auto laws = make_laws(loads, networks);
  for (auto* vector : {&forces_, &pressure_forces_})
  {
    vector->zero_out_ghost_values();
    *vector = 0;
  }
  std::vector<double> unused_rates(rates ? 0 : n_internal());
  const fe::LimitReport limit =
      fe::add_internal_forces(*cells_, laws, positions_, internal, forces_,
                              rates ? rates : unused_rates.data(), powers_);
  refuse_beyond_limit(limit, device_, communicator());
  heat_power_ =
      networks == Networks::as_given ? compute_heat_power(loads, internal) : 0;
  frames_->add_forces(loads, positions_, forces_);
  for (unsigned int i = 0; i < pressures_.size(); ++i)
    pressures_[i].pressure = loads.pressures[i];
  fe::add_pressure_forces(*cells_, pressures_, positions_, pressure_forces_);
  point_forces_->add_forces(loads, positions_, false, true, pressure_forces_);
  set_dead_forces(loads);
  double square = 0;
  for (std::size_t i = 0; i < 3 * nodes().n_local; ++i)
  {
    const double external =
        fe::entry(pressure_forces_, i) + fe::entry(dead_forces_, i);
    double& force = fe::entry(forces_, i);
    square += force * force + external * external;
    force = external - force;
  }
  square = sum(square);
  if (!std::isfinite(square))
    throw StepRejected("the forces of the film are no numbers");
  // Forces cancel within a node long before they are collected: the scale of
  // the residual is what the film would pull with if nothing did.
  internal_force_norm_ = std::max(std::sqrt(square), least_force_);
  fe::collect_hanging_forces(nodes(), forces_);
  if (has_turning_nodes())
    turned_forces_.assign(forces_.begin(),
                          forces_.begin() + 3 * nodes().n_local);
  add_bar_forces(forces_);
  fe::collect_bar_forces(nodes(), &positions_, forces_);
  fe::collect_follower_forces(nodes(), &positions_, forces_);
  forces_.compress(dealii::VectorOperation::add);
  restrict(forces_, forces);
}

std::vector<double> Structure::compute_capacitances() const
{
  std::vector<double> capacitances(device_.electrodes.size(), 0.);
  for (unsigned int slot = 0; slot < cells_->slots().size(); ++slot)
  {
    const auto& [film, electrode] = cells_->slots()[slot];
    if (electrode >= 0)
      capacitances[electrode] += powers_.permittivity[slot] /
                                 std::pow(device_.films[film].thickness, 2);
  }
  // The same on every rank, also where an electrode has no cells.
  for (auto& capacitance : capacitances)
    capacitance = sum(capacitance);
  return capacitances;
}

std::vector<double> Structure::compute_charges(const LoadState& loads) const
{
  auto charges = compute_capacitances();
  for (unsigned int e = 0; e < charges.size(); ++e)
    charges[e] *= loads.voltages[e];
  return charges;
}

Powers Structure::compute_powers(const LoadState& loads,
                                 const fe::NodalVector* velocities) const
{
  Powers powers;
  powers.dissipation = powers_.dissipation;
  double work = heat_power_;
  auto rates = nodes().make_vector();
  point_forces_->add_force_rates(loads, rates);
  for (std::size_t i = 0; i < 3 * nodes().n_local; ++i)
  {
    double rate = fe::entry(rates, i);
    for (unsigned int k = 0; k < edges_.size(); ++k)
      rate += loads.edge_rates[k] * fe::entry(edges_[k], i);
    work -= rate * get_displacement(i);
  }
  for (const auto& held : device_nodes_.moving)
    if (held.node < nodes().n_owned)
      work -= fe::entry(forces_, 3 * held.node + held.component) * held.shape *
              loads.amplitude_rates[held.support];
  if (velocities)
    for (std::size_t i = 0; i < 3 * nodes().n_local; ++i)
      work += fe::entry(pressure_forces_, i) * fe::entry(*velocities, i);
  powers.work = sum(work);
  powers.dissipation = sum(powers.dissipation);
  add_source_powers(loads, powers);
  if (!velocities)
    for (unsigned int i = 0; i < pressures_.size(); ++i)
      if (loads.pressure_rates[i] != 0)
        powers.work -= loads.pressure_rates[i] *
                       compute_volume(device_.pressures[i].groups);
  return powers;
}

double Structure::get_displacement(const std::size_t entry) const
{
  return fe::entry(positions_, entry) -
         nodes().mesh_position[entry / 3][entry % 3];
}

std::array<double, 3>
Structure::compute_reaction(const unsigned int support) const
{
  std::array<double, 3> reaction{};
  for (const auto node : device_nodes_.of_support[support])
    for (unsigned int c = 0; c < 3; ++c)
      if (device_.supports[support].held[c])
        reaction[c] -= fe::entry(forces_, 3 * node + c);
  for (auto& component : reaction)
    component = sum(component);
  return reaction;
}

double Structure::compute_volume(const std::vector<std::string>& groups) const
{
  // (1/3) int x . n dA = (1/3) sum_a f_a . x_a with the forces of 1 Pa.
  std::vector<fe::PressureLoad> unit{make_pressure(groups)};
  unit[0].pressure = 1;
  auto forces = nodes().make_vector();
  fe::add_pressure_forces(*cells_, unit, positions_, forces);
  double volume = 0;
  for (std::size_t i = 0; i < 3 * nodes().n_local; ++i)
    volume += fe::entry(forces, i) * fe::entry(positions_, i) / 3;
  return sum(volume);
}

Energies Structure::compute_energies(const LoadState& loads, const double* u,
                                     const double* v, const double* internal)
{
  compute_positions(loads, u);
  const auto film = fe::compute_energy(
      *cells_, make_laws(loads, Networks::as_given), positions_, internal);
  Energies energies;
  energies.stored = film.stored;
  for (unsigned int slot = 0; slot < cells_->slots().size(); ++slot)
  {
    const int electrode = cells_->slots()[slot].electrode;
    energies.electric += film.electric[slot];
    if (electrode >= 0 && !loads.charge_is_given[electrode])
      energies.sources -= 2 * film.electric[slot];
  }
  energies.frames = frames_->compute_energy(loads, positions_);
  set_dead_forces(loads);
  for (std::size_t i = 0; i < 3 * nodes().n_local; ++i)
    energies.dead_loads -= fe::entry(dead_forces_, i) * get_displacement(i);
  if (v)
  {
    std::vector<double> momentum(n_free());
    multiply_mass(v, momentum.data());
    for (std::size_t i = 0; i < n_free(); ++i)
      energies.kinetic += 0.5 * v[i] * momentum[i];
    energies.kinetic += compute_rotary_energy(v);
  }
  energies.kinetic = sum(energies.kinetic);
  energies.stored = sum(energies.stored);
  energies.frames = sum(energies.frames);
  energies.electric = sum(energies.electric);
  energies.sources = sum(energies.sources);
  energies.dead_loads = sum(energies.dead_loads);
  energies.thermal = sum(compute_thermal_energy(loads));
  if (!v)
    for (unsigned int i = 0; i < pressures_.size(); ++i)
      energies.dead_loads -=
          loads.pressures[i] * compute_volume(device_.pressures[i].groups);
  return energies;
}
} // namespace taut::structure
