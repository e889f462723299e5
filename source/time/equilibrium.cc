#include <taut/time/equilibrium.h>

#include <kinsol/kinsol.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

#include "system_callback.h"
#include "system_guard.h"
#include "system_sundials.h"

namespace taut::time
{
namespace
{
/// Round-off leaves about this much of the internal forces: a residual below
/// it counts as zero whatever the tolerance asks for.
constexpr double round_off = 1e-13;

/// The problem as KINSOL's callbacks see it.
class GuardedProblem : public MatrixOperations
{
public:
  GuardedProblem(EquilibriumProblem& problem, const double load,
                 const EquilibriumOptions& options)
      : problem_(problem), load_(load), options_(options),
        communicator_(problem.communicator()), guard_(communicator_),
        size_(problem.n_unknowns())
  {
  }

  int compute_residual(const double* u, double* residual);
  int prepare(const double* u);
  int solve(double* b, double* x) override;

  /// Residual and reference force of the last state, compared.
  bool is_converged() const;
  /// Whether the last callback that failed may succeed at another state.
  const CallbackGuard& guard() const
  {
    return guard_;
  }
  const Communicator& communicator() const
  {
    return communicator_;
  }
  std::size_t size() const
  {
    return size_;
  }
  double residual_norm() const
  {
    return residual_norm_;
  }
  double reference_force() const
  {
    return reference_force_;
  }
  /// Forgets the course of the last iteration; `stops_circles`: the next ends
  /// when it goes round.
  void begin(const bool stops_circles)
  {
    norms_.clear();
    stops_circles_ = stops_circles;
    circles_ = false;
  }
  /// True if the last iteration ended because it went round.
  bool circles() const
  {
    return circles_;
  }
  /// The state with the smallest residual so far.
  const std::vector<double>& best() const
  {
    return best_;
  }
  EquilibriumStatistics statistics;

private:
  void limit_step(double* x) const;
  bool goes_round() const;

