#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/lumped/demes_elastica.h>

#include <cmath>
#include <cstdint>

#include "demes_elastica_clamped.h"
#include "demes_roots.h"
#include "demes_straight.h"
#include <boost/math/differentiation/finite_difference.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_d.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace taut::lumped
{
namespace
{
const double pi = std::acos(-1.);
/// lambda_p s / K at which an elastica buckles: p = pi^2.
const double elastica_number = pi * pi / 4;
/// Samples of the modulus in which equilibria are looked for.
constexpr int pieces = 400;

/// The amplitude of u whose sine and cosine are given.
double compute_amplitude(const double sine, const double cosine, const double u,
                         const double modulus)
{
  const double turned = pi / 2 * u / boost::math::ellint_1(modulus);
  const double amplitude = std::atan2(sine, cosine);
  return amplitude + 2 * pi * std::round((turned - amplitude) / (2 * pi));
}

/// sin(phi / 2) = k sn(sqrt(p) s, k): the tangent swings back.
void swing(ElasticaShape& shape)
{
  const double u = std::sqrt(shape.load) / 2;
  const double signed_modulus = shape.mid_curvature / (4 * u);
  const double k = std::abs(signed_modulus);
  double cn, dn;
  const double sn = boost::math::jacobi_elliptic(k, u, &cn, &dn);
  const double amplitude = compute_amplitude(sn, cn, u, k);
  shape.end_angle = 2 * std::asin(signed_modulus * sn);
  shape.end_curvature = shape.mid_curvature * cn;
  shape.frame_chord = 1 - 2 / u * k * k * boost::math::ellint_d(k, amplitude);
  shape.sag = signed_modulus / u * (cn > 0 ? sn * sn / (1 + cn) : 1 - cn);
}

/// phi / 2 = am(w, 1 / k): the tangent would turn over.
void turn(ElasticaShape& shape)
{
  const double sign = shape.mid_curvature > 0 ? 1 : -1;
  const double w = std::abs(shape.mid_curvature) / 4;
  const double modulus = std::sqrt(shape.load) / (2 * w);
  double cn, dn;
  const double sn = boost::math::jacobi_elliptic(modulus, w, &cn, &dn);
  const double amplitude = compute_amplitude(sn, cn, w, modulus);
  shape.end_angle = sign * 2 * amplitude;
  shape.end_curvature = shape.mid_curvature * dn;
  shape.frame_chord = 1 - 2 / w * boost::math::ellint_d(modulus, amplitude);
  shape.sag = sign * sn * sn / (w * (1 + dn));
}

/// The film pushes: with kappa the curvature in the middle,
/// r^2 = kappa^2 - 4 p, W = r / 4 and the modulus 2 sqrt(-p) / r,
/// sin(phi / 2) = (kappa / r) sn / dn and cos(phi / 2) = cn / dn.
void push(ElasticaShape& shape)
{
  const double kappa = shape.mid_curvature;
  const double r = std::sqrt(kappa * kappa - 4 * shape.load);
  const double w = r / 4;
  const double modulus = 2 * std::sqrt(-shape.load) / r;
  double cn, dn;
  const double sn = boost::math::jacobi_elliptic(modulus, w, &cn, &dn);
  const double amplitude = compute_amplitude(sn, cn, w, modulus);
  shape.end_angle = 2 * std::atan2(kappa / r * sn, cn);
  shape.end_curvature = kappa / dn;
  shape.frame_chord =
      1 -
      2 / w * (w - boost::math::ellint_d(modulus, amplitude) - sn * cn / dn);
  shape.sag = 4 * kappa / (r * r) * sn * sn / (dn * (1 + dn));
}

/// u = sqrt(p) / 2 of the frame of modulus k whose end carries the moment of
/// the stand-off: k cn = u h (1 - 2 k^2 sn^2).
double find_half_root_of_load(const double k, const double standoff)
{
  const double quarter = boost::math::ellint_1(k);
  if (standoff == 0)
    return quarter;
  const auto excess = [&](const double u)
  {
    double cn, dn;
    const double sn = boost::math::jacobi_elliptic(k, u, &cn, &dn);
    return k * cn - u * standoff * (1 - 2 * k * k * sn * sn);
  };
  // The stand-off bends further while the end turns by less than pi / 2.
  const bool below = 2 * k * k < 1;
  std::uintmax_t iterations = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      excess, below ? 0 : quarter, (below ? 1 : 2) * quarter,
      boost::math::tools::eps_tolerance<double>(), iterations);
  return (low + high) / 2;
}

ElasticaShape make_shape(const double k, const double standoff)
{
  const double u = find_half_root_of_load(k, standoff);
  return compute_elastica(4 * k * u, 4 * u * u);
}

/// Derivatives of a shape by the logarithm of its curvature in the middle or
/// of its load.
struct ShapeSlope
{
  double end_angle;
  double end_curvature;
  double load;
  double chord;
};

template <typename Change>
ShapeSlope differentiate(const double standoff, const Change& change)
{
  const auto slope = [&](const auto& value)
  {
    const auto of_factor = [&](const double x) { return value(change(x)); };
    return boost::math::differentiation::finite_difference_derivative<
        decltype(of_factor), double, 8>(of_factor, 1.);
  };
  using Shape = const ElasticaShape&;
  return {slope([](Shape shape) { return shape.end_angle; }),
          slope([](Shape shape) { return shape.end_curvature; }),
          slope([](Shape shape) { return shape.load; }),
          slope(
              [&](Shape shape) {
                return shape.frame_chord -
                       2 * standoff * std::sin(shape.end_angle);
              })};
}

/// Derivative of the moment by the end angle along shapes that a film of the
/// given ds / dlambda bends.
double differentiate_moment(const DemesElastica& elastica,
                            const ElasticaShape& shape,
                            const double film_stiffness)
{
  const double curvature = shape.mid_curvature, load = shape.load;
  const double standoff = elastica.standoff;
  const double stiffness = elastica.demes.frame_stiffness;
  const double pre_stretch = elastica.demes.pre_stretch;
  const auto a =
      differentiate(standoff, [&](const double x)
                    { return compute_elastica(curvature * x, load); });
  const auto b =
      differentiate(standoff, [&](const double x)
                    { return compute_elastica(curvature, load * x); });
  // Both change together so that the load stays the film's.
  const double load_per_chord =
      4 * pre_stretch * pre_stretch / stiffness * film_stiffness;
  const double miss_a = a.load - load_per_chord * a.chord;
  const double miss_b = b.load - load_per_chord * b.chord;
  const double turn = a.end_angle * miss_b - b.end_angle * miss_a;
  const double bend = a.end_curvature * miss_b - b.end_curvature * miss_a;
  const double pull = a.load * miss_b - b.load * miss_a;
  return stiffness / 2 *
         ((bend - standoff * std::cos(shape.end_angle) * pull) / turn +
          load * standoff * std::sin(shape.end_angle));
}

ElasticaEquilibrium make_equilibrium(const DemesElastica& elastica,
                                     const ElasticaShape& shape,
                                     const double drive)
{
  const ClampedElastica clamped(elastica);
  ElasticaEquilibrium state;
  state.shape = shape;
  state.chord = clamped.compute_chord(shape);
  state.stretch = clamped.compute_stretch(shape);
  state.membrane_force = compute_membrane_force(elastica.demes, state.stretch,
                                                state.stretch, drive);
  return state;
}

/// Small rotations phi = theta sin(sqrt(p) s) / sin(sqrt(p) / 2) leave the
/// chord as it is.
ElasticaEquilibrium make_straight(const DemesElastica& elastica,
                                  const double load, const double drive)
{
  auto state = make_equilibrium(elastica, compute_elastica(0, load), drive);
  const double root = std::sqrt(std::abs(load));
  const double tangent = load < 0 ? std::tanh(root / 2) : std::tan(root / 2);
  const double end_curvature = root == 0 ? 2 : root / tangent;
  const double squared = elastica.demes.frame_stiffness / 2 * end_curvature;
  state.frequencies = {squared, squared};
  state.stable = load < pi * pi;
  return state;
}

ElasticaEquilibrium make_bent(const DemesElastica& elastica, const double k,
                              const double drive)
{
  const ElasticaShape shape = make_shape(k, elastica.standoff);
  auto state = make_equilibrium(elastica, shape, drive);
  const Demes& demes = elastica.demes;
  const double square = state.stretch * state.stretch;
  const double relaxed =
      demes.modulus_factor * (1 + 3 / (square * square)) +
      compute_electric(demes, state.stretch, drive).stiffness;
  const double held =
      relaxed + demes.modulus_factor * 4 * demes.viscous_ratio / square;
  state.frequencies = {differentiate_moment(elastica, shape, relaxed),
                       differentiate_moment(elastica, shape, held)};
  state.stable = state.frequencies.relaxed_squared > 0;
  return state;
}

void require_no_standoff(const DemesElastica& elastica)
{
  validate(elastica);
  if (elastica.standoff != 0)
    throw BadInput("a straight state needs a frame without stand-offs, got " +
                   number_text(elastica.standoff));
}
} // namespace

