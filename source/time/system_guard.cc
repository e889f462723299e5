#include "system_guard.h"

#include <cmath>
#include <stdexcept>

namespace taut::time
{
namespace
{
GlobalSizes compute_sizes(const StateLayout& layout,
                          const Communicator& communicator)
{
  const auto sum = [&](const std::size_t size)
  { return communicator.sum(static_cast<long long>(size)); };
  GlobalSizes sizes;
  sizes.positions = sum(layout.positions);
  sizes.velocities = sum(layout.velocities);
  sizes.internal = sum(layout.internal);
  sizes.globals = sum(layout.globals);
  sizes.scalars = sum(layout.scalars);
  sizes.all = sum(layout.size());
  return sizes;
}
} // namespace

bool is_finite(const double* values, const std::size_t size)
{
  // One sum instead of a test per entry: any infinity or NaN survives in it.
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i)
    sum += 0 * values[i];
  return std::isfinite(sum);
}

GuardedSystem::GuardedSystem(System& system)
    : system_(system), communicator_(system.communicator()),
      guard_(communicator_), layout_(system.layout()),
      sizes_(compute_sizes(layout_, communicator_))
{
  if (layout_.velocities != (is_inertial() ? layout_.positions : 0))
    throw std::logic_error("a state has as many velocities as positions, or "
                           "none at all");
}

void GuardedSystem::compute_f(const double time, const double* state, double* f)
{
  ++evaluations_;
  system_.evaluate(time, state, f);
  if (!is_finite(f, layout_.size()))
    throw StepRejected("the right-hand side is not a finite number");
}

int GuardedSystem::evaluate(const double time, const double* state, double* f)
{
  return guard_([&] { compute_f(time, state, f); });
}

int GuardedSystem::multiply_mass(const double* x, double* result)
{
  return guard_([&] { system_.multiply_mass(x, result); });
}

int GuardedSystem::solve_mass(const double* b, double* x)
{
  return guard_([&] { system_.solve_mass(b, x); });
}

int GuardedSystem::prepare(const double time, const double* state,
                           const double alpha)
{
  ++factorisations_;
  alpha_ = alpha;
  return guard_([&] { system_.prepare(time, state, alpha); });
}

int GuardedSystem::solve(const double* r, double* d)
{
  ++solves_;
  return guard_(
      [&]
      {
        system_.solve(r, d);
        if (!is_finite(d, layout_.size()))
          throw StepRejected("the tangent is singular");
      });
}
} // namespace taut::time
