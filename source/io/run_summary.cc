#include <taut/io/run_summary.h>
#include <taut/io/versions.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

namespace taut::io
{
namespace
{
using Json = nlohmann::ordered_json;

/// A row of the history by the names of its columns.
Json make_row(const std::vector<study::Column>& columns,
              const std::vector<double>& row)
{
  Json values = Json::object();
  for (std::size_t i = 0; i < row.size(); ++i)
    values[columns[i].name] = row[i];
  return values;
}

/// The mode that moves most of the mass along x, y and z: where modes cross
/// their numbers tell little. Empty for lumped models, which have no
/// directions.
Json make_largest_modes(const study::ModesReport& report)
{
  Json largest = Json::object();
  for (std::size_t d = 0; d < 3; ++d)
  {
    double mass = 0;
    for (std::size_t i = 0; i < report.modes.size(); ++i)
    {
      const auto& mode = report.modes[i];
      if (mode.effective_masses.size() != 3 || mode.effective_masses[d] <= mass)
        continue;
      mass = mode.effective_masses[d];
      largest[std::string(1, "xyz"[d])] = {{"mode", i + 1},
                                           {"frequency", mode.frequency()},
                                           {"square", mode.square},
                                           {"effective_mass", mass}};
    }
  }
  return largest;
}

Json make_modes(const study::ModesReport& report)
{
  Json modes;
  modes["time"] = report.time;
  modes["stable"] = report.stable;
  modes["lowest_relaxed"] = report.lowest_relaxed;
  modes["lowest_frozen"] = report.lowest_frozen;
  modes["unstable_relaxed"] = report.unstable_relaxed;
  modes["unstable_frozen"] = report.unstable_frozen;
  for (const char* list : {"frequencies", "squares", "damping_ratios"})
    modes[list] = Json::array();
  for (const auto& mode : report.modes)
  {
    modes["frequencies"].push_back(mode.frequency());
    modes["squares"].push_back(mode.square);
    modes["damping_ratios"].push_back(mode.damping_ratio);
  }
  modes["largest_along"] = make_largest_modes(report);
  modes["relaxation_times"] = Json::object();
  for (const auto& relaxation : report.relaxations)
    modes["relaxation_times"][relaxation.name] = relaxation.time;
  modes["mass"] = report.total_mass;
  modes["moved"] = report.moved;
  return modes;
}

Json make_changes(const std::vector<ChangedParameter>& changed)
{
  Json changes = Json::object();
  for (const ChangedParameter& parameter : changed)
    changes[parameter.path] = {{"default", parameter.default_value},
                               {"value", parameter.value}};
  return changes;
}
Json make_motion(const study::Motion& motion)
{
  const study::MotionVerdict& verdict = motion.verdict;
  Json json;
  json["of"] = motion.of;
  json["velocity"] = motion.velocity;
  json["from"] = motion.from;
  json["class"] = study::to_text(verdict.motion_class);
  json["reason"] = verdict.reason;
  json["period_number"] = verdict.period_number;
  json["period"] = verdict.period;
  json["section_points"] = motion.section.size();
  json["section_spread"] = verdict.spread;
  json["drift_per_period"] = verdict.drift;
  json["irregularity"] = verdict.irregularity;
  json["dominant_frequency"] = motion.highest_line.frequency;
  json["dominant_amplitude"] = motion.highest_line.amplitude;
  if (motion.lyapunov)
  {
    json["lyapunov_exponent"] = motion.lyapunov->value;
    json["lyapunov_uncertainty"] = motion.lyapunov->uncertainty;
  }
  if (motion.reproducible)
  {
    json["reproducible"] = *motion.reproducible;
    json["reproducible_until"] = motion.reproducible_until;
  }
  return json;
}
} // namespace

std::string to_text(const study::Status status)
{
  switch (status)
  {
  case study::Status::completed:
    return "completed";
  case study::Status::event:
    return "event";
  case study::Status::interrupted:
    return "interrupted";
  default:
    return "failed";
  }
}

Machine measure_machine(const MPI_Comm communicator)
{
  dealii::Utilities::System::MemoryStats memory;
  dealii::Utilities::System::get_memory_stats(memory);
  const std::uint64_t kilobyte = 1024;
  return {dealii::Utilities::MPI::n_mpi_processes(communicator),
          dealii::Utilities::MPI::sum(kilobyte * memory.VmHWM, communicator)};
}

std::string make_run_json(const study::RunSummary& summary,
                          const Machine& machine,
                          const std::vector<ChangedParameter>& changed)
{
  Json run;
  run["status"] = to_text(summary.status);
  run["reason"] = summary.reason;
  run["time_reached"] = summary.time_reached;
  run["final"] = make_row(summary.columns, summary.final_row);
  if (!summary.other_branch.empty())
    run["other_branch"] = make_row(summary.columns, summary.other_branch);
  if (summary.modes)
    run["modes"] = make_modes(*summary.modes);
  if (!summary.findings.empty())
    run["findings"] = summary.findings;
  run["notes"] = summary.notes;
  run["counters"] = summary.counters;
  run["timings"] = summary.timings;
  run["energy_balance"] = {{"absolute", summary.balance_absolute},
                           {"relative", summary.balance_relative}};
  if (summary.motion)
    run["motion"] = make_motion(*summary.motion);
  run["peak_memory_bytes"] = machine.peak_memory;
  run["ranks"] = machine.n_ranks;
  run["versions"] = get_versions();
  run["parameters_changed"] = make_changes(changed);
  const int indent = 2;
  return run.dump(indent) + "\n";
}
} // namespace taut::io
