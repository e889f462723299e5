#include <taut/time/vibration_modes.h>

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "slepc_check.h"
#include "system_callback.h"

namespace taut::time
{
namespace
{
/// More modes than asked for: where a multiple one is cut, and to see its gap.
constexpr unsigned int spare = 3;

/// What the callbacks need.
struct ShiftedInverse
{
  VibrationProblem& problem;
  CallbackGuard guard;
};

/// Calls function(from, to) on the arrays of two vectors. SLEPc cannot be left
/// in the middle: after a failure it gets zeros.
template <class Function>
PetscErrorCode apply_to(ShiftedInverse& inverse, Vec x, Vec y,
                        const Function& function)
{
  const PetscScalar* from = nullptr;
  PetscScalar* to = nullptr;
  PetscErrorCode code = VecGetArrayRead(x, &from);
  if (code == 0)
    code = VecGetArray(y, &to);
  if (code != 0)
    return code;
  if (inverse.guard([&] { function(from, to); }) != 0)
    std::fill_n(to, inverse.problem.n_unknowns(), 0.);
  code = VecRestoreArrayRead(x, &from);
  if (code == 0)
    code = VecRestoreArray(y, &to);
  return code;
}

PetscErrorCode multiply_mass(Mat matrix, Vec x, Vec y)
{
  void* context = nullptr;
  const PetscErrorCode code = MatShellGetContext(matrix, &context);
  if (code != 0)
    return code;
  auto& inverse = *static_cast<ShiftedInverse*>(context);
  return apply_to(inverse, x, y,
                  [&](const double* from, double* to)
                  { inverse.problem.multiply_mass(from, to); });
}

/// y = (K - shift M)^{-1} x.
PetscErrorCode solve_shifted(PC preconditioner, Vec x, Vec y)
{
  ShiftedInverse* inverse = nullptr;
  const PetscErrorCode code = PCShellGetContext(preconditioner, &inverse);
  if (code != 0)
    return code;
  return apply_to(*inverse, x, y,
                  [&](const double* from, double* to)
                  { inverse->problem.solve(from, to); });
}

/// The eigenproblem at one shift, factorised.
class ModeSolver
{
public:
  ModeSolver(VibrationProblem& problem, const double shift)
      : size_(problem.n_unknowns()), inverse_{problem,
                                              CallbackGuard(Communicator(
                                                  problem.communicator()))}
  {
    const MPI_Comm communicator = problem.communicator();
    const auto size = static_cast<PetscInt>(size_);
    for (Mat* matrix : {&stiffness_, &mass_})
      TAUT_SLEPC(MatCreateShell(communicator, size, size, PETSC_DETERMINE,
                                PETSC_DETERMINE, &inverse_, matrix));
    TAUT_SLEPC(MatShellSetOperation(
        mass_, MATOP_MULT, reinterpret_cast<void (*)()>(multiply_mass)));
    TAUT_SLEPC(EPSCreate(communicator, &solver_));
    TAUT_SLEPC(EPSSetOperators(solver_, stiffness_, mass_));
    TAUT_SLEPC(EPSSetProblemType(solver_, EPS_GHEP));
    TAUT_SLEPC(EPSSetType(solver_, EPSKRYLOVSCHUR));
    TAUT_SLEPC(EPSSetTarget(solver_, shift));
    TAUT_SLEPC(EPSSetWhichEigenpairs(solver_, EPS_TARGET_MAGNITUDE));
    set_transformation();
    TAUT_SLEPC(MatCreateVecs(mass_, &vector_, nullptr));
  }
  ~ModeSolver()
  {
    VecDestroy(&vector_);
    EPSDestroy(&solver_);
    MatDestroy(&mass_);
    MatDestroy(&stiffness_);
  }
  ModeSolver(const ModeSolver&) = delete;
  ModeSolver& operator=(const ModeSolver&) = delete;

  std::vector<VibrationMode> solve(unsigned int count, double tolerance);

private:
  void set_transformation();
  void set_start();
  VibrationMode get_mode(PetscInt index);

