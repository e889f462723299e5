#pragma once

#include <taut/lumped/resonator_run.h>

namespace taut::lumped
{
/// A history of voltages V* in time.
struct ResonatorRamp
{
  /// r, dV* / dt (1/s).
  double rate = 0;
  ResonatorStart start = ResonatorStart::relaxed;
  time::OdeOptions ode;
};

/// V_f*: the failure under V* = r t. The resonator's own voltage is not used.
/// Errors: BadInput for impossible parameters or a rate that is not positive,
/// SolverFailed as run_quasi_static or if the pre-stretch alone fails.
ResonatorEvent find_ramp_failure(const Resonator& resonator,
                                 const ResonatorRamp& ramp);

/// V_p*: the largest V* to which the resonator can be ramped and at which it
/// can then be held for `hold_time` (s) without failing, to a relative
/// `tolerance`. Errors as find_ramp_failure, and BadInput for a hold time or
/// tolerance that is not positive.
double find_hold_limit(const Resonator& resonator, const ResonatorRamp& ramp,
                       double hold_time, double tolerance = 1e-8);
} // namespace taut::lumped
