#pragma once

#include <mpi.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace taut::time
{
/// residual(u; load) = 0 as the static solvers see it. `u` is this rank's part
/// of the unknowns. `load` is the path parameter (a pseudo time or the time at
/// which signals are read). Errors as in time::System.
class EquilibriumProblem
{
public:
  virtual ~EquilibriumProblem() = default;
  virtual MPI_Comm communicator() const = 0;
  virtual std::size_t n_unknowns() const = 0;
  virtual void compute_residual(double load, const double* u,
                                double* residual) = 0;
  /// Factorises the derivative of the residual at u.
  virtual void prepare(double load, const double* u) = 0;
  /// d = (d residual / d u)^{-1} r; `r` and `d` may be the same array.
  virtual void solve(const double* r, double* d) = 0;
  /// Negative eigenvalues of the derivative at the last prepare, of its
  /// symmetric part if it is not symmetric: 0 if the equilibrium is stable.
  /// Nothing if the problem cannot tell. Collective.
  virtual std::optional<int> count_negative_eigenvalues()
  {
    return std::nullopt;
  }
  /// A force (N) in whose units "small residual" is measured: the norm of the
  /// internal nodal forces before they cancel, at the state of the last
  /// compute_residual. Positive.
  virtual double reference_force() const = 0;
  /// Called with a state that has converged; throws StepRejected if it is not
  /// wanted, an unstable one on a path along stable ones, for instance.
  virtual void check_equilibrium(double /*load*/, const double* /*u*/) {}
  /// What round-off leaves of forces that cancel within an element (N): a
  /// residual below it counts as zero.
  virtual double round_off_force() const
  {
    return 0;
  }
  /// True if a step of Newton's method may enlarge the residual on its way to
  /// the equilibrium, as it does where thin beams turn, so that no line search
  /// may shorten it.
  virtual bool takes_full_steps() const
  {
    return false;
  }
  /// Called when the next prepare does not follow a step from the last one: an
  /// iteration failed, another begins from elsewhere. What was kept from the
  /// last linearisation is then worth nothing.
  virtual void forget_iteration() {}
};

struct EquilibriumOptions
{
  /// Converged when |residual| <= tolerance * reference_force(), in Euclidean
  /// norms. Below 1e-13, which round-off leaves of the forces, it counts as
  /// 1e-13.
  double tolerance = 1e-10;
  unsigned int max_iterations = 30;
  /// Longest Newton step, largest component (m); 0 = no limit.
  double max_step = 0;
};

struct EquilibriumStatistics
{
  unsigned int iterations = 0;
  unsigned int residuals = 0;
  unsigned int factorisations = 0;
  double final_residual = 0;
};

/// Newton with line search, unless the problem takes full steps, (KINSOL) from
/// `u`, which is overwritten only on success. Errors: StepRejected if no
/// convergence or an inadmissible state that the line search cannot avoid (the
/// message says which and how far it came); SolverFailed if the system itself
/// failed. The residual is evaluated again after the solve and must meet the
/// tolerance.
EquilibriumStatistics find_equilibrium(EquilibriumProblem& problem, double load,
                                       double* u,
                                       const EquilibriumOptions& options);

struct PathOptions
{
  EquilibriumOptions newton;
  double first_step = 1;
  double smallest_step = 1e-6;
  double largest_step = 1;
};

/// Follows equilibria from `start` (where u already is or nearly is one) to
/// `end` with cut-back on StepRejected and growth after easy steps; the
/// predictor is linear in the last two points. Calls `accepted(load, u)` after
/// every converged step. `end` may lie below `start`; steps are lengths.
/// Errors: SolverFailed when the step falls below smallest_step (the message
/// names the last good load and the reason); u then holds the last good state.
/// BadInput for steps that are not positive.
EquilibriumStatistics
follow_path(EquilibriumProblem& problem, double start, double end, double* u,
            const PathOptions& options,
            const std::function<void(double, const double*)>& accepted);
} // namespace taut::time
