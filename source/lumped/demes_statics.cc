#include <taut/lumped/demes_statics.h>

#include <algorithm>
#include <cmath>

#include "demes_roots.h"
#include "demes_straight.h"

namespace taut::lumped
{
namespace
{
/// lambda_p s / K at which an arc buckles, from f''(0) = -1/3.
constexpr double arc_number = 3;

const double pi = std::acos(-1.);

/// Samples of the residual; equilibria that lie closer than a piece are found
/// all the same, see scan_roots.
constexpr int pieces = 1000;

/// The ends of the frame stay apart below this angle on the side of positive
/// or negative angles (`sign`); there the film resists without bound.
double get_limit(const Demes& demes, const double sign)
{
  const double hollow = sign * demes.eccentricity;
  const double limit = hollow > 1 / pi ? 1 / hollow : pi;
  return (1 - 1e-9) * limit;
}

double compute_residual(const Demes& demes, const double angle,
                        const double drive)
{
  const double stretch =
      demes.pre_stretch * compute_chord(angle, demes.eccentricity).value;
  return -compute_acceleration(demes, angle, stretch, drive);
}

/// Of a frame with a straight state, which is divided out.
std::vector<double> find_symmetric_angles(const Demes& demes,
                                          const double drive)
{
  const auto reduced = [&](const double angle)
  {
    return angle == 0 ? compute_frequencies(demes, 0, drive).relaxed_squared
                      : compute_residual(demes, angle, drive) / angle;
  };
  const auto bent = scan_roots(reduced, 0, get_limit(demes, 1), pieces);
  std::vector<double> angles;
  for (const double angle : bent)
    if (angle > 0)
      angles.insert(angles.end(), {-angle, angle});
  angles.push_back(0);
  std::sort(angles.begin(), angles.end());
  return angles;
}

std::vector<double> find_angles(const Demes& demes, const double drive)
{
  if (demes.eccentricity == 0 && demes.rest_angle == 0)
    return find_symmetric_angles(demes, drive);
  return scan_roots([&](const double angle)
                    { return compute_residual(demes, angle, drive); },
                    -get_limit(demes, -1), get_limit(demes, 1), 2 * pieces);
}

DemesEquilibrium make_equilibrium(const Demes& demes, const double angle,
                                  const double drive)
{
  DemesEquilibrium state;
  state.angle = angle;
  state.stretch =
      demes.pre_stretch * compute_chord(angle, demes.eccentricity).value;
  state.membrane_force =
      compute_membrane_force(demes, state.stretch, state.stretch, drive);
  state.energy = compute_free_energy(demes, angle, state.stretch, drive);
  state.frequencies = compute_frequencies(demes, angle, drive);
  state.stable = state.frequencies.relaxed_squared > 0;
  return state;
}
} // namespace

std::vector<DemesEquilibrium> find_equilibria(const Demes& demes,
                                              const double drive)
{
  validate(demes);
  std::vector<DemesEquilibrium> equilibria;
  for (const double angle : find_angles(demes, drive))
    equilibria.push_back(make_equilibrium(demes, angle, drive));
  return equilibria;
}

double compute_critical_pre_stretch(const Demes& demes)
{
  require_straight_state(demes);
  return compute_critical_pre_stretch(demes, arc_number);
}

double compute_flattening_drive(const Demes& demes)
{
  require_straight_state(demes);
  return compute_flattening_drive(demes, arc_number);
}

double compute_growth_rate(const Demes& demes, const double drive)
{
  require_straight_state(demes);
  return std::sqrt(
      std::max(0., -compute_frequencies(demes, 0, drive).relaxed_squared));
}
} // namespace taut::lumped