void validate(const DemesElastica& elastica)
{
  require_straight_state(elastica.demes);
  if (!(elastica.standoff >= 0) || !std::isfinite(elastica.standoff))
    throw BadInput("the height of the stand-offs must not be negative, got " +
                   number_text(elastica.standoff));
}

ElasticaShape compute_elastica(const double mid_curvature, const double load)
{
  ElasticaShape shape;
  shape.mid_curvature = mid_curvature;
  shape.load = load;
  if (mid_curvature == 0)
    return shape;
  if (load < 0)
    push(shape);
  else if (mid_curvature * mid_curvature < 4 * load)
    swing(shape);
  else
    turn(shape);
  return shape;
}

std::vector<ElasticaEquilibrium> find_equilibria(const DemesElastica& elastica,
                                                 const double drive)
{
  validate(elastica);
  const ClampedElastica clamped(elastica);
  const Demes& demes = elastica.demes;
  const double straight_load =
      clamped.compute_load(demes.pre_stretch, 0, drive);
  // Times lambda^3, so that nothing happens where the ends meet.
  const auto imbalance = [&](const double k)
  {
    const ElasticaShape shape = make_shape(k, elastica.standoff);
    const double stretch = clamped.compute_stretch(shape);
    const double force = compute_membrane_force(demes, stretch, stretch, drive);
    return stretch * stretch * stretch *
           (4 * demes.pre_stretch / demes.frame_stiffness * force - shape.load);
  };
  std::vector<ElasticaEquilibrium> equilibria;
  if (elastica.standoff == 0)
    equilibria.push_back(make_straight(elastica, straight_load, drive));
  // From a modulus without bending to that of a frame bent into a loop.
  for (const double k : scan_roots(imbalance, 1e-6, 0.99, pieces))
    if (clamped.compute_stretch(make_shape(k, elastica.standoff)) > 0)
      equilibria.push_back(make_bent(elastica, k, drive));
  return equilibria;
}

double compute_critical_pre_stretch(const DemesElastica& elastica)
{
  require_no_standoff(elastica);
  return compute_critical_pre_stretch(elastica.demes, elastica_number);
}

double compute_flattening_drive(const DemesElastica& elastica)
{
  require_no_standoff(elastica);
  return compute_flattening_drive(elastica.demes, elastica_number);
}
} // namespace taut::lumped
