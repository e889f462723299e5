#include "demes_elastica_clamped.h"

#include <taut/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace taut::lumped
{
namespace
{
const double pi = std::acos(-1.);
/// Newton's iterations; they converge within five from a near shape.
constexpr int most_iterations = 40;
/// Step of the difference quotients of the Jacobian, which steers the iteration
/// but has no part in its result.
constexpr double difference = 1e-6;
} // namespace

double ClampedElastica::compute_moment(const ElasticaShape& shape) const
{
  return elastica_.demes.frame_stiffness / 2 *
         (shape.end_curvature -
          shape.load * elastica_.standoff * std::cos(shape.end_angle));
}

double ClampedElastica::compute_chord(const ElasticaShape& shape) const
{
  return shape.frame_chord - 2 * elastica_.standoff * std::sin(shape.end_angle);
}

double ClampedElastica::compute_stretch(const ElasticaShape& shape) const
{
  return elastica_.demes.pre_stretch * compute_chord(shape);
}

double ClampedElastica::compute_load(const double stretch,
                                     const double inner_stretch,
                                     const double drive) const
{
  const Demes& demes = elastica_.demes;
  if (!(stretch > 0))
    throw StepRejected("the ends of the frame meet");
  const double inner = inner_stretch == 0 ? stretch : inner_stretch;
  return 4 * demes.pre_stretch / demes.frame_stiffness *
         compute_membrane_force(demes, stretch, inner, drive);
}

void ClampedElastica::start(const double end_angle, const double inner_stretch,
                            const double drive)
{
  const double load =
      compute_load(elastica_.demes.pre_stretch, inner_stretch, drive);
  if (load >= 4 * pi * pi)
    throw StepRejected("the film's pull p = P C^2 / (E I) reaches 4 pi^2, so "
                       "that clamped ends do not hold the frame straight");
  shape_ = compute_elastica(0, load);
  const int pieces = 1 + int(std::abs(end_angle) / 0.05);
  for (int i = 1; i <= pieces; ++i)
    solve(end_angle * i / pieces, inner_stretch, drive);
}

/// Newton's method for the curvature in the middle and the load.
const ElasticaShape& ClampedElastica::solve(const double end_angle,
                                            const double inner_stretch,
                                            const double drive)
{
  const auto compute_residual = [&](const ElasticaShape& shape)
  {
    const double load =
        compute_load(compute_stretch(shape), inner_stretch, drive);
    return std::array<double, 2>{shape.end_angle - end_angle,
                                 shape.load - load};
  };
  double last_size = std::numeric_limits<double>::infinity();
  ElasticaShape shape = shape_;
  for (int iteration = 0; iteration < most_iterations; ++iteration)
  {
    const double curvature = shape.mid_curvature, load = shape.load;
    const auto f = compute_residual(shape);
    const auto a =
        compute_residual(compute_elastica(curvature + difference, load));
    const auto b =
        compute_residual(compute_elastica(curvature, load + difference));
    const double da0 = (a[0] - f[0]) / difference;
    const double da1 = (a[1] - f[1]) / difference;
    const double db0 = (b[0] - f[0]) / difference;
    const double db1 = (b[1] - f[1]) / difference;
    const double determinant = da0 * db1 - da1 * db0;
    const double step_0 = (f[1] * db0 - f[0] * db1) / determinant;
    const double step_1 = (f[0] * da1 - f[1] * da0) / determinant;
    const double size = std::abs(step_0) + std::abs(step_1);
    // Once the steps are down to round-off they stop shrinking.
    if (size < 1e-9 && size >= 0.1 * last_size)
      return shape_ = shape;
    if (!std::isfinite(size))
      break;
    last_size = size;
    shape = compute_elastica(curvature + step_0, load + step_1);
  }
  throw StepRejected("there is no elastica of this end rotation in equilibrium "
                     "with the film");
}
} // namespace taut::lumped
