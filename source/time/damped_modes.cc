#include <taut/time/damped_modes.h>

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "slepc_check.h"

namespace taut::time
{
namespace
{
/// What swings must resemble a vector so much where something creeps, too.
constexpr double resembling = 0.5;

/// A dense matrix on this rank and its eigenvectors.
class DenseEigenproblem
{
public:
  explicit DenseEigenproblem(const std::size_t size)
      : size_(static_cast<PetscInt>(size))
  {
    TAUT_SLEPC(
        MatCreateSeqDense(PETSC_COMM_SELF, size_, size_, nullptr, &matrix_));
    TAUT_SLEPC(EPSCreate(PETSC_COMM_SELF, &solver_));
    TAUT_SLEPC(EPSSetType(solver_, EPSLAPACK));
    TAUT_SLEPC(EPSSetProblemType(solver_, EPS_NHEP));
    TAUT_SLEPC(MatCreateVecs(matrix_, &real_, &imaginary_));
  }
  ~DenseEigenproblem()
  {
    VecDestroy(&imaginary_);
    VecDestroy(&real_);
    EPSDestroy(&solver_);
    MatDestroy(&matrix_);
  }
  DenseEigenproblem(const DenseEigenproblem&) = delete;
  DenseEigenproblem& operator=(const DenseEigenproblem&) = delete;

  void add(const std::size_t row, const std::size_t column, const double value)
  {
    TAUT_SLEPC(MatSetValue(matrix_, static_cast<PetscInt>(row),
                           static_cast<PetscInt>(column), value, ADD_VALUES));
  }
  PetscInt solve()
  {
    TAUT_SLEPC(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
    TAUT_SLEPC(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
    TAUT_SLEPC(EPSSetOperators(solver_, matrix_, nullptr));
    TAUT_SLEPC(EPSSolve(solver_));
    PetscInt count = 0;
    TAUT_SLEPC(EPSGetConverged(solver_, &count));
    return count;
  }
  /// The eigenvalue and the first `n` entries of its vector.
  std::complex<double> get(const PetscInt index, const std::size_t n,
                           std::vector<std::complex<double>>& vector)
  {
    PetscScalar re = 0, im = 0;
    TAUT_SLEPC(EPSGetEigenpair(solver_, index, &re, &im, real_, imaginary_));
    const PetscScalar *x = nullptr, *y = nullptr;
    TAUT_SLEPC(VecGetArrayRead(real_, &x));
    TAUT_SLEPC(VecGetArrayRead(imaginary_, &y));
    vector.clear();
    for (std::size_t i = 0; i < n; ++i)
      vector.emplace_back(x[i], y[i]);
    TAUT_SLEPC(VecRestoreArrayRead(real_, &x));
    TAUT_SLEPC(VecRestoreArrayRead(imaginary_, &y));
    return {re, im};
  }

private:
  PetscInt size_;
  Mat matrix_ = nullptr;
  EPS solver_ = nullptr;
  Vec real_ = nullptr, imaginary_ = nullptr;
};

/// The first-order system of (q, q'/unit, y_1, y_2, ...) in units of time in
/// which its numbers are neither large nor small.
void fill(const DampedVibration& vibration, const double unit,
          DenseEigenproblem& matrix)
{
  const std::size_t n = vibration.size;
  for (std::size_t i = 0; i < n; ++i)
  {
    matrix.add(i, n + i, 1);
    for (std::size_t j = 0; j < n; ++j)
    {
      const std::size_t ij = n * i + j;
      matrix.add(n + i, j, -vibration.stiffness[ij] / (unit * unit));
      matrix.add(n + i, n + j, -vibration.damping[ij] / unit);
      for (std::size_t r = 0; r < vibration.parts.size(); ++r)
        matrix.add(n + i, (2 + r) * n + j,
                   vibration.parts[r].stiffness[ij] / (unit * unit));
    }
    for (std::size_t r = 0; r < vibration.parts.size(); ++r)
    {
      const double rate = 1 / (vibration.parts[r].time * unit);
      matrix.add((2 + r) * n + i, i, rate);
      matrix.add((2 + r) * n + i, (2 + r) * n + i, -rate);
    }
  }
}

double compute_resemblance(const std::vector<std::complex<double>>& q,
                           const std::vector<double>& shape)
{
  std::complex<double> product = 0;
  double square = 0, shape_square = 0;
  for (std::size_t i = 0; i < shape.size(); ++i)
  {
    product += q[i] * shape[i];
    square += std::norm(q[i]);
    shape_square += shape[i] * shape[i];
  }
  return square > 0 ? std::abs(product) / std::sqrt(square * shape_square) : 0;
}
} // namespace

std::complex<double> find_damped_rate(const DampedVibration& vibration,
                                      const std::vector<double>& shape)
{
  const std::size_t n = vibration.size;
  double unit = 0;
  for (std::size_t i = 0; i < n; ++i)
    unit = std::max(unit, std::sqrt(std::abs(vibration.stiffness[n * i + i])));
  if (!(unit > 0))
    unit = 1;
  DenseEigenproblem matrix((2 + vibration.parts.size()) * n);
  fill(vibration, unit, matrix);
  const PetscInt count = matrix.solve();
  std::vector<std::complex<double>> q;
  std::complex<double> swinging, creeping;
  double closest = 0;
  bool creeps = false;
  for (PetscInt i = 0; i < count; ++i)
  {
    const std::complex<double> rate = matrix.get(i, n, q);
    const double resemblance = compute_resemblance(q, shape);
    if (rate.imag() > 0 && resemblance > closest)
    {
      closest = resemblance;
      swinging = rate;
    }
    else if (rate.imag() == 0 && resemblance > resembling &&
             (!creeps || rate.real() > creeping.real()))
    {
      creeps = true;
      creeping = rate.real();
    }
  }
  const bool swings = closest > (creeps ? resembling : 0.);
  return unit * (swings ? swinging : creeping);
}
} // namespace taut::time
