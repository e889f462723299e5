#pragma once

#include <taut/structure/systems.h>
#include <taut/study/case.h>
#include <taut/study/modes_report.h>
#include <taut/study/motion.h>
#include <taut/time/integrate.h>

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace taut::study
{
/// A row of events.csv.
struct EventRecord
{
  double time = 0;  ///< (s)
  std::string name; ///< of the event in the case, or "path"
  /// tension_loss, wrinkling, slackness, breakdown, pull_in, snap_through,
  /// self_contact, probe_above or probe_below; of a continuation limit_point,
  /// bifurcation, branch_switch or landing, without a threshold.
  std::string kind;
  /// Films, frames or probe; on a tie all of them, separated by " + ".
  std::string place;
  /// Where in the mesh (m); NaN if the event has no point.
  std::array<double, 3> point{};
  /// Direction across which tension is lost, a unit vector in space; NaN for
  /// other events.
  std::array<double, 3> direction{};
  double value = 0; ///< of the quantity, in its own unit
  double threshold = 0;
  /// Dimensionless, 0 at the event; see structure::Watches. NaN if it has none.
  double margin = 0;
  bool at_start = false;
  bool fatal = false;
};

enum class Status
{
  completed,
  event,       ///< stopped by an event that the case declares fatal
  interrupted, ///< asked to stop; a checkpoint allows to go on
  failed
};

/// A file of its own beside history.csv.
struct Table
{
  std::vector<Column> columns;
  std::vector<std::vector<double>> rows;
};

/// What run.json tells; all times in seconds.
struct RunSummary
{
  Status status = Status::completed;
  std::string reason;
  double time_reached = 0;
  std::vector<Column> columns;
  std::vector<double> final_row;
  std::map<std::string, double> counters;
  /// Numbers that no row has, by name.
  std::map<std::string, double> findings;
  /// What the user should know and no number says.
  std::vector<std::string> notes;
  /// The row of history.csv for the rest shape on the other side, if it was
  /// asked for.
  std::vector<double> other_branch;
  std::map<std::string, double> timings;
  /// Largest absolute (J) and relative residual of the balance of energy.
  double balance_absolute = 0;
  double balance_relative = 0;
  /// Of `taut modes`.
  std::optional<ModesReport> modes;
  /// If the case asks for it and the run reached it.
  std::optional<Motion> motion;
  /// By the name of the file without its ending.
  std::map<std::string, Table> tables;
};

/// What of a run must survive besides the state, so that it can go on.
struct RunProgress
{
  double time = 0;
  long steps = 0;
  std::size_t history_rows = 0;
  std::size_t field_frames = 0;
  std::size_t event_rows = 0;
  /// Which events may happen (again), in the order of the case; empty = all.
  std::vector<bool> armed_events;
  /// Total energy at the start, which the balance is measured against (J).
  double initial_energy = 0;
  double balance_absolute = 0;
  double balance_scale = 0;
};

/// A state to go on from.
struct Checkpoint
{
  RunProgress progress;
  std::vector<double> state;
};

/// Where a run writes. Implemented by the io layer; every call is collective.
class RunOutput
{
public:
  virtual ~RunOutput() = default;
  virtual void begin(const std::vector<Column>& columns) = 0;
  virtual void write_row(const std::vector<double>& row) = 0;
  virtual void write_event(const EventRecord& event) = 0;
  virtual void write_fields(double time, structure::StructureSystem& system,
                            const double* state) = 0;
  virtual void write_checkpoint(const RunProgress& progress,
                                structure::StructureSystem& system,
                                const double* state) = 0;
  /// After every accepted step; cheap.
  virtual void report_step(const time::Step& step,
                           const time::IntegratorStatistics& statistics,
                           double balance_relative) = 0;
  /// True if a checkpoint is due by wall time; asked after every step.
  virtual bool wants_checkpoint() = 0;
  /// True if the run should stop in good order (SIGTERM, SIGINT).
  virtual bool interrupted() = 0;
  /// The rows that a resumed run wrote before it was cut.
  virtual std::vector<std::vector<double>> get_earlier_rows()
  {
    return {};
  }
};

/// Something else that is done with a state of a run.
struct StateVisit
{
  /// At the start, where the run then ends; else at its end, unless an event,
  /// an interruption or a failure ends it before.
  bool at_start = false;
  /// May move the state. Errors: those of a run.
  std::function<void(double time, structure::StructureSystem& system,
                     std::vector<double>& state, RunSummary& summary)>
      visit;
};

/// Runs the film case on a structure: equilibrium path, quasi-static or
/// transient as the procedure says. Solver failures end in
/// Status::failed with the reason; they do not throw.
/// Errors: BadInput for probes and events that do not fit the device.
RunSummary run_film(const Case& run_case, structure::Structure& structure,
                    RunOutput& output,
                    const std::optional<Checkpoint>& resume = std::nullopt,
                    const std::optional<StateVisit>& visit = std::nullopt);
} // namespace taut::study
