#pragma once

#include <taut/lumped/demes_run.h>
#include <taut/lumped/demes_si.h>
#include <taut/study/run.h>

#include <string>
#include <vector>

/// The lumped DEMES of a case, from its description in SI units to rows and
/// events in SI units.
namespace taut::study
{
/// The DEMES as the lumped layer takes it. Errors: BadInput for unknown
/// temperature laws or another number of permittivity coefficients than 0 or 3.
lumped::DemesSI make_demes_si(const LumpedDemesDescription& device);

/// Runs the lumped model of `device` from the start to the end of `procedure`;
/// with the analysis `equilibrium` it rests at all times, at its temperature.
/// Rows are at `output_times` (s, increasing), the start and the end.
/// Errors: BadInput for impossible parameters and for another analysis than
/// these two, SolverFailed as lumped::run_demes.
lumped::DemesRun run_lumped(const LumpedDemesDescription& device,
                            const ProcedureDescription& procedure,
                            const std::vector<double>& output_times);

/// A row of the lumped model in SI units.
struct LumpedDemesRow
{
  double time = 0;             ///< (s)
  double voltage = 0;          ///< (V)
  double charge = 0;           ///< of an electrode (C)
  double angle = 0;            ///< theta, half of the arc's (rad)
  double angular_velocity = 0; ///< (rad/s)
  double chord = 0;            ///< length of the film (m)
  double stretch = 0;          ///< lambda
  double inner_stretch = 0;    ///< xi, of the dashpot
  double film_force = 0;       ///< negative: the film pushes (N)
  double kinetic_energy = 0;   ///< (J)
  /// Frame, film and electric energy, Legendre-transformed under voltage (J).
  double free_energy = 0;
  double dissipated_energy = 0; ///< (J)
  double source_work = 0;       ///< integral of Q dV, or of -V dQ (J)
};

LumpedDemesRow make_lumped_row(const LumpedDemesDescription& device,
                               const lumped::DemesRow& row);
/// The same with the scales of the device, for many rows.
LumpedDemesRow make_lumped_row(const LumpedDemesDescription& device,
                               const lumped::DemesScales& scales,
                               const lumped::DemesRow& row);
/// The state with which the runs of `device` start, dimensionless.
lumped::DemesState make_start(const LumpedDemesDescription& device);

/// A number of a LumpedDemesRow and how it is called.
struct LumpedDemesColumn
{
  Column column;
  double LumpedDemesRow::*value;
};

/// All of them in the order of history.csv.
const std::vector<LumpedDemesColumn>& get_lumped_demes_columns();

/// The film's force falls below zero: kind tension_loss, no point or direction.
EventRecord make_event_record(const LumpedDemesDescription& device,
                              const lumped::DemesEvent& event);
} // namespace taut::study
