#pragma once

#include <taut/structure/systems.h>
#include <taut/study/run.h>
#include <taut/time/continuation.h>

#include <functional>

namespace taut::study
{
/// What a continuation tells the run. All calls are collective.
struct ContinuationObserver
{
  /// A point that goes into the history; false ends the path.
  std::function<bool(const time::CurvePoint&)> point;
  std::function<void(const EventRecord&)> event;
};

struct ContinuationReport
{
  std::map<std::string, double> counters;
  std::vector<std::string> notes;
};

/// Columns that a continuation adds to the history.
std::vector<Column> make_continuation_columns();
/// Their values.
std::vector<double> make_continuation_values(const time::CurvePoint& point);

/// Follows the equilibria of a case from its start to its end time, and back if
/// it asks for it: then points that a device would jump over are not told.
/// `u`: displacements at the start, then at the end. `parameters`: where points
/// are wanted. Errors: as time::continue_path.
ContinuationReport follow_continuation(const Case& run_case,
                                       structure::StructureSystem& system,
                                       const double* internal, double* u,
                                       const std::vector<double>& parameters,
                                       const ContinuationObserver& observer);
} // namespace taut::study
