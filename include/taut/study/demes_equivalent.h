#pragma once

#include <taut/fe/mesh_data.h>
#include <taut/lumped/demes_elastica.h>
#include <taut/lumped/demes_si.h>
#include <taut/study/case.h>

#include <string>
#include <vector>

namespace taut::study
{
/// A film case read as a lumped DEMES.
struct DemesEquivalent
{
  /// At the temperatures of the case, without laws. The frame's section stands
  /// for EI alone: 12 m x 1 m have the second moment 1 m^4.
  lumped::DemesSI device;
  /// EI of all legs (N m^2) and C, the length of each (m).
  double bending_stiffness = 0;
  double leg_length = 0;
  /// What the film case has and the lumped models ignore, in words.
  std::vector<std::string> ignored;

  /// A frame that bends into an arc; the stand-off is its eccentricity 2 h / C.
  lumped::Demes make_arc() const;
  /// The same device as an elastica.
  lumped::DemesElastica make_elastica() const;
};

/// What the case file alone tells of the refusals of make_demes_equivalent,
/// before there is a mesh. Errors: BadInput likewise.
void check_comparable_demes(const Case& film_case);

/// Reads the parts that Case::demes_comparison names: chord and width of the
/// film from the mesh, divided by the pre-stretch; mu of its springs, beta and
/// eta = G T of its network; EI as the sum over the legs, C as the length of
/// each and h between their axes and the film; I as the sum over both bodies of
/// their inertia about the direction across the film.
/// Errors: BadInput, with file and line of the entry, that names what the
/// lumped models cannot represent: another analysis than a transient from a
/// relaxed equilibrium, other films, electrodes, bodies, bars, hinges, loads or
/// frames that may bend, a pre-stretch across, springs that are not
/// neo-Hookean, more than one network, temperatures that change, legs that are
/// not straight from end to end of the film, probes of other quantities.
DemesEquivalent make_demes_equivalent(const Case& film_case,
                                      const fe::MeshData& mesh);
} // namespace taut::study
