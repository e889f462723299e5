#include "integrate_weights.h"

#include <algorithm>
#include <cmath>

namespace taut::time
{
namespace
{
/// sqrt(N / N_block) undoes the division by N in the norm.
double compute_share(const long long all, const long long block)
{
  return block > 0 ? std::sqrt(static_cast<double>(all) / block) : 1;
}
} // namespace

ErrorWeights compute_error_weights(const GlobalSizes& sizes,
                                   const IntegratorOptions& options)
{
  const double rates = options.weight_of_rates;
  ErrorWeights weights;
  weights.position =
      compute_share(sizes.all, sizes.positions) / options.position_tolerance;
  weights.velocity = rates * weights.position * options.velocity_time;
  weights.internal = (sizes.velocities > 0 ? rates : 1) *
                     compute_share(sizes.all, sizes.internal) /
                     options.internal_tolerance;
  weights.global =
      compute_share(sizes.all, sizes.globals) / options.global_tolerance;
  // Nothing depends on them: positive only because SUNDIALS asks for it.
  weights.scalar = 1e-30;
  return weights;
}

void ErrorWeights::fill(const StateLayout& layout, double* weights) const
{
  weights = std::fill_n(weights, layout.positions, position);
  weights = std::fill_n(weights, layout.velocities, velocity);
  weights = std::fill_n(weights, layout.internal, internal);
  weights = std::fill_n(weights, layout.globals, global);
  std::fill_n(weights, layout.scalars, scalar);
}
} // namespace taut::time
