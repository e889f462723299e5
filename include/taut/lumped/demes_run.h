#pragma once

#include <taut/lumped/demes.h>
#include <taut/time/ode.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace taut::lumped
{
struct DemesState
{
  /// theta (rad).
  double angle = 0;
  /// theta'.
  double velocity = 0;
  /// xi.
  double inner_stretch = 1;
};

/// Initial conditions (26): a straight frame whose film has just been relaxed
/// at the pre-stretch, xi = lambda_p, at rest. The straight frame without
/// eccentricity is an equilibrium that never moves; `seed` is the small angle
/// (rad) from which it leaves. It only delays the start, by ln(1 / seed) over
/// the growth rate.
DemesState make_flat_start(const Demes& demes, double seed);

/// The relaxed state of least energy at the drive e, with which driven runs
/// start; of two with opposite angles the one that is positive.
/// Errors: BadInput for impossible parameters.
DemesState make_rest_start(const Demes& demes, double drive = 0);

/// Direct and alternating voltage (27),
///   e(tau) = e_reference (V_dc + V_ac sin(w tau)) / V_reference.
/// The film feels e^2 and so both w and 2 w.
Signal make_drive(double reference_drive, double reference_voltage,
                  double direct_voltage, double alternating_voltage,
                  double frequency);

/// The DEMES at one time, dimensionless as in `Demes`.
struct DemesRow
{
  /// tau.
  double time = 0;
  double angle = 0;
  double velocity = 0;
  double inner_stretch = 0;
  double stretch = 0;
  /// e.
  double drive = 0;
  /// The charge under prescribed voltage, the voltage under charge.
  double conjugate = 0;
  /// s; negative: the model pushes where a real film goes slack.
  double membrane_force = 0;
  /// kinetic + free + dissipated + source work is constant. The last is the
  /// integral of charge de under prescribed voltage and that of -voltage de
  /// under prescribed charge.
  double kinetic_energy = 0;
  double free_energy = 0;
  double dissipated_energy = 0;
  double source_work = 0;

  double get_total_energy() const
  {
    return kinetic_energy + free_energy + dissipated_energy + source_work;
  }
};

/// The film's force turned negative.
struct DemesEvent
{
  /// So already at the start; such an event does not stop the run.
  bool at_start = false;
  DemesRow row;
};

struct DemesRunOptions
{
  double start_time = 0;
  /// tau.
  double end_time = 0;
  /// Increasing; start and end are always written.
  std::vector<double> output_times;
  DemesState start;
  bool stop_at_compression = false;
  /// Local error of a step, over the size of the angle and of the inner
  /// stretch; also inside the step, at its end it is far smaller.
  double tolerance = 1e-9;
  double largest_step = std::numeric_limits<double>::infinity();
  long max_steps = 5000000;
};

/// Errors: BadInput if the run does not end after it starts, or for an
/// impossible tolerance.
void validate(const DemesRunOptions& options);

struct DemesRun
{
  std::vector<DemesRow> rows;
  /// In order of time, one each time the film's force falls through zero.
  std::vector<DemesEvent> events;
  /// The event that ended the run, if one did.
  std::optional<DemesEvent> stop;
  /// The smallest force of the film and when it was reached.
  double smallest_force = 0;
  double smallest_force_time = 0;
  /// What the reader of the rows must know, as sentences.
  std::vector<std::string> notes;
  time::OdeStatistics statistics;
};

/// The rest states at the drives of the history, as if it went infinitely
/// slowly: from that of make_rest_start always to the stable one next to the
/// last. Only the times of the options count. What is dissipated and the
/// source's work are not tracked, and the film's force is looked at in the rows
/// alone.
/// Errors: BadInput for impossible parameters or options, SolverFailed if there
/// is no stable shape.
DemesRun run_rest_states(const Demes& demes, const DemesRunOptions& options);

/// Integrates the boxed equations.
/// Errors: BadInput for impossible parameters or options, SolverFailed if the
/// step vanishes or max_steps is exceeded.
DemesRun run_demes(const Demes& demes, const DemesRunOptions& options);
} // namespace taut::lumped
