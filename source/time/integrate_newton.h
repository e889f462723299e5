#pragma once

#include "system_guard.h"
#include "system_sundials.h"

namespace taut::time
{
/// When Newton's iteration for a stage of ARKODE has converged: as ARKODE's
/// own test, from the last correction and the estimated rate of convergence,
/// but with a lower bound on that rate.
///
/// ARKODE forgets its estimate only when the matrix is factorised anew. Where
/// the tangent is exact, steps of one length drive it to zero, and after a
/// change of the step that keeps the factors the first correction is believed
/// although its error is |gamma/gamma_factors - 1| of it: measured 600 times
/// the tolerance in one step of a linear oscillator. With corrections scaled
/// by 2/(1 + r), r = gamma/gamma_factors, the iteration matrix has
/// the spectral radius |1 - r|/(1 + r): the lower bound used here.
///
/// The other lower bound, 0.01, is for what the norm does not see. Scalars and
/// whatever else weighs nothing are as good as the state at which f was
/// evaluated last, one iteration behind. Measured on viscous oscillators: the
/// defect of the energy balance falls by a factor of 1000 (5e-4 to 1e-6) for
/// 1 to 5 % more iterations; a larger bound gains nothing.
class NewtonConvergence
{
public:
  NewtonConvergence(GuardedSystem& system, void* arkode_memory)
      : system_(system), arkode_memory_(arkode_memory)
  {
  }

  /// SUNDIALS' code after correction number `iteration` of the given norm.
  int test(int iteration, double correction, double tolerance);

private:
  double compute_slowest_rate() const;

  GuardedSystem& system_;
  void* arkode_memory_;
  long factorisations_ = -1;
  double rate_ = 1;
  double previous_correction_ = 0;
};

/// The SUNNonlinSolConvTestFn; `convergence` is a NewtonConvergence.
int test_newton_convergence(SUNNonlinearSolver solver, N_Vector iterate,
                            N_Vector correction, realtype tolerance,
                            N_Vector weights, void* convergence);
} // namespace taut::time
