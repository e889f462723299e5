#include <taut/base/exceptions.h>
#include <taut/structure/systems.h>

#include <algorithm>

namespace taut::structure
{
StructureSystem::StructureSystem(Structure& structure, const bool inertia)
    : structure_(structure), history_(structure.device()), inertia_(inertia),
      circuits_(find_circuits(structure.device().electrodes))
{
}

MPI_Comm StructureSystem::communicator() const
{
  return structure_.communicator();
}

time::StateLayout StructureSystem::layout() const
{
  const bool first =
      dealii::Utilities::MPI::this_mpi_process(communicator()) == 0;
  time::StateLayout layout;
  layout.positions = structure_.n_free();
  layout.velocities = inertia_ ? layout.positions : 0;
  layout.internal = structure_.n_internal();
  layout.globals = first ? circuits_.size() : 0;
  layout.scalars = first ? std::size_t(n_scalars) : 0;
  return layout;
}

std::vector<double> StructureSystem::stop_times(const double start,
                                                const double end) const
{
  return history_.stop_times(start, end);
}

const double* StructureSystem::velocities(const double* state) const
{
  return inertia_ ? state + structure_.n_free() : nullptr;
}

const double* StructureSystem::internal(const double* state) const
{
  return state + structure_.n_free() * (inertia_ ? 2 : 1);
}

double* StructureSystem::internal(double* state) const
{
  return state + structure_.n_free() * (inertia_ ? 2 : 1);
}

const double* StructureSystem::scalars(const double* state) const
{
  return internal(state) + structure_.n_internal() + layout().globals;
}

double* StructureSystem::scalars(double* state) const
{
  return internal(state) + structure_.n_internal() + layout().globals;
}

std::vector<double>
StructureSystem::make_initial_state(const double time, const Start start,
                                    const FindShape& find_shape)
{
  history_.enter_interval(time);
  std::vector<double> state(layout().size(), 0.);
  double* A = internal(state.data());
  fe::set_unrelaxed(structure_.cells(), A);
  find_shape(start == Start::relaxed ? Networks::relaxed : Networks::as_given,
             A, state.data());
  structure_.normalise_rotations(state.data());
  if (start == Start::relaxed)
    set_relaxed(time, state.data());
  set_circuits_at_rest(time, state.data());
  return state;
}

std::vector<double>
StructureSystem::make_initial_state(const double time, const Start start,
                                    const bool in_equilibrium,
                                    const time::PathOptions& options)
{
  return make_initial_state(
      time, start,
      [&](const Networks networks, const double* internal, double* u)
      {
        if (!in_equilibrium)
          return;
        Equilibrium problem(structure_, history_, networks, internal);
        time::find_equilibrium(problem, time, u, options.newton);
      });
}

Energies StructureSystem::compute_energies(const double time,
                                           const double* state)
{
  return structure_.compute_energies(loads_at(time, state), state,
                                     velocities(state), internal(state));
}

void StructureSystem::pass_jump(const double time, double* state)
{
  const double before = compute_energies(time, state).total();
  history_.enter_interval(time);
  const double after = compute_energies(time, state).total();
  if (layout().scalars > 0)
    scalars(state)[Scalar::work] += after - before;
}

InertialSystem::InertialSystem(Structure& structure)
    : StructureSystem(structure, true)
{
}

void InertialSystem::evaluate(const double time, const double* state, double* f)
{
  const std::size_t n = structure_.n_free();
  const LoadState loads = loads_at(time, state);
  const double* v = velocities(state);
  std::copy(v, v + n, f);
  double* forces = f + n;
  structure_.compute_forces(loads, state, internal(state), Networks::as_given,
                            forces, f + 2 * n);
  const auto nodal_velocities = structure_.compute_velocities(loads, v);
  Powers powers = structure_.compute_powers(loads, &nodal_velocities);
  double drag_power = 0, support_power = 0;
  if (structure_.has_drag())
  {
    const auto drag = compute_drag(loads, v);
    for (std::size_t i = 0; i < n; ++i)
    {
      forces[i] -= drag[i];
      drag_power += drag[i] * v[i];
    }
  }
  if (structure_.has_frame_damping())
  {
    const auto damping = structure_.compute_frame_damping(loads, v);
    for (std::size_t i = 0; i < n; ++i)
      forces[i] -= damping.forces[i];
    drag_power += damping.power;
  }
  if (history_.has_moving_supports())
  {
    const auto inertia =
        structure_.compute_support_inertia(loads.amplitude_second_rates);
    for (std::size_t i = 0; i < n; ++i)
    {
      forces[i] -= inertia[i];
      support_power -= inertia[i] * v[i];
    }
  }
  structure_.turn_forces_into_accelerations(v, forces);
  set_circuit_rates(loads, f);
  powers.drag = dealii::Utilities::MPI::sum(drag_power, communicator());
  powers.work += dealii::Utilities::MPI::sum(support_power, communicator());
  if (layout().scalars > 0)
  {
    double* s = scalars(f);
    s[Scalar::dissipated] = powers.dissipation;
    s[Scalar::lost] = powers.drag + powers.resistance;
    s[Scalar::work] = powers.work;
  }
}

std::vector<double> InertialSystem::compute_drag(const LoadState& loads,
                                                 const double* v)
{
  std::vector<double> drag(structure_.n_free());
  structure_.multiply_drag(v, drag.data());
  if (history_.has_moving_supports())
  {
    const auto of_supports =
        structure_.compute_support_drag(loads.amplitude_rates);
    for (std::size_t i = 0; i < drag.size(); ++i)
      drag[i] += of_supports[i];
  }
  return drag;
}

void InertialSystem::multiply_mass(const double* x, double* result)
{
  const std::size_t n = structure_.n_free();
  std::vector<double> product(n);
  structure_.multiply_mass(x + n, product.data());
  std::copy(x, x + layout().size(), result);
  std::copy(product.begin(), product.end(), result + n);
}

void InertialSystem::solve_mass(const double* b, double* x)
{
  const std::size_t n = structure_.n_free();
  std::vector<double> solution(n);
  structure_.solve_mass(b + n, solution.data());
  std::copy(b, b + layout().size(), x);
  std::copy(solution.begin(), solution.end(), x + n);
}

void InertialSystem::prepare(const double time, const double* state,
                             const double alpha)
{
  alpha_ = alpha;
  structure_.factorise(loads_at(time, state), state, internal(state),
                       Networks::as_given, alpha, true,
                       fe::LinearSolver::Kind::symmetric);
}

void InertialSystem::solve(const double* r, double* d)
{
  // (alpha^2 M + alpha D + K) du = r_v + (alpha M + D) r_u + change of the
  // forces for (alpha - dA'/dA)^{-1} r_A;  dv = alpha du - r_u.
  const std::size_t n = structure_.n_free();
  std::vector<double> b(n), product(n);
  structure_.multiply_mass(r, product.data());
  for (std::size_t i = 0; i < n; ++i)
    b[i] = r[n + i] + alpha_ * product[i];
  structure_.turn_accelerations_into_forces(b.data());
  if (structure_.has_frame_damping())
    structure_.add_frame_damping_product(r, b.data());
  if (structure_.has_drag())
  {
    structure_.multiply_drag(r, product.data());
    for (std::size_t i = 0; i < n; ++i)
      b[i] += product[i];
  }
  structure_.add_force_change(alpha_, internal(r), b.data());
  structure_.turn_with_frames(false, b.data());
  auto charges = get_charges(r);
  structure_.solve(b.data(), b.data(), charges);
  structure_.turn_with_frames(true, b.data());
  std::vector<double> change(structure_.n_internal());
  structure_.compute_internal_change(alpha_, b.data(), internal(r),
                                     change.data());
  for (std::size_t i = 0; i < n; ++i)
  {
    const double r_u = r[i];
    d[i] = b[i];
    d[n + i] = alpha_ * b[i] - r_u;
  }
  std::copy(change.begin(), change.end(), internal(d));
  set_charges(charges, d);
  for (std::size_t i = 0; i < layout().scalars; ++i)
    scalars(d)[i] = scalars(r)[i] / alpha_;
}

void InertialSystem::pass_stop_time(const double time, double* state)
{
  const LoadState before = history_.at(time);
  pass_jump(time, state);
  if (history_.has_moving_supports())
    pass_kink_of_supports(before, history_.at(time), state);
}

void InertialSystem::pass_kink_of_supports(const LoadState& before,
                                           const LoadState& after,
                                           double* state)
{
  // A jump of the supports' velocity is an impulse: M dv = - M_fc dv_c.
  std::vector<double> jump(after.amplitude_rates);
  for (std::size_t i = 0; i < jump.size(); ++i)
    jump[i] -= before.amplitude_rates[i];
  auto impulse = structure_.compute_support_inertia(jump);
  const std::size_t n = structure_.n_free();
  double* v = state + n;
  std::vector<double> momentum(n), dv(n);
  structure_.multiply_mass(v, momentum.data());
  structure_.solve_mass(impulse.data(), dv.data());
  double work = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    v[i] -= dv[i];
    work += -momentum[i] * dv[i] + 0.5 * impulse[i] * dv[i];
  }
  work = dealii::Utilities::MPI::sum(work, communicator());
  if (layout().scalars > 0)
    scalars(state)[Scalar::work] += work;
}

