#pragma once

#include <taut/structure/watches.h>
#include <taut/study/run.h>

namespace taut::study
{
/// The row of events.csv for an event of a film case.
EventRecord make_event_record(const structure::EventDescription& description,
                              const time::Event& event,
                              const structure::EventReport& report);
} // namespace taut::study
