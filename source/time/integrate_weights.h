#pragma once

#include <taut/time/integrate.h>

#include "system_guard.h"

namespace taut::time
{
/// The weights w of the norm sqrt(sum (w_i e_i)^2 / N) in which the
/// integrators measure errors: constant in each block of the state, so that
/// the norm of a block is its root mean square over its tolerance, whatever
/// the sizes of the other blocks.
struct ErrorWeights
{
  double position = 0;
  double velocity = 0;
  double internal = 0;
  double global = 0;
  double scalar = 0;

  /// Writes them in the layout of the state.
  void fill(const StateLayout& layout, double* weights) const;
};

ErrorWeights compute_error_weights(const GlobalSizes& sizes,
                                   const IntegratorOptions& options);
} // namespace taut::time
