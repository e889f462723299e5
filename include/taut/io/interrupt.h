#pragma once

namespace taut::io
{
/// From now on the first SIGINT or SIGTERM only asks the run to stop; the
/// second one ends the process at once.
void catch_interrupts();

/// Whether this process was asked to stop.
bool was_interrupted();
} // namespace taut::io
