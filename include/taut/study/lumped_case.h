#pragma once

#include <taut/lumped/resonator_run.h>
#include <taut/lumped/resonator_si.h>
#include <taut/study/run.h>

#include <map>
#include <string>
#include <vector>

/// The lumped resonator of a case, from its description in SI units to rows
/// and events in SI units.
namespace taut::study
{
/// The resonator as the lumped layer takes it.
lumped::ResonatorSI make_resonator_si(const LumpedResonatorDescription& device);

/// Runs the lumped model of `device` from the start to the end of `procedure`,
/// with inertia if its analysis is a transient and relaxed at all times if it
/// is an equilibrium, to the first failure. Rows are at `output_times` (s,
/// increasing), the start and the end.
/// Errors: BadInput for impossible parameters, for the analysis `continuation`
/// and for a hold time without a voltage that rises, SolverFailed as
/// lumped::run_quasi_static.
lumped::ResonatorRun run_lumped(const LumpedResonatorDescription& device,
                                const ProcedureDescription& procedure,
                                const std::vector<double>& output_times);

/// The highest voltage to which the source can rise, at the rate it has at the
/// start of `procedure`, and then stay for the device's hold time without a
/// failure, "hold limit" (V), and the "natural frequency at hold limit" (Hz)
/// once everything has relaxed there.
/// Errors: BadInput for impossible parameters and a voltage that does not rise,
/// SolverFailed as lumped::find_hold_limit.
std::map<std::string, double>
find_hold_limit(const LumpedResonatorDescription& device,
                const ProcedureDescription& procedure);

/// A row of the lumped model in SI units.
struct LumpedRow
{
  double time = 0;             ///< (s)
  double voltage = 0;          ///< (V)
  double stretch_active = 0;   ///< lambda_1A
  double stretch_passive = 0;  ///< lambda_1B
  double bar_displacement = 0; ///< L_1A (lambda_1A - lambda_1p) (m)
  double bar_velocity = 0;     ///< (m/s)
  /// Nominal stresses, inertia left out: force over undeformed section (Pa).
  double nominal_stress_1_active = 0;
  double nominal_stress_1_passive = 0;
  double nominal_stress_2_active = 0;
  double nominal_stress_2_passive = 0;
  double charge = 0;            ///< of the electrode (C)
  double natural_frequency = 0; ///< with held internal stretches (Hz)
  double true_field = 0;        ///< in the active strip (V/m)
  double breakdown_margin = 0;  ///< strength less true field (V/m)
  double kinetic_energy = 0;    ///< (J)
  /// Stored less Q V / 2 (J).
  double free_energy = 0;
  double dissipated_energy = 0; ///< inertial runs only (J)
  double voltage_work = 0;      ///< integral of Q dV, inertial runs only (J)
};

LumpedRow make_lumped_row(const LumpedResonatorDescription& device,
                          const lumped::ResonatorRow& row);
/// The same with the scales of the device, for many rows.
LumpedRow make_lumped_row(const LumpedResonatorDescription& device,
                          const lumped::ResonatorScales& scales,
                          const lumped::ResonatorRow& row);

/// A number of a LumpedRow and how it is called.
struct LumpedColumn
{
  Column column;
  double LumpedRow::*value;
};

/// All of them in the order of history.csv.
const std::vector<LumpedColumn>& get_lumped_columns();

/// Kind (tension_loss or breakdown) and place (active, passive or both) are
/// those of a film; the name says which tension. The direction is that of x_1
/// or x_2, the point has no place (NaN).
EventRecord make_event_record(const LumpedResonatorDescription& device,
                              const lumped::ResonatorEvent& event);
} // namespace taut::study
