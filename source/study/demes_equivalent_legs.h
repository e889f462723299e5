#pragma once

#include <taut/fe/mesh_data.h>
#include <taut/study/case.h>

#include "resonator_equivalent_strip.h"

namespace taut::study
{
struct LegMeasures
{
  /// EI of all legs together (N m^2), at their temperatures.
  double bending_stiffness = 0;
  /// h, between their axes and the film (m).
  double offset = 0;
};

/// Measures the legs of a lumped DEMES beside its film.
/// Errors: BadInput if they are not straight from end to end of the film, or
/// not all at the same distance from its plane, or bend in another plane.
LegMeasures measure_legs(const Case& film_case, const FilmStrip& strip,
                         const fe::MeshData& mesh);
} // namespace taut::study