QuasiStaticSystem::QuasiStaticSystem(Structure& structure,
                                     const time::PathOptions& options)
    : StructureSystem(structure, false), options_(options)
{
}

void QuasiStaticSystem::evaluate(const double time, const double* state,
                                 double* f)
{
  const LoadState loads = loads_at(time, state);
  structure_.compute_forces(loads, state, internal(state), Networks::as_given,
                            f, internal(f));
  set_circuit_rates(loads, f);
  const Powers powers = structure_.compute_powers(loads, nullptr);
  if (layout().scalars > 0)
  {
    scalars(f)[Scalar::dissipated] = powers.dissipation;
    scalars(f)[Scalar::lost] = powers.resistance;
    scalars(f)[Scalar::work] = powers.work;
  }
}

void QuasiStaticSystem::multiply_mass(const double* x, double* result)
{
  const std::size_t n = structure_.n_free();
  std::fill(result, result + n, 0.);
  std::copy(x + n, x + layout().size(), result + n);
}

void QuasiStaticSystem::solve_mass(const double*, double*)
{
  throw SolverFailed("a quasi-static system has no mass to invert");
}

void QuasiStaticSystem::prepare(const double time, const double* state,
                                const double alpha)
{
  alpha_ = alpha;
  // Large steps leave the networks far from equilibrium, where the symmetric
  // part of the tangent contracts poorly.
  const auto kind = structure_.n_internal() > 0
                        ? fe::LinearSolver::Kind::general
                        : fe::LinearSolver::Kind::symmetric;
  structure_.factorise(loads_at(time, state), state, internal(state),
                       Networks::as_given, alpha, false, kind);
}

