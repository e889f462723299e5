#pragma once

#include <taut/io/cell_address.h>
#include <taut/io/parameters.h>
#include <taut/structure/systems.h>
#include <taut/study/run.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <boost/serialization/map.hpp>

/// A checkpoint is the file DIR/checkpoint/state: a line with the number of its
/// format, the size and the CRC-32 of the rest, and that rest as a binary
/// archive of Boost for the kind of machine that wrote it. It knows nothing of
/// ranks and can be resumed on any number of them.
namespace taut::io
{
/// The part of a state that belongs to a cell.
struct CellState
{
  CellAddress address;
  /// Displacements (m) and velocities (m/s) of its nodes, [a][3]; zero where
  /// they are no unknowns. No velocities in runs without inertia.
  std::vector<double> displacements, velocities;
  std::vector<double> internal; ///< [q][m][3]

  template <typename Archive>
  void serialize(Archive& archive, const unsigned int)
  {
    archive& address& displacements& velocities& internal;
  }
};

/// Text by path, of what must not change when a run is resumed.
using CriticalParameters = std::map<std::string, std::string>;

/// What a checkpoint holds.
struct StoredRun
{
  study::RunProgress progress;
  CriticalParameters parameters;
  std::uint32_t mesh_checksum = 0;
  std::vector<CellState> cells; ///< in the order of their addresses
  /// Of the nodes of bars, frames and rigid bodies, like CellState's.
  std::vector<double> extra_displacements, extra_velocities;
  std::vector<double> scalars; ///< behind the globals

  template <typename Archive>
  void serialize(Archive& archive, const unsigned int)
  {
    archive& progress.time& progress.steps& progress.history_rows;
    archive& progress.field_frames& progress.event_rows;
    archive& progress.armed_events;
    archive& progress.initial_energy& progress.balance_absolute;
    archive& progress.balance_scale;
    archive& parameters& mesh_checksum& cells;
    archive& extra_displacements& extra_velocities& scalars;
  }
};

/// All values that are not the default, but for those that only say when to
/// stop, what to write and how exactly to compute. The mesh counts by its
/// content, not by the name of its file.
CriticalParameters get_critical_parameters(const CaseFile& case_file);

/// Collective; the result is that of the first rank.
StoredRun collect_run(const CriticalParameters& parameters,
                      const study::RunProgress& progress,
                      structure::StructureSystem& system, const double* state);

/// Writes aside and renames, so that there is always a whole checkpoint.
/// Errors: std::runtime_error if it cannot be written.
void write_checkpoint(const std::string& folder, const StoredRun& run);

/// Errors: BadInput if there is none, it is cut off or damaged, or of another
/// format.
StoredRun read_checkpoint(const std::string& folder);

/// Errors: BadInput that names a parameter that has another value than when
/// `run` was stored.
void check_parameters(const StoredRun& run, const CaseFile& case_file);

/// Refines the coarse `mesh` in `triangulation` as it was. Collective. Errors:
/// BadInput if the mesh has changed.
void restore_refinement(const StoredRun& run, const fe::MeshData& mesh,
                        fe::Triangulation& triangulation);

/// This rank's part of the state. Errors: BadInput if it does not fit the
/// structure.
study::Checkpoint restore_state(const StoredRun& run,
                                const structure::Structure& structure);
} // namespace taut::io
