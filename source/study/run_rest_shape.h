#pragma once

#include <taut/study/film_rows.h>

namespace taut::study
{
/// A start from a rest shape and what the run reports of it.
struct RestStart
{
  std::vector<double> state;
  std::map<std::string, double> counters;
  std::vector<std::string> notes;
  /// Row of the history for the shape on the other side; empty if not asked.
  std::vector<double> other_branch;
};

/// Errors: SolverFailed if the path does not reach a stable shape.
RestStart start_from_rest_shape(const Case& run_case,
                                structure::StructureSystem& system,
                                FilmRows& rows);
} // namespace taut::study