void QuasiStaticSystem::solve(const double* r, double* d)
{
  const std::size_t n = structure_.n_free();
  std::vector<double> b(r, r + n);
  structure_.add_force_change(alpha_, internal(r), b.data());
  auto charges = get_charges(r);
  structure_.solve(b.data(), b.data(), charges);
  std::vector<double> change(structure_.n_internal());
  structure_.compute_internal_change(alpha_, b.data(), internal(r),
                                     change.data());
  std::copy(b.begin(), b.end(), d);
  std::copy(change.begin(), change.end(), internal(d));
  set_charges(charges, d);
  for (std::size_t i = 0; i < layout().scalars; ++i)
    scalars(d)[i] = scalars(r)[i] / alpha_;
}

void QuasiStaticSystem::pass_stop_time(const double time, double* state)
{
  pass_jump(time, state);
  const double before = compute_energies(time, state).total();
  Equilibrium problem(structure_, history_, Networks::as_given,
                      internal(state));
  problem.hold_charges(get_charges(state));
  time::find_equilibrium(problem, time, state, options_.newton);
  // What a jump releases, a slow process cannot hold: it is lost.
  const double after = compute_energies(time, state).total();
  if (layout().scalars > 0)
    scalars(state)[Scalar::lost] += before - after;
}
} // namespace taut::structure
