#pragma once

#include <taut/time/ode.h>

#include <memory>

namespace taut::time
{
/// One step at a time over a smooth segment, with dense output inside the last
/// one.
class OdeStepper
{
public:
  virtual ~OdeStepper() = default;
  /// Starts anew at (time, y); no step will pass `end`.
  virtual void start(double time, double end, const std::vector<double>& y) = 0;
  /// Advances by one accepted step. Errors as integrate_ode.
  virtual void advance() = 0;
  /// The ends of the last step and the state at the later one.
  virtual double step_start() const = 0;
  virtual double time() const = 0;
  virtual const std::vector<double>& state() const = 0;
  /// The state at a time in [step_start(), time()].
  virtual void interpolate(double time, std::vector<double>& y) = 0;
  /// The same cheaply, only good enough to see where something happens.
  virtual void estimate(double time, std::vector<double>& y) = 0;
};

/// Both count what they do in `statistics`. The references must stay alive.
std::unique_ptr<OdeStepper> make_explicit_stepper(const OdeProblem& problem,
                                                  const OdeOptions& options,
                                                  OdeStatistics& statistics);
std::unique_ptr<OdeStepper> make_implicit_stepper(const OdeProblem& problem,
                                                  const OdeOptions& options,
                                                  OdeStatistics& statistics);
} // namespace taut::time
