#include <taut/structure/systems.h>

#include <limits>

namespace taut::structure
{
Equilibrium::Equilibrium(Structure& structure, LoadHistory& history,
                         const Networks networks, const double* internal)
    : structure_(structure), history_(history), networks_(networks),
      internal_(internal)
{
  if (!internal_)
  {
    no_internal_.assign(structure.n_internal(), 0.);
    internal_ = no_internal_.data();
  }
}

MPI_Comm Equilibrium::communicator() const
{
  return structure_.communicator();
}

std::size_t Equilibrium::n_unknowns() const
{
  return structure_.n_free();
}

LoadState Equilibrium::loads_at(const double load, const double* u)
{
  LoadState loads = history_.at(load);
  if (!held_charges_.empty())
    give_charges(structure_.device().electrodes, held_charges_, loads);
  return structure_.resolve_voltages(loads, u, internal_, networks_);
}

void Equilibrium::compute_residual(const double load, const double* u,
                                   double* residual)
{
  structure_.compute_forces(loads_at(load, u), u, internal_, networks_,
                            residual, nullptr);
  // The residual is internal minus external, so that its derivative is the
  // tangent.
  for (std::size_t i = 0; i < structure_.n_free(); ++i)
    residual[i] *= -1;
}

void Equilibrium::prepare(const double load, const double* u)
{
  // A pressure on a film with free edges, a moment or a force that turns has no
  // symmetric tangent.
  const auto kind =
      structure_.device().pressures.empty() && !structure_.has_follower_forces()
          ? fe::LinearSolver::Kind::symmetric
          : fe::LinearSolver::Kind::general;
  structure_.factorise(loads_at(load, u), u, internal_, networks_,
                       std::numeric_limits<double>::infinity(), false, kind);
}

void Equilibrium::solve(const double* r, double* d)
{
  structure_.solve(r, d);
}

double Equilibrium::round_off_force() const
{
  return structure_.round_off_force();
}

bool Equilibrium::takes_full_steps() const
{
  return !structure_.frames().empty();
}

void Equilibrium::forget_iteration()
{
  structure_.forget_linearisation();
}

std::optional<int> Equilibrium::count_negative_eigenvalues()
{
  return structure_.count_negative_eigenvalues();
}

double Equilibrium::reference_force() const
{
  return structure_.internal_force_norm();
}
} // namespace taut::structure
