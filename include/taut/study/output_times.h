#pragma once

#include <taut/study/case.h>

#include <vector>

namespace taut::study
{
/// Start and end of a run, the ends of its equal intervals and the extra times
/// between them, increasing (s).
std::vector<double> make_output_times(const ProcedureDescription& procedure,
                                      unsigned int intervals,
                                      const std::vector<double>& extra);

/// The times of the rows of a case's history: also the multiples of the period
/// of its motion, so that a stroboscopic section is made of rows. An equal
/// interval that ends within a billionth of a period of one gives way to it.
std::vector<double> make_history_times(const Case& run_case);
} // namespace taut::study
