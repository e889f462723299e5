#pragma once

#include <taut/study/comparison.h>

namespace taut::study
{
/// An event of the film in shared words; its direction is compared with the
/// axes of the strips.
ComparedEvent make_film_event(const EventRecord& record, const Case& film_case);

/// An event of the lumped model in shared words.
ComparedEvent make_lumped_event(const EventRecord& record, double voltage);

FailureDifference compare_failures(const ComparedEvent& film,
                                   const ComparedEvent& lumped);
} // namespace taut::study
