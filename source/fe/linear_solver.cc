#include <taut/base/exceptions.h>
#include <taut/fe/linear_solver.h>
#include <taut/fe/petsc.h>

namespace taut::fe
{
namespace
{
/// A PETSc vector around somebody else's array.
class VectorView
{
public:
  VectorView(Mat matrix, const double* values)
  {
    MPI_Comm comm;
    PetscInt n = 0;
    TAUT_PETSC(
        PetscObjectGetComm(reinterpret_cast<PetscObject>(matrix), &comm));
    TAUT_PETSC(MatGetLocalSize(matrix, &n, nullptr));
    TAUT_PETSC(
        VecCreateMPIWithArray(comm, 1, n, PETSC_DETERMINE, values, &vector_));
  }
  ~VectorView()
  {
    VecDestroy(&vector_);
  }
  VectorView(const VectorView&) = delete;
  VectorView& operator=(const VectorView&) = delete;
  operator Vec() const
  {
    return vector_;
  }

private:
  Vec vector_ = nullptr;
};

/// A + A^T.
class TwiceSymmetricPart
{
public:
  explicit TwiceSymmetricPart(Mat matrix)
  {
    TAUT_PETSC(MatTranspose(matrix, MAT_INITIAL_MATRIX, &sum_));
    TAUT_PETSC(MatAXPY(sum_, 1., matrix, DIFFERENT_NONZERO_PATTERN));
  }
  ~TwiceSymmetricPart()
  {
    MatDestroy(&sum_);
  }
  TwiceSymmetricPart(const TwiceSymmetricPart&) = delete;
  TwiceSymmetricPart& operator=(const TwiceSymmetricPart&) = delete;
  operator Mat() const
  {
    return sum_;
  }

private:
  Mat sum_ = nullptr;
};

int count_negative_of_symmetric_part(Mat matrix)
{
  const TwiceSymmetricPart sum(matrix);
  LinearSolver solver(sum, LinearSolver::Kind::symmetric);
  solver.factorise();
  return solver.count_negative_eigenvalues();
}
} // namespace

LinearSolver::LinearSolver(Mat matrix, const Kind kind)
    : matrix_(matrix), kind_(kind)
{
  create();
}

void LinearSolver::create()
{
  MPI_Comm comm;
  TAUT_PETSC(PetscObjectGetComm(reinterpret_cast<PetscObject>(matrix_), &comm));
  TAUT_PETSC(KSPCreate(comm, &solver_));
  TAUT_PETSC(KSPSetType(solver_, KSPPREONLY));
  PC preconditioner = nullptr;
  TAUT_PETSC(KSPGetPC(solver_, &preconditioner));
  TAUT_PETSC(
      PCSetType(preconditioner, kind_ == Kind::general ? PCLU : PCCHOLESKY));
  TAUT_PETSC(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS));
  if (kind_ == Kind::symmetric_definite)
    TAUT_PETSC(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
  TAUT_PETSC(KSPSetOperators(solver_, matrix_, matrix_));
  TAUT_PETSC(PCFactorSetUpMatSolverType(preconditioner));
  Mat factor = nullptr;
  TAUT_PETSC(PCFactorGetMatrix(preconditioner, &factor));
  // Room for fill-in that pivoting adds to the estimate (percent).
  TAUT_PETSC(MatMumpsSetIcntl(factor, 14, 60));
}

LinearSolver::~LinearSolver()
{
  KSPDestroy(&solver_);
}

void LinearSolver::factorise()
{
  TAUT_PETSC(KSPSetOperators(solver_, matrix_, matrix_));
  TAUT_PETSC(KSPSetUp(solver_));
  PC preconditioner = nullptr;
  PCFailedReason reason = PC_NOERROR;
  TAUT_PETSC(KSPGetPC(solver_, &preconditioner));
  TAUT_PETSC(PCGetFailedReason(preconditioner, &reason));
  if (reason == PC_NOERROR)
    return;
  // PETSc's interface to MUMPS skips every factorisation after one that failed.
  TAUT_PETSC(KSPDestroy(&solver_));
  create();
  throw StepRejected("the tangent matrix cannot be factorised: it is "
                     "singular or holds values that are no numbers");
}

void LinearSolver::solve(const double* b, double* x)
{
  const VectorView right_hand_side(matrix_, b);
  if (b == x)
  {
    Vec solution = nullptr;
    TAUT_PETSC(VecDuplicate(right_hand_side, &solution));
    TAUT_PETSC(KSPSolve(solver_, right_hand_side, solution));
    TAUT_PETSC(VecCopy(solution, right_hand_side));
    TAUT_PETSC(VecDestroy(&solution));
  }
  else
  {
    const VectorView solution(matrix_, x);
    TAUT_PETSC(KSPSolve(solver_, right_hand_side, solution));
  }
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  TAUT_PETSC(KSPGetConvergedReason(solver_, &reason));
  if (reason < 0)
    throw StepRejected("the linear solve with the tangent failed");
}

int LinearSolver::count_negative_eigenvalues()
{
  if (kind_ == Kind::general)
    return count_negative_of_symmetric_part(matrix_);
  PC preconditioner = nullptr;
  Mat factor = nullptr;
  PetscInt negative = 0;
  TAUT_PETSC(KSPGetPC(solver_, &preconditioner));
  TAUT_PETSC(PCFactorGetMatrix(preconditioner, &factor));
  // Negative pivots of L D L^T. MatGetInertia insists on MUMPS tolerating
  // singular matrices, which are to be refused.
  TAUT_PETSC(MatMumpsGetInfog(factor, 12, &negative));
  return negative;
}

void multiply(Mat matrix, const double* x, double* result)
{
  const VectorView from(matrix, x);
  const VectorView to(matrix, result);
  TAUT_PETSC(MatMult(matrix, from, to));
}
} // namespace taut::fe