  std::size_t size_;
  ShiftedInverse inverse_;
  Mat stiffness_ = nullptr, mass_ = nullptr;
  EPS solver_ = nullptr;
  Vec vector_ = nullptr;
};

/// Shift and invert, where the problem itself inverts.
void ModeSolver::set_transformation()
{
  ST transformation = nullptr;
  KSP linear_solver = nullptr;
  PC preconditioner = nullptr;
  TAUT_SLEPC(EPSGetST(solver_, &transformation));
  TAUT_SLEPC(STSetType(transformation, STSINVERT));
  TAUT_SLEPC(STSetMatMode(transformation, ST_MATMODE_SHELL));
  TAUT_SLEPC(STGetKSP(transformation, &linear_solver));
  TAUT_SLEPC(KSPSetType(linear_solver, KSPPREONLY));
  TAUT_SLEPC(KSPGetPC(linear_solver, &preconditioner));
  TAUT_SLEPC(PCSetType(preconditioner, PCSHELL));
  TAUT_SLEPC(PCShellSetContext(preconditioner, &inverse_));
  TAUT_SLEPC(PCShellSetApply(preconditioner, solve_shifted));
}

void ModeSolver::set_start()
{
  // SLEPc's own start is random; this one has a part along every mode.
  PetscInt first = 0;
  PetscScalar* values = nullptr;
  TAUT_SLEPC(VecGetOwnershipRange(vector_, &first, nullptr));
  TAUT_SLEPC(VecGetArray(vector_, &values));
  for (std::size_t i = 0; i < size_; ++i)
    values[i] = 1 + static_cast<double>((first + i) * 7919 % 1009) / 1009;
  TAUT_SLEPC(VecRestoreArray(vector_, &values));
  TAUT_SLEPC(EPSSetInitialSpace(solver_, 1, &vector_));
}

VibrationMode ModeSolver::get_mode(const PetscInt index)
{
  VibrationMode mode;
  PetscScalar imaginary = 0;
  TAUT_SLEPC(EPSGetEigenpair(solver_, index, &mode.square, &imaginary, vector_,
                             nullptr));
  const PetscScalar* values = nullptr;
  TAUT_SLEPC(VecGetArrayRead(vector_, &values));
  mode.shape.assign(values, values + size_);
  TAUT_SLEPC(VecRestoreArrayRead(vector_, &values));
  std::vector<double> product(size_);
  inverse_.problem.multiply_mass(mode.shape.data(), product.data());
  double mass = std::inner_product(product.begin(), product.end(),
                                   mode.shape.begin(), 0.);
  MPI_Allreduce(MPI_IN_PLACE, &mass, 1, MPI_DOUBLE, MPI_SUM,
                inverse_.problem.communicator());
  for (double& entry : mode.shape)
    entry /= std::sqrt(mass);
  return mode;
}

std::vector<VibrationMode> ModeSolver::solve(const unsigned int count,
                                             const double tolerance)
{
  PetscInt size = 0;
  TAUT_SLEPC(VecGetSize(vector_, &size));
  const PetscInt n = std::min<PetscInt>(count, size);
  const PetscInt basis = std::min<PetscInt>(2 * n + 20, size);
  TAUT_SLEPC(EPSSetDimensions(solver_, n, basis, PETSC_DEFAULT));
  TAUT_SLEPC(EPSSetTolerances(solver_, tolerance, 1000));
  set_start();
  TAUT_SLEPC(EPSSolve(solver_));
  inverse_.guard.rethrow();
  if (!inverse_.guard.last_rejection().empty())
    throw SolverFailed(inverse_.guard.last_rejection());
  PetscInt n_converged = 0;
  TAUT_SLEPC(EPSGetConverged(solver_, &n_converged));
  std::vector<VibrationMode> modes;
  for (PetscInt i = 0; i < std::min(n_converged, n); ++i)
    modes.push_back(get_mode(i));
  // Unknowns without mass leave 1/(s - shift) = 0.
  const auto is_none = [](const VibrationMode& mode)
  { return !(std::abs(mode.square) < 1e+100); };
  modes.erase(std::remove_if(modes.begin(), modes.end(), is_none), modes.end());
  if (modes.empty())
    throw SolverFailed("no vibration mode was found");
  std::sort(modes.begin(), modes.end(),
            [](const auto& a, const auto& b) { return a.square < b.square; });
  return modes;
}

/// Factorises at the shift or, if it meets an eigenvalue, next to it.
int factorise_next_to(VibrationProblem& problem, double& shift)
{
  try
  {
    return problem.factorise(shift);
  }
  catch (const StepRejected&)
  {
    shift -= std::max(1., std::abs(shift)) * 1e-4;
    return problem.factorise(shift);
  }
}

double get_spread(const std::vector<VibrationMode>& modes)
{
  double largest = 0;
  for (const VibrationMode& mode : modes)
    largest = std::max(largest, std::abs(mode.square));
  const double spread = modes.back().square - modes.front().square;
  return std::max(spread, 1e-3 * largest);
}

/// As many modes lie below the widest of the last gaps as were found there.
bool is_complete(VibrationProblem& problem,
                 const std::vector<VibrationMode>& modes)
{
  if (modes.size() < 2)
    return true;
  const std::size_t first = modes.size() > spare ? modes.size() - spare - 1 : 0;
  std::size_t widest = first;
  const auto gap = [&](const std::size_t i)
  { return modes[i + 1].square - modes[i].square; };
  for (std::size_t i = first; i + 1 < modes.size(); ++i)
    if (gap(i) > gap(widest))
      widest = i;
  double cut = modes[widest].square + 0.5 * gap(widest);
  return factorise_next_to(problem, cut) == int(widest) + 1;
}

ModeSearch find_lowest(VibrationProblem& problem, const ModeOptions& options)
{
  constexpr unsigned int most_shifts = 60;
  double shift = -1;
  for (unsigned int i = 0; i < most_shifts; ++i)
  {
    if (factorise_next_to(problem, shift) > 0)
    {
      shift *= 10;
      continue;
    }
    auto modes = ModeSolver(problem, shift)
                     .solve(options.count + spare, options.tolerance);
    const double spread = get_spread(modes);
    const double distance = modes.front().square - shift;
    if (distance < 10 * spread && distance > 1e-3 * spread)
    {
      ModeSearch search{std::move(modes)};
      search.complete = is_complete(problem, search.modes);
      return search;
    }
    shift = modes.front().square - spread;
  }
  throw SolverFailed("no shift lies below all vibration modes: an unknown "
                     "without mass is unstable");
}

ModeSearch find_next_to(VibrationProblem& problem, const ModeOptions& options)
{
  double shift = *options.target;
  factorise_next_to(problem, shift);
  return {ModeSolver(problem, shift)
              .solve(options.count + spare, options.tolerance)};
}

/// Those next to the target, or the lowest.
void keep(const ModeOptions& options, std::vector<VibrationMode>& modes)
{
  const double target =
      options.target.value_or(-std::numeric_limits<double>::max());
  while (modes.size() > options.count)
    if (std::abs(modes.front().square - target) >
        std::abs(modes.back().square - target))
      modes.erase(modes.begin());
    else
      modes.pop_back();
}
} // namespace

ModeSearch find_modes(VibrationProblem& problem, const ModeOptions& options)
{
  ModeSearch search = options.target ? find_next_to(problem, options)
                                     : find_lowest(problem, options);
  keep(options, search.modes);
  return search;
}
} // namespace taut::time