  EquilibriumProblem& problem_;
  double load_;
  const EquilibriumOptions& options_;
  Communicator communicator_;
  CallbackGuard guard_;
  std::size_t size_;
  double residual_norm_ = 0;
  double reference_force_ = 0;
  double best_norm_ = std::numeric_limits<double>::infinity();
  std::vector<double> best_;
  /// Of all residuals since the last iterate().
  std::vector<double> norms_;
  bool stops_circles_ = false;
  bool circles_ = false;
};

double compute_norm(const double* values, const std::size_t size,
                    const Communicator& communicator)
{
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i)
    sum += values[i] * values[i];
  return std::sqrt(communicator.sum(sum));
}

double compute_largest(const double* values, const std::size_t size,
                       const Communicator& communicator)
{
  double largest = 0;
  for (std::size_t i = 0; i < size; ++i)
    largest = std::max(largest, std::abs(values[i]));
  return communicator.max(largest);
}

int GuardedProblem::compute_residual(const double* u, double* residual)
{
  ++statistics.residuals;
  const int code = guard_(
      [&]
      {
        problem_.compute_residual(load_, u, residual);
        if (!is_finite(residual, size_))
          throw StepRejected("the residual is not a finite number");
      });
  if (code != 0)
    return code;
  residual_norm_ = compute_norm(residual, size_, communicator_);
  reference_force_ = problem_.reference_force();
  if (residual_norm_ < best_norm_)
  {
    best_norm_ = residual_norm_;
    best_.assign(u, u + size_);
  }
  norms_.push_back(residual_norm_);
  // KINSOL stops for an error that it cannot mend only.
  if (stops_circles_ && goes_round())
  {
    circles_ = true;
    return -1;
  }
  return 0;
}

bool GuardedProblem::is_converged() const
{
  // Round-off may hide a small load: one iteration answers it in any case.
  const double hidden =
      statistics.factorisations > 0 ? problem_.round_off_force() : 0.;
  return residual_norm_ <=
         std::max(std::max(options_.tolerance, round_off) * reference_force_,
                  hidden);
}

bool GuardedProblem::goes_round() const
{
  // Three residuals in a row that are nearly those of two iterations before.
  constexpr std::size_t length = 3;
  constexpr double nearly = 0.1;
  if (norms_.size() < length + 2)
    return false;
  for (std::size_t i = norms_.size() - length; i < norms_.size(); ++i)
    if (std::abs(norms_[i] - norms_[i - 2]) > nearly * norms_[i - 2])
      return false;
  return true;
}

int GuardedProblem::prepare(const double* u)
{
  ++statistics.factorisations;
  return guard_([&] { problem_.prepare(load_, u); });
}

int GuardedProblem::solve(double* b, double* x)
{
  const int code = guard_(
      [&]
      {
        problem_.solve(b, x);
        if (!is_finite(x, size_))
          throw StepRejected("the tangent is singular");
      });
  if (code == 0 && options_.max_step > 0)
    limit_step(x);
  return code;
}

void GuardedProblem::limit_step(double* x) const
{
  const double largest = compute_largest(x, size_, communicator_);
  if (largest <= options_.max_step)
    return;
  // KINSOL is not told, so that its line search takes the slope of the whole
  // Newton step and never stretches the shortened one again.
  for (std::size_t i = 0; i < size_; ++i)
    x[i] *= options_.max_step / largest;
}

GuardedProblem& get(void* user_data)
{
  return *static_cast<GuardedProblem*>(user_data);
}

int compute_residual(N_Vector u, N_Vector residual, void* user_data)
{
  GuardedProblem& problem = get(user_data);
  const int code = problem.compute_residual(get_data(u), get_data(residual));
  // KINSOL knows only one fixed tolerance on the largest entry. Ours is on the
  // norm and relative to a force that depends on u, so convergence is told to
  // it as a residual of zero.
  if (code == 0 && problem.is_converged())
    std::fill_n(get_data(residual), problem.size(), 0.);
  return code;
}

int prepare(N_Vector u, N_Vector /*residual*/, SUNMatrix /*tangent*/,
            void* user_data, N_Vector /*t1*/, N_Vector /*t2*/)
{
  return get(user_data).prepare(get_data(u));
}

/// KINSOL, set up to iterate on `u`.
class Kinsol
{
public:
  Kinsol(GuardedProblem& problem, std::vector<double>& u,
         const EquilibriumOptions& options);

