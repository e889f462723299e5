#pragma once

#include <taut/fe/nodes.h>

struct _p_Mat;
struct _p_KSP;

namespace taut::fe
{
/// A direct solver (MUMPS) that keeps its symbolic analysis while the pattern
/// of the matrix stays the same.
class LinearSolver
{
public:
  enum class Kind
  {
    symmetric_definite, ///< L L^T; only for matrices known to be definite
    symmetric,          ///< L D L^T of the upper triangle
    general             ///< L U
  };

  LinearSolver(_p_Mat* matrix, Kind kind);
  ~LinearSolver();
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;

  /// Factorises the current values. Errors: StepRejected if the matrix is
  /// singular.
  void factorise();

  /// x = matrix^{-1} b on the owned entries; `b` and `x` may be the same.
  void solve(const double* b, double* x);

  /// Negative eigenvalues of the factorised symmetric matrix (Sylvester); of
  /// the symmetric part of a general one, which is factorised for it. Errors:
  /// StepRejected if that part is singular.
  int count_negative_eigenvalues();

private:
  void create();

  _p_Mat* matrix_;
  const Kind kind_;
  _p_KSP* solver_ = nullptr;
};

/// result = matrix x on the owned entries.
void multiply(_p_Mat* matrix, const double* x, double* result);
} // namespace taut::fe
