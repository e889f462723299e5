#pragma once

#include <taut/fe/mesh_data.h>
#include <taut/study/case.h>

#include <optional>
#include <string>
#include <vector>

namespace taut::study
{
/// A film case read as a lumped resonator.
struct ResonatorEquivalent
{
  LumpedResonatorDescription resonator;
  /// Component (0, 1, 2) of the mesh along which the bar moves, and +1 if the
  /// active film lies on its lower side, else -1.
  unsigned int component = 0;
  double sign = 1;
  /// Name of the support that holds the far end of the active film and of no
  /// other line: its reaction along the motion is the film's force. Empty if
  /// there is none.
  std::string end_support;
  /// What the film case has and the lumped model ignores, in words.
  std::vector<std::string> ignored;
};

/// What the case file alone tells of the refusals of make_resonator_equivalent,
/// before there is a mesh. Errors: BadInput likewise.
void check_comparable(const Case& film_case);

/// Measures the films of the case's Comparison on the mesh (extents along and
/// across the motion, divided by the pre-stretch) and reads material,
/// electrode and bar.
/// Errors: BadInput, with file and line of the entry, that names what the
/// lumped model cannot represent: an analysis without time, films other than
/// two flat rectangles side by side with one material, thickness and
/// pre-stretch, springs other than Gent springs of one limit, a permittivity
/// that is not constant, electrodes other than one on the active film alone,
/// bars other than one along the common edge that can move across it,
/// pressures, edge loads, gravity, moving supports.
ResonatorEquivalent make_resonator_equivalent(const Case& film_case,
                                              const fe::MeshData& mesh);
} // namespace taut::study
