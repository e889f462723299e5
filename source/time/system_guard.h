#pragma once

#include <taut/time/system.h>

#include "system_callback.h"

namespace taut::time
{
/// Global sizes of the blocks of a state, and of all of it.
struct GlobalSizes
{
  long long positions = 0;
  long long velocities = 0;
  long long internal = 0;
  long long globals = 0;
  long long scalars = 0;
  long long all = 0;
};

/// A system whose methods can be called from C: they return codes, reject what
/// is not finite and count.
class GuardedSystem
{
public:
  explicit GuardedSystem(System& system);

  int evaluate(double time, const double* state, double* f);
  int multiply_mass(const double* x, double* result);
  int solve_mass(const double* b, double* x);
  int prepare(double time, const double* state, double alpha);
  int solve(const double* r, double* d);

  /// For calls outside C frames: these throw what the system throws.
  void compute_f(double time, const double* state, double* f);
  System& get_system()
  {
    return system_;
  }

  const Communicator& communicator() const
  {
    return communicator_;
  }
  const StateLayout& layout() const
  {
    return layout_;
  }
  const GlobalSizes& sizes() const
  {
    return sizes_;
  }
  bool is_inertial() const
  {
    return sizes_.velocities > 0;
  }
  CallbackGuard& guard()
  {
    return guard_;
  }
  /// The alpha of the last prepare.
  double alpha() const
  {
    return alpha_;
  }
  long evaluations() const
  {
    return evaluations_;
  }
  long factorisations() const
  {
    return factorisations_;
  }
  long solves() const
  {
    return solves_;
  }

private:
  System& system_;
  Communicator communicator_;
  CallbackGuard guard_;
  StateLayout layout_;
  GlobalSizes sizes_;
  double alpha_ = 0;
  long evaluations_ = 0;
  long factorisations_ = 0;
  long solves_ = 0;
};

/// Whether every entry is a finite number (of this rank).
bool is_finite(const double* values, std::size_t size);
} // namespace taut::time
