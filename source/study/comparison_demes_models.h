#pragma once

#include <taut/study/comparison_demes.h>

#include <map>
#include <vector>

namespace taut::study
{
/// By time (s).
using DemesShapes = std::map<double, DemesShape>;

/// The run of a lumped model from its rest, with rows at the times (s); fills
/// in the model's name, rest and driven state, events and notes. Errors as
/// compare_demes_models.
DemesShapes run_arc(const ProcedureDescription& procedure,
                    const std::vector<double>& times,
                    DemesComparison& comparison);
DemesShapes run_elastica(const ProcedureDescription& procedure,
                         const std::vector<double>& times,
                         DemesComparison& comparison);
} // namespace taut::study
