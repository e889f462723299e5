#pragma once

#include <taut/study/run.h>

#include <functional>
#include <vector>

namespace taut::study
{
/// The equilibrium about which a device vibrates, and how.
struct ModeShapes
{
  double time; ///< (s)
  structure::StructureSystem& system;
  const double* state;
  /// By mode: displacements of all local nodes, 3 node + component, the largest
  /// the description's share of the device's extent (m).
  const std::vector<std::vector<double>>& motions;
};
using WriteModeShapes = std::function<void(const ModeShapes&)>;

/// Runs a film case to the state that its Modes section names, finds the
/// equilibrium next to it with the internal variables and the charges of
/// circuits held, and the modes about that. `write` gets the shapes, before the
/// run ends. The report is in the summary. Failures end in Status::failed as in
/// run_film: also where no equilibrium lies next to the state, or if an event
/// or an interruption ends the run before. Errors as run_film.
RunSummary run_film_modes(const Case& run_case, structure::Structure& structure,
                          RunOutput& output, const WriteModeShapes& write);

/// The same for a lumped model, which has one mode. A resonator vibrates about
/// its balance at the internal stretches of the state, a DEMES about the
/// relaxed equilibrium whose angle is next to that of the state. Errors as
/// run_resonator and run_demes; BadInput if the Modes section asks for what a
/// lumped model does not have.
RunSummary run_lumped_modes(const Case& run_case, RunOutput& output);
} // namespace taut::study
