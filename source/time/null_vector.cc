#include <taut/time/null_vector.h>

#include <slepceps.h>

#include <algorithm>

#include "slepc_check.h"
#include "system_callback.h"

namespace taut::time
{
namespace
{
/// What the products of the shell matrix need.
struct Inverse
{
  EquilibriumProblem& problem;
  CallbackGuard guard;
};

PetscErrorCode multiply(Mat matrix, Vec x, Vec result)
{
  void* context = nullptr;
  const PetscScalar* from = nullptr;
  PetscScalar* to = nullptr;
  PetscErrorCode code = MatShellGetContext(matrix, &context);
  if (code == 0)
    code = VecGetArrayRead(x, &from);
  if (code == 0)
    code = VecGetArray(result, &to);
  if (code != 0)
    return code;
  // SLEPc cannot be left in the middle: after a failure it gets zeros.
  auto& inverse = *static_cast<Inverse*>(context);
  if (inverse.guard([&] { inverse.problem.solve(from, to); }) != 0)
    std::fill_n(to, inverse.problem.n_unknowns(), 0.);
  code = VecRestoreArrayRead(x, &from);
  if (code == 0)
    code = VecRestoreArray(result, &to);
  return code;
}

/// The eigenproblem of the inverse tangent.
class InverseEigenproblem
{
public:
  explicit InverseEigenproblem(EquilibriumProblem& problem)
      : size_(problem.n_unknowns()), inverse_{problem,
                                              CallbackGuard(Communicator(
                                                  problem.communicator()))}
  {
    const MPI_Comm communicator = problem.communicator();
    const auto size = static_cast<PetscInt>(size_);
    TAUT_SLEPC(MatCreateShell(communicator, size, size, PETSC_DETERMINE,
                              PETSC_DETERMINE, &inverse_, &matrix_));
    TAUT_SLEPC(MatShellSetOperation(matrix_, MATOP_MULT,
                                    reinterpret_cast<void (*)()>(multiply)));
    TAUT_SLEPC(EPSCreate(communicator, &solver_));
    TAUT_SLEPC(EPSSetOperators(solver_, matrix_, nullptr));
    // Follower loads leave the tangent without symmetry.
    TAUT_SLEPC(EPSSetProblemType(solver_, EPS_NHEP));
    TAUT_SLEPC(EPSSetType(solver_, EPSKRYLOVSCHUR));
    TAUT_SLEPC(EPSSetWhichEigenpairs(solver_, EPS_LARGEST_MAGNITUDE));
    TAUT_SLEPC(EPSSetDimensions(solver_, 1, PETSC_DEFAULT, PETSC_DEFAULT));
    TAUT_SLEPC(EPSSetTolerances(solver_, 1e-10, 1000));
    TAUT_SLEPC(MatCreateVecs(matrix_, &vector_, nullptr));
  }
  ~InverseEigenproblem()
  {
    VecDestroy(&vector_);
    EPSDestroy(&solver_);
    MatDestroy(&matrix_);
  }
  InverseEigenproblem(const InverseEigenproblem&) = delete;
  InverseEigenproblem& operator=(const InverseEigenproblem&) = delete;

  EigenPair solve(const std::vector<double>& guess);

private:
  void set_start(const std::vector<double>& guess);
  void iterate();

  std::size_t size_;
  Inverse inverse_;
  Mat matrix_ = nullptr;
  EPS solver_ = nullptr;
  Vec vector_ = nullptr;
};

void InverseEigenproblem::set_start(const std::vector<double>& guess)
{
  // SLEPc's own start is random. This one is the same in every run and has a
  // part along every vector of a device.
  PetscInt first = 0;
  PetscScalar* values = nullptr;
  TAUT_SLEPC(VecGetOwnershipRange(vector_, &first, nullptr));
  TAUT_SLEPC(VecGetArray(vector_, &values));
  for (std::size_t i = 0; i < size_; ++i)
    values[i] = 1 + static_cast<double>((first + i) * 7919 % 1009) / 1009;
  if (guess.size() == size_)
    for (std::size_t i = 0; i < size_; ++i)
      values[i] = guess[i] + 1e-6 * values[i];
  TAUT_SLEPC(VecRestoreArray(vector_, &values));
  TAUT_SLEPC(EPSSetInitialSpace(solver_, 1, &vector_));
}

void InverseEigenproblem::iterate()
{
  TAUT_SLEPC(EPSSolve(solver_));
  inverse_.guard.rethrow();
  if (!inverse_.guard.last_rejection().empty())
    throw StepRejected(inverse_.guard.last_rejection());
}

EigenPair InverseEigenproblem::solve(const std::vector<double>& guess)
{
  set_start(guess);
  iterate();
  PetscInt n_converged = 0;
  TAUT_SLEPC(EPSGetConverged(solver_, &n_converged));
  if (n_converged < 1)
    throw StepRejected("the eigenvalue nearest to zero was not found");
  PetscScalar value = 0, imaginary = 0;
  TAUT_SLEPC(EPSGetEigenpair(solver_, 0, &value, &imaginary, vector_, nullptr));
  EigenPair pair;
  pair.value = 1 / value;
  const PetscScalar* values = nullptr;
  TAUT_SLEPC(VecGetArrayRead(vector_, &values));
  pair.vector.assign(values, values + size_);
  TAUT_SLEPC(VecRestoreArrayRead(vector_, &values));
  return pair;
}
} // namespace

EigenPair find_nearest_eigenvalue(EquilibriumProblem& problem,
                                  const std::vector<double>& guess)
{
  return InverseEigenproblem(problem).solve(guess);
}
} // namespace taut::time
