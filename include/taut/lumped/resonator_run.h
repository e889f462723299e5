#pragma once

#include <taut/lumped/resonator_row.h>
#include <taut/time/ode.h>

#include <optional>
#include <string>
#include <vector>

namespace taut::lumped
{
/// How a resonator can fail. The balance cannot lose its stability before the
/// tension: every network's stiffness is at least its stress over lambda_1, so
/// that Omega_n^2 >= s_1 / lambda_1A + k ds_1B / dlambda_1B > 0 while s_1 > 0.
enum class ResonatorFailure
{
  /// s_1 <= 0.
  loss_of_tension_1,
  /// s_2 <= 0.
  loss_of_tension_2,
  /// V* >= d / (lambda_1A lambda_2).
  breakdown
};

enum class ResonatorPlace
{
  a,
  b,
  a_and_b
};

std::string to_text(ResonatorFailure failure);
std::string to_text(ResonatorPlace place);

struct ResonatorEvent
{
  ResonatorFailure failure = ResonatorFailure::loss_of_tension_1;
  ResonatorPlace place = ResonatorPlace::a;
  /// Present already at the start; such an event does not stop the run.
  bool at_start = false;
  /// The state at the event.
  ResonatorRow row;
};

/// The internal stretches with which a run starts.
enum class ResonatorStart
{
  /// All 1: the pre-stretch has just been applied.
  unrelaxed,
  /// Relaxed at the voltage of the start.
  relaxed,
  /// ResonatorRunOptions::internal.
  given
};

struct ResonatorRunOptions
{
  double start_time = 0;
  /// s.
  double end_time = 0;
  /// Increasing (s); start and end are always written.
  std::vector<double> output_times;
  ResonatorStart start = ResonatorStart::unrelaxed;
  /// For ResonatorStart::given: n_internal() stretches.
  std::vector<double> internal;
  /// Inertial runs start this far from the balance, with this velocity (1/s).
  double displacement = 0;
  double velocity = 0;
  bool stop_at_failure = true;
  time::OdeOptions ode;
};

/// Errors: BadInput if the run does not end after it starts.
void validate(const ResonatorRunOptions& options);

struct ResonatorRun
{
  std::vector<ResonatorRow> rows;
  /// In order of time.
  std::vector<ResonatorEvent> events;
  /// The event that ended the run, if one did.
  std::optional<ResonatorEvent> failure;
  time::OdeStatistics statistics;
};

/// Follows the balance s_1A = s_1B (3.16) while the internal stretches evolve
/// (3.19 to 3.22). The balance is solved to round-off inside the right-hand
/// side.
/// Errors: BadInput for impossible parameters or options, SolverFailed as
/// time::integrate_ode.
ResonatorRun run_quasi_static(const Resonator& resonator,
                              const ResonatorRunOptions& options);

/// Integrates lambda_1A'' + alpha (s_1A - s_1B) = 0 (3.14, 3.15) with the
/// evolution. The automatic method stays explicit here: the oscillation decides
/// the steps. Errors as run_quasi_static.
ResonatorRun run_inertial(const Resonator& resonator,
                          const ResonatorRunOptions& options);
} // namespace taut::lumped
