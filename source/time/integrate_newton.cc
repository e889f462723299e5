#include "integrate_newton.h"

#include <arkode/arkode_arkstep.h>

#include <algorithm>
#include <cmath>

namespace taut::time
{
namespace
{
// The constants of ARKODE.
constexpr double forgetting = 0.3;
constexpr double divergence = 2.3;
/// No rate below this is believed, see the class.
constexpr double best_rate = 0.01;
} // namespace

double NewtonConvergence::compute_slowest_rate() const
{
  double gamma = 0;
  if (ARKStepGetCurrentGamma(arkode_memory_, &gamma) != 0)
    return 1;
  const double ratio = gamma * system_.alpha();
  return std::abs(1 - ratio) / (1 + ratio);
}

int NewtonConvergence::test(const int iteration, const double correction,
                            const double tolerance)
{
  if (factorisations_ != system_.factorisations())
    rate_ = 1;
  factorisations_ = system_.factorisations();
  if (iteration > 0)
    rate_ = std::max(forgetting * rate_, correction / previous_correction_);
  rate_ = std::max({rate_, compute_slowest_rate(), best_rate});
  if (std::min(rate_, 1.) * correction <= tolerance)
    return SUN_NLS_SUCCESS;
  if (iteration > 0 && correction > divergence * previous_correction_)
    return SUN_NLS_CONV_RECVR;
  previous_correction_ = correction;
  return SUN_NLS_CONTINUE;
}

int test_newton_convergence(SUNNonlinearSolver solver, N_Vector /*iterate*/,
                            N_Vector correction, const realtype tolerance,
                            N_Vector weights, void* convergence)
{
  int iteration = 0;
  if (SUNNonlinSolGetCurIter(solver, &iteration) != 0)
    return SUN_NLS_MEM_NULL;
  return static_cast<NewtonConvergence*>(convergence)
      ->test(iteration, N_VWrmsNorm(correction, weights), tolerance);
}
} // namespace taut::time
