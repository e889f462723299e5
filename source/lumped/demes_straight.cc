#include "demes_straight.h"

#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>

#include <cmath>

namespace taut::lumped
{
void require_straight_state(const Demes& demes)
{
  validate(demes);
  if (demes.eccentricity != 0 || demes.rest_angle != 0)
    throw BadInput("a straight state needs a frame with eccentricity 0 and "
                   "rest angle 0, got " +
                   number_text(demes.eccentricity) + " and " +
                   number_text(demes.rest_angle));
}

/// m (lambda_p^2 - lambda_p^-2) = number K.
double compute_critical_pre_stretch(const Demes& demes, const double number)
{
  const double load = number * demes.frame_stiffness / demes.modulus_factor;
  return std::sqrt((load + std::sqrt(load * load + 4)) / 2);
}

double compute_flattening_drive(const Demes& demes, const double number)
{
  const double stretch = demes.pre_stretch;
  const double excess = compute_membrane_force(demes, stretch, stretch, 0) -
                        number * demes.frame_stiffness / stretch;
  const double relief = -compute_electric(demes, stretch, 1).force;
  return excess > 0 ? std::sqrt(excess / relief) : 0;
}
} // namespace taut::lumped
