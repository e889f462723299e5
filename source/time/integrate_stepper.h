#pragma once

#include <taut/time/integrate.h>

#include <memory>

#include "system_guard.h"

namespace taut::time
{
/// A smooth piece of a run: from a state to the next stop time.
struct Segment
{
  double start = 0;
  const double* state = nullptr;
  double stop = 0;
};

/// An integrator with everything it remembers; a new one is a fresh start.
class Stepper
{
public:
  virtual ~Stepper() = default;

  /// Takes one step, at most to the end of the segment, and returns the time
  /// reached. Errors: SolverFailed, or what the system threw other than
  /// StepRejected.
  virtual double advance() = 0;
  /// The state after the last step.
  virtual const double* state() const = 0;
  /// Order of the method in the last step.
  virtual int order() const = 0;
  /// Dense output inside the last step.
  virtual void interpolate(double time, double* state) = 0;
  /// Counts of the integrator itself (not those of the system).
  virtual IntegratorStatistics statistics() const = 0;
};

/// The integrator that options.method asks for. The system and the options
/// must outlive it.
std::unique_ptr<Stepper> make_stepper(GuardedSystem& system,
                                      const IntegratorOptions& options,
                                      const Segment& segment);

std::unique_ptr<Stepper> make_arkode_stepper(GuardedSystem& system,
                                             const IntegratorOptions& options,
                                             const Segment& segment);
std::unique_ptr<Stepper> make_ida_stepper(GuardedSystem& system,
                                          const IntegratorOptions& options,
                                          const Segment& segment);

/// Throws what ended a callback or, if none did, SolverFailed with the time,
/// the integrator's `flag_name` and the reason of the last rejected state.
[[noreturn]] void fail(const CallbackGuard& guard, double time,
                       const std::string& flag_name);

/// SolverFailed unless `reached` is after `start`.
void require_progress(const CallbackGuard& guard, double start, double reached);

/// Failed attempts at one step after which an integrator gives up.
constexpr int max_failures_per_step = 20;
} // namespace taut::time
