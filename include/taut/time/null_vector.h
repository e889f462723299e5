#pragma once

#include <taut/time/equilibrium.h>

#include <vector>

namespace taut::time
{
/// An eigenvalue and its vector (this rank's part, Euclidean norm 1).
struct EigenPair
{
  double value = 0;
  std::vector<double> vector;
};

/// The eigenvalue of the tangent that is nearest to zero, found by SLEPc as the
/// largest one of problem.solve; next to a critical point its vector is the
/// null vector. The problem must have been prepared. `guess`: a vector near it
/// or none if empty. Collective.
/// Errors: StepRejected if the tangent cannot be solved with or the iteration
/// does not converge; SolverFailed if SLEPc fails.
EigenPair find_nearest_eigenvalue(EquilibriumProblem& problem,
                                  const std::vector<double>& guess = {});
} // namespace taut::time
