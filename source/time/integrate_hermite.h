#pragma once

#include <taut/time/system.h>

namespace taut::time
{
/// One end of a step.
struct StepEnd
{
  double time = 0;
  const double* state = nullptr;
  /// f(time, state); only its internal and scalar blocks are read.
  const double* f = nullptr;
};

/// Dense output between two ends of a step of an inertial system.
///
/// Positions: the cubic through (u, v) at both ends, error O(h^4). Velocities:
/// its derivative, error O(h^3), which needs no acceleration (no solve with
/// the mass), meets v at both ends and stays the rate of the interpolated
/// positions. Internal variables and scalars: the cubic through (A, A'), error
/// O(h^4).
void interpolate_hermite(const StateLayout& layout, const StepEnd& begin,
                         const StepEnd& end, double time, double* state);
} // namespace taut::time
