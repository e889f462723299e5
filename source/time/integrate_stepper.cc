#include "integrate_stepper.h"

#include <sstream>

namespace taut::time
{
std::unique_ptr<Stepper> make_stepper(GuardedSystem& system,
                                      const IntegratorOptions& options,
                                      const Segment& segment)
{
  return options.method == Method::bdf
             ? make_ida_stepper(system, options, segment)
             : make_arkode_stepper(system, options, segment);
}

void fail(const CallbackGuard& guard, const double time,
          const std::string& flag_name)
{
  guard.rethrow();
  std::ostringstream message;
  message.precision(12);
  message << "the integrator gave up at time " << time << " s (" << flag_name
          << ")";
  if (!guard.last_rejection().empty())
    message << "; the last rejected state: " << guard.last_rejection();
  throw SolverFailed(message.str());
}

void require_progress(const CallbackGuard& guard, const double start,
                      const double reached)
{
  if (!(reached > start))
    fail(guard, start, "the step is too small to advance the time");
}
} // namespace taut::time
