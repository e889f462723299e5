#pragma once

#include <taut/lumped/demes.h>

/// The straight state of a frame that buckles when the film's force exceeds
/// lambda_p s = number K: 3 for the arc, pi^2 / 4 for the elastica.
namespace taut::lumped
{
/// Errors: BadInput unless the frame is straight and without eccentricity.
void require_straight_state(const Demes& demes);

/// Without drive.
double compute_critical_pre_stretch(const Demes& demes, double number);

/// 0 if the straight state is stable without drive.
double compute_flattening_drive(const Demes& demes, double number);
} // namespace taut::lumped
