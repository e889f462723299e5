#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/lumped/resonator_critical.h>

#include <limits>

namespace taut::lumped
{
namespace
{
void require_positive(const double value, const std::string& name)
{
  if (!(value > 0))
    throw BadInput("the " + name + " must be positive, got " +
                   number_text(value));
}

ResonatorRun run_ramp(const Resonator& resonator, const ResonatorRamp& ramp,
                      const double limit, const double end_time)
{
  Resonator ramped = resonator;
  ramped.voltage = Signal::ramp(ramp.rate, 0, limit);
  ramped.voltage_unit = 1;
  ResonatorRunOptions options;
  options.end_time = end_time;
  options.start = ramp.start;
  options.ode = ramp.ode;
  return run_quasi_static(ramped, options);
}
} // namespace

ResonatorEvent find_ramp_failure(const Resonator& resonator,
                                 const ResonatorRamp& ramp)
{
  validate(resonator);
  require_positive(ramp.rate, "rate of the ramp");
  // A only grows with the voltage, so breakdown comes at the latest here.
  const double highest =
      resonator.strength / (resonator.pre_stretch_1 * resonator.pre_stretch_2);
  const auto result =
      run_ramp(resonator, ramp, std::numeric_limits<double>::infinity(),
               1.01 * highest / ramp.rate);
  if (!result.failure)
    throw SolverFailed("the ramp of the voltage ended without a failure; has "
                       "the pre-stretch alone failed?");
  return *result.failure;
}

double find_hold_limit(const Resonator& resonator, const ResonatorRamp& ramp,
                       const double hold_time, const double tolerance)
{
  require_positive(hold_time, "time to hold");
  require_positive(tolerance, "tolerance");
  double safe = 0;
  double failing = find_ramp_failure(resonator, ramp).row.voltage;
  // The limit is mostly close to the failure on the ramp.
  for (double gap = 100 * tolerance; failing - safe > tolerance * failing;
       gap *= 10)
  {
    const double middle = (safe + failing) / 2;
    const double voltage = std::max(middle, failing * (1 - gap));
    const auto result =
        run_ramp(resonator, ramp, voltage, voltage / ramp.rate + hold_time);
    (result.failure ? failing : safe) = voltage;
  }
  return (safe + failing) / 2;
}
} // namespace taut::lumped
