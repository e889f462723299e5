#pragma once

#include <taut/lumped/resonator_row.h>
#include <taut/lumped/resonator_run.h>

#include <optional>
#include <vector>

namespace taut::lumped
{
/// The relaxed resonator (every lambda^i equals its lambda, so that only the
/// ground network carries load) at rest at a voltage V*.
/// Errors: BadInput for impossible parameters, StepRejected if there is no
/// stable balance.
ResonatorRow find_relaxed_state(const Resonator& resonator, double voltage);

/// The state at which a relaxed resonator fails first while the voltage grows
/// infinitely slowly from 0; the time of its row means nothing. `at_start` if
/// the pre-stretch alone fails.
/// Errors: BadInput for impossible parameters.
ResonatorEvent find_static_failure(const Resonator& resonator);

/// The relaxed states at the voltages of the resonator's own history, as if it
/// went infinitely slowly, to the first failure. One that the pre-stretch alone
/// brings ends the run with its first row.
/// Errors: BadInput for impossible parameters or options.
ResonatorRun run_static(const Resonator& resonator,
                        const ResonatorRunOptions& options);

/// V* at which a relaxed resonator loses the tension along x_1, in closed form:
/// there lambda_1B = lambda_2^(-1/2), and s_1A = 0 gives
///   V*^2 = chi J_lim (1 - lambda_1A^-4 lambda_2^-2) / (D lambda_2^2).
/// Errors: BadInput for impossible parameters or if A reaches its Gent limit
/// before.
double compute_slack_voltage(const Resonator& resonator);

/// One pre-stretch of a tuning map.
struct TuningPoint
{
  double pre_stretch_1 = 0;
  double pre_stretch_2 = 0;
  /// Omega_n(V*) - Omega_n(0), both relaxed; 0 where the resonator failed.
  double shift = 0;
  /// Empty where the resonator survives the voltage.
  std::optional<ResonatorFailure> failure;
};

/// How far a voltage tunes the natural frequency of a relaxed resonator, for
/// all pairs of pre-stretches. Errors: BadInput for impossible parameters.
std::vector<TuningPoint>
compute_tuning(const Resonator& resonator, double voltage,
               const std::vector<double>& pre_stretches_1,
               const std::vector<double>& pre_stretches_2);
} // namespace taut::lumped
