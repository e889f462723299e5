#pragma once

#include <taut/time/integrate.h>

#include <vector>

namespace taut::time
{
/// Two times that differ by less than 1e-12 of themselves are one.
bool is_same_time(double a, double b);

/// A time that no step crosses.
struct Stop
{
  double time = 0;
  /// The right-hand side jumps.
  bool is_jump = false;
  /// A checkpoint is due.
  bool is_restart = false;
};

/// All stops of a run in (start, end], increasing, the end included.
std::vector<Stop> make_stops(const System& system, const Schedule& schedule);
} // namespace taut::time
