#include "run_continuation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace taut::study
{
namespace
{
using Kind = time::CurvePoint::Kind;

/// Displacements of this part of the device's extent are worth a step.
constexpr double noticeable = 0.02;

/// `direction` on the free displacements, not on rotations and directors.
std::vector<double> spread(const structure::Structure& structure,
                           const std::array<double, 3>& direction)
{
  std::vector<bool> turns(structure.nodes().n_local, false);
  for (const auto& rotation : structure.nodes().rotations)
    turns[rotation.vector] = turns[rotation.scalar()] = true;
  for (const auto& bar : structure.nodes().bars)
    turns[bar.director] = true;
  std::vector<double> all;
  for (const unsigned int entry : structure.free_unknowns())
    all.push_back(turns[entry / 3] ? 0. : direction[entry % 3]);
  return all;
}

time::ContinuationOptions make_options(const Case& run_case,
                                       const structure::Structure& structure)
{
  const ContinuationDescription& description = run_case.procedure.continuation;
  time::ContinuationOptions options;
  options.newton.tolerance = run_case.procedure.newton_tolerance;
  options.steps = description.steps;
  options.largest_step = description.largest_step;
  options.noticeable_displacement =
      noticeable * structure::compute_extent(structure.mesh()) *
      std::sqrt(structure.n_free_global() / 3.);
  options.takes_stable_branch =
      description.branch == ContinuationDescription::Branch::stable;
  options.direction = spread(structure, description.direction);
  return options;
}

EventRecord make_record(const std::string& kind, const double parameter)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  EventRecord record;
  record.time = record.value = parameter;
  record.name = "path";
  record.kind = kind;
  record.point = record.direction = {{none, none, none}};
  record.threshold = none;
  return record;
}

/// The word for a point in events.csv; empty for those without an event.
std::string get_event_kind(const Kind kind)
{
  switch (kind)
  {
  case Kind::limit:
    return "limit_point";
  case Kind::bifurcation:
    return "bifurcation";
  case Kind::branch_switch:
    return "branch_switch";
  case Kind::landing:
    return "landing";
  default:
    return "";
  }
}

/// One run along a path and back.
class Continuation
{
public:
  Continuation(const Case& run_case, structure::StructureSystem& system,
               const double* internal, double* u,
               const std::vector<double>& parameters,
               const ContinuationObserver& observer)
      : case_(run_case), system_(system),
        problem_(system.structure(), system.history(),
                 run_case.procedure.start == structure::Start::relaxed
                     ? structure::Networks::relaxed
                     : structure::Networks::as_given,
                 internal),
        u_(u), options_(make_options(run_case, system.structure())),
        observer_(observer)
  {
    options_.parameters = parameters;
  }

  ContinuationReport run();

private:
  bool follow(std::vector<double> ends, bool backward);
  bool observe(const time::CurvePoint& point);
  bool observe_return(const time::CurvePoint& point);
  void add(const time::ContinuationStatistics& part);
  void note_end(time::CurveEnd end, double parameter);

  const Case& case_;
  structure::StructureSystem& system_;
  structure::Equilibrium problem_;
  double* u_;
  time::ContinuationOptions options_;
  const ContinuationObserver& observer_;
  ContinuationReport report_;
  /// Of the parts before this one.
  double length_ = 0, last_length_ = 0;
  bool jumps_ = false;
  /// The next point is the last one of the part before.
  bool is_told_ = false;
};

bool Continuation::observe(const time::CurvePoint& point)
{
  time::CurvePoint whole = point;
  whole.arc_length += length_;
  last_length_ = whole.arc_length;
  const bool goes_on = observer_.point(whole);
  const std::string kind = get_event_kind(point.kind);
  if (!kind.empty())
    observer_.event(make_record(kind, point.parameter));
  return goes_on;
}

bool Continuation::observe_return(const time::CurvePoint& point)
{
  // From where a stable part ends, a device jumps to the landing.
  if (point.kind == Kind::landing)
    jumps_ = false;
  else if (point.negative_eigenvalues.value_or(0) > 0)
    jumps_ = true;
  return jumps_ || observe(point);
}

void Continuation::add(const time::ContinuationStatistics& part)
{
  auto& counters = report_.counters;
  counters["points"] += part.points;
  counters["limit_points"] += part.limit_points;
  counters["bifurcations"] += part.bifurcations;
  counters["branch_switches"] += part.branch_switches;
  counters["rejected_steps"] += part.rejected_steps;
  counters["newton_iterations"] += part.newton.iterations;
  counters["factorisations"] += part.newton.factorisations;
  counters["evaluations"] += part.newton.residuals;
}

void Continuation::note_end(const time::CurveEnd end, const double parameter)
{
  std::string reason;
  switch (end)
  {
  case time::CurveEnd::left:
    reason = "it is as far on the other side of its start";
    break;
  case time::CurveEnd::closed:
    reason = "it has closed";
    break;
  case time::CurveEnd::most_points:
    reason = "it has Most points";
    break;
  default:
    return;
  }
  report_.notes.push_back("the path ends at the time " +
                          std::to_string(parameter) + ": " + reason);
}

/// Through all ends, each from the one before; false if the path stops before.
bool Continuation::follow(std::vector<double> ends, const bool backward)
{
  for (std::size_t i = 1; i < ends.size(); ++i)
  {
    if (!backward)
      system_.history().enter_interval(ends[i - 1]);
    const double done = report_.counters["points"];
    const double most = case_.procedure.continuation.most_points;
    options_.most_points = static_cast<unsigned int>(std::max(2., most - done));
    const auto statistics = time::continue_path(
        problem_, ends[i - 1], ends[i], u_, options_,
        [&](const time::CurvePoint& point)
        {
          if (std::exchange(is_told_, false))
            return true;
          return backward ? observe_return(point) : observe(point);
        });
    is_told_ = true;
    add(statistics);
    length_ = last_length_;
    note_end(statistics.end, statistics.parameter);
    if (statistics.end != time::CurveEnd::reached)
      return false;
  }
  return true;
}

ContinuationReport Continuation::run()
{
  const ProcedureDescription& procedure = case_.procedure;
  // A kink of a signal is a corner of the path.
  std::vector<double> ends{procedure.start_time};
  for (const double kink :
       system_.stop_times(procedure.start_time, procedure.end_time))
    ends.push_back(kink);
  ends.push_back(procedure.end_time);
  if (follow(ends, false) && procedure.continuation.backward)
  {
    // Without intervals: those of the history run forward.
    system_.history() = structure::LoadHistory(system_.structure().device());
    follow({ends.rbegin(), ends.rend()}, true);
  }
  return report_;
}
} // namespace

std::vector<Column> make_continuation_columns()
{
  return {{"arc length", "1"}, {"negative eigenvalues", "1"}};
}

std::vector<double> make_continuation_values(const time::CurvePoint& point)
{
  return {point.arc_length,
          point.negative_eigenvalues
              ? static_cast<double>(*point.negative_eigenvalues)
              : std::numeric_limits<double>::quiet_NaN()};
}

ContinuationReport follow_continuation(const Case& run_case,
                                       structure::StructureSystem& system,
                                       const double* internal, double* u,
                                       const std::vector<double>& parameters,
                                       const ContinuationObserver& observer)
{
  return Continuation(run_case, system, internal, u, parameters, observer)
      .run();
}
} // namespace taut::study
