#pragma once

#include <taut/io/parameters.h>
#include <taut/study/run.h>

#include <cstdint>
#include <string>
#include <vector>

namespace taut::io
{
/// completed, event, interrupted or failed.
std::string to_text(study::Status status);

/// Of the whole program.
struct Machine
{
  unsigned int n_ranks = 1;
  /// Largest resident memory, summed over the ranks (bytes).
  std::uint64_t peak_memory = 0;
};
/// Collective.
Machine measure_machine(MPI_Comm communicator);

/// The text of run.json: status, reason, time_reached (s), final (value by
/// column of history.csv), counters, timings (s), energy_balance (absolute in J
/// and relative), modes (of `taut modes`: time of the state, stable, lowest
/// squares of angular frequencies and number of negative ones with relaxed and
/// frozen networks, and lists by mode), motion (its class with the numbers
/// behind it), peak_memory_bytes, ranks, versions, parameters_changed (default
/// and value by path). A number that is none is null.
std::string make_run_json(const study::RunSummary& summary,
                          const Machine& machine,
                          const std::vector<ChangedParameter>& changed);
} // namespace taut::io