  /// Returns KINSOL's flag.
  int solve(bool full_steps);
  unsigned int get_iterations() const;
  const std::string& message() const
  {
    return message_;
  }

private:
  std::vector<double> scale_;
  std::string message_;
  ContextHandle context_;
  VectorHandle u_vector_;
  VectorHandle scale_vector_;
  MatrixHandle matrix_;
  LinearSolverHandle solver_;
  SolverMemoryHandle<KINFree> memory_;
};

Kinsol::Kinsol(GuardedProblem& problem, std::vector<double>& u,
               const EquilibriumOptions& options)
    : scale_(u.size(), 1.), context_(make_context()),
      u_vector_(make_vector(problem.communicator(), u.size(), u.data(),
                            context_.get())),
      scale_vector_(make_vector(problem.communicator(), u.size(), scale_.data(),
                                context_.get())),
      matrix_(make_matrix(problem, context_.get())),
      solver_(make_linear_solver(problem, context_.get())),
      memory_(KINCreate(context_.get()))
{
  void* memory = memory_.get();
  check(memory, "KINCreate");
  check(KINSetErrHandlerFn(memory, taut_keep_message, &message_),
        "KINSetErrHandlerFn");
  check(KINInit(memory, time::compute_residual, u_vector_.get()), "KINInit");
  check(KINSetUserData(memory, &problem), "KINSetUserData");
  check(KINSetLinearSolver(memory, solver_.get(), matrix_.get()),
        "KINSetLinearSolver");
  check(KINSetJacFn(memory, time::prepare), "KINSetJacFn");
  check(KINSetMaxSetupCalls(memory, 1), "KINSetMaxSetupCalls");
  check(KINSetNumMaxIters(memory, options.max_iterations), "KINSetNumMaxIters");
  // Converged means a residual of zero, see compute_residual; the steps are
  // limited by ourselves and stagnation is a step below round-off.
  check(KINSetFuncNormTol(memory, std::numeric_limits<double>::min()),
        "KINSetFuncNormTol");
  check(KINSetScaledStepTol(memory, 1e-16), "KINSetScaledStepTol");
  check(KINSetMaxNewtonStep(memory, 1e100), "KINSetMaxNewtonStep");
}

int Kinsol::solve(const bool full_steps)
{
  return KINSol(memory_.get(), u_vector_.get(),
                full_steps ? KIN_NONE : KIN_LINESEARCH, scale_vector_.get(),
                scale_vector_.get());
}

unsigned int Kinsol::get_iterations() const
{
  long iterations = 0;
  check(KINGetNumNonlinSolvIters(memory_.get(), &iterations),
        "KINGetNumNonlinSolvIters");
  return static_cast<unsigned int>(iterations);
}

/// Whether KINSOL met a difficulty of the problem, not one of its own.
bool is_retryable(const int flag)
{
  return flag >= 0 ||
         (flag <= KIN_LINESEARCH_NONCONV && flag >= KIN_LINSOLV_NO_RECOVERY) ||
         (flag <= KIN_LSETUP_FAIL && flag >= KIN_REPTD_SYSFUNC_ERR);
}

/// KINSOL from `u`; returns its flag. Errors: SolverFailed.
int iterate(GuardedProblem& problem, const EquilibriumOptions& options,
            const bool full_steps, std::vector<double>& u)
{
  problem.begin(full_steps);
  Kinsol kinsol(problem, u, options);
  const int flag = kinsol.solve(full_steps);
  problem.guard().rethrow();
  if (!is_retryable(flag) && !problem.circles())
    throw SolverFailed(take_name(KINGetReturnFlagName(flag)) + ": " +
                       kinsol.message());
  problem.statistics.iterations += kinsol.get_iterations();
  return flag;
}

/// Why there is no equilibrium, for the next smaller step.
[[noreturn]] void reject(const GuardedProblem& problem, const int flag)
{
  std::ostringstream message;
  message << "no equilibrium found (" << take_name(KINGetReturnFlagName(flag))
          << "), residual " << problem.residual_norm() << " of "
          << problem.reference_force() << " N after "
          << problem.statistics.iterations << " iterations";
  if (!problem.guard().last_rejection().empty())
    message << "; the last rejected state: "
            << problem.guard().last_rejection();
  throw StepRejected(message.str());
}
} // namespace

EquilibriumStatistics find_equilibrium(EquilibriumProblem& problem,
                                       const double load, double* u,
                                       const EquilibriumOptions& options)
{
  GuardedProblem guarded(problem, load, options);
  std::vector<double> trial(u, u + guarded.size());
  int flag = KIN_SUCCESS;
  if (problem.takes_full_steps())
  {
    flag = iterate(guarded, options, true, trial);
    // Full steps may go round in circles, between a taut and a wrinkled film
    // for instance. By then the beams have usually found their place.
    if (!guarded.is_converged())
    {
      trial = guarded.best();
      problem.forget_iteration();
      flag = iterate(guarded, options, false, trial);
    }
  }
  else
    flag = iterate(guarded, options, false, trial);

  // Only the residual decides: a full stop at round-off is a success, whatever
  // KINSOL calls it.
  std::vector<double> residual(trial.size());
  guarded.begin(false);
  const int code = guarded.compute_residual(trial.data(), residual.data());
  guarded.guard().rethrow();
  if (code != 0 || !guarded.is_converged())
  {
    problem.forget_iteration();
    reject(guarded, flag);
  }
  problem.check_equilibrium(load, trial.data());
  std::copy(trial.begin(), trial.end(), u);
  guarded.statistics.final_residual = guarded.residual_norm();
  return guarded.statistics;
}
} // namespace taut::time
