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
} // namespace taut::study
