#include <taut/fe/beam_element.h>
#include <taut/fe/vector3.h>

#include <cmath>
#include <stdexcept>

#include "beam_element_quaternions.h"
#include "beam_element_strain.h"

namespace taut::fe
{
namespace
{
using Axes = std::array<Vector3, 3>;

/// A place in the element, from 0 to 1, and its share of a rule.
struct RulePoint
{
  double place, share;
};

const double half_spread = 0.5 / std::sqrt(3.);

std::vector<RulePoint> make_strain_rule(const unsigned int n_nodes)
{
  if (n_nodes == 2)
    return {{0.5, 1.}};
  return {{0.5 - half_spread, 0.5}, {0.5 + half_spread, 0.5}};
}

/// Gauss points that integrate N_a N_b of straight elements exactly.
std::vector<RulePoint> make_mass_rule()
{
  const double spread = 0.5 * std::sqrt(0.6);
  return {{0.5 - spread, 5. / 18}, {0.5, 8. / 18}, {0.5 + spread, 5. / 18}};
}

/// The rule whose points are the nodes: of trapezoid or Simpson.
std::vector<RulePoint> make_nodal_rule(const unsigned int n_nodes)
{
  if (n_nodes == 2)
    return {{0., 0.5}, {1., 0.5}};
  return {{0., 1. / 6}, {1., 1. / 6}, {0.5, 4. / 6}};
}

/// N_a and their derivatives by the place; the third node is the middle.
struct Shapes
{
  std::array<double, 3> values, derivatives;
};

Shapes compute_shapes(const unsigned int n_nodes, const double s)
{
  if (n_nodes == 2)
    return {{1 - s, s, 0}, {-1, 1, 0}};
  return {{(1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s)},
          {4 * s - 3, 4 * s - 1, 4 - 8 * s}};
}

/// sum_a factors_a values_a of nodal values with `n` components.
template <std::size_t n>
std::array<double, n> interpolate(const unsigned int n_nodes,
                                  const std::array<double, 3>& factors,
                                  const double* values)
{
  std::array<double, n> sum{};
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (unsigned int i = 0; i < n; ++i)
      sum[i] += factors[a] * values[n * a + i];
  return sum;
}

double norm(const Vector3& v)
{
  return std::sqrt(dot(v, v));
}

Vector3 scale(const double factor, const Vector3& v)
{
  return {factor * v[0], factor * v[1], factor * v[2]};
}

/// Axis 1 along `tangent`, 3 along `normal` across it, 2 = 3 x 1.
Axes make_axes(const Vector3& tangent, const Vector3& normal)
{
  const Vector3 first = scale(1 / norm(tangent), tangent);
  const Vector3 second = cross(normal, first);
  // Below this sine the direction of axis 3 would be noise.
  constexpr double least_sine = 1e-6;
  if (!(norm(second) > least_sine * norm(normal)))
    throw std::invalid_argument("the beam runs along the normal of its "
                                "section");
  const Vector3 across = scale(1 / norm(second), second);
  return {first, across, cross(first, across)};
}

/// The power of a gradient for rates of (x', q, q').
double compute_rate(const BeamGradient& gradient, const BeamPointState& rate)
{
  double power = 0;
  for (unsigned int i = 0; i < 3; ++i)
    power += gradient[i] * rate.slope[i];
  for (unsigned int i = 0; i < 4; ++i)
    power += gradient[3 + i] * rate.q[i] + gradient[7 + i] * rate.twist[i];
  return power;
}

/// The combination that is strain i of Gamma + x_0' and kappa.
StrainCombination select_strain(const Axes& axes, const unsigned int i)
{
  const Vector3 zero{};
  return i < 3 ? StrainCombination{axes[i], zero}
               : StrainCombination{zero, axes[i - 3]};
}

/// The combination that is the strain power of resultants.
StrainCombination combine_strains(const Axes& axes,
                                  const BeamResultants& resultants)
{
  StrainCombination sum{};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int c = 0; c < 3; ++c)
    {
      sum.n[c] += resultants[i] * axes[i][c];
      sum.m[c] += resultants[3 + i] * axes[i][c];
    }
  return sum;
}

/// H += sum_i stiffness_i B_i (x) B_i with B_i the gradient of strain i.
void add_material_part(const Axes& axes, const BeamStiffness& stiffness,
                       const BeamPointState& state, BeamHessian& H)
{
  for (unsigned int i = 0; i < 6; ++i)
  {
    const BeamGradient B = compute_gradient(select_strain(axes, i), state);
    for (unsigned int j = 0; j < 11; ++j)
      for (unsigned int k = 0; k < 11; ++k)
        H[j][k] += stiffness[i] * B[j] * B[k];
  }
}

/// The numbers of (x', q, q') that a nodal unknown moves, and how much.
struct Influence
{
  unsigned int n = 0;
  std::array<unsigned int, 2> number;
  std::array<double, 2> factor;
};

/// weight times the change of H's rows, that is columns, with an unknown.
BeamGradient combine_rows(const BeamHessian& H, const Influence& influence,
                          const double weight)
{
  BeamGradient sum{};
  for (unsigned int k = 0; k < influence.n; ++k)
    for (unsigned int c = 0; c < 11; ++c)
      sum[c] += weight * influence.factor[k] * H[influence.number[k]][c];
  return sum;
}

std::vector<Influence> make_influences(const unsigned int n_nodes,
                                       const std::array<double, 3>& values,
                                       const std::array<double, 3>& derivatives)
{
  std::vector<Influence> influences;
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (unsigned int i = 0; i < 3; ++i)
      influences.push_back({1, {i, 0}, {derivatives[a], 0}});
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (unsigned int i = 0; i < 4; ++i)
      influences.push_back({2, {3 + i, 7 + i}, {values[a], derivatives[a]}});
  return influences;
}
} // namespace

BeamElement::BeamElement(const std::vector<std::array<double, 3>>& nodes,
                         const std::array<double, 3>& normal)
    : n_nodes_(nodes.size()), nodes_(nodes), normal_(normal)
{
  if (n_nodes_ != 2 && n_nodes_ != 3)
    throw std::invalid_argument("a beam has 2 or 3 nodes");
  for (const auto& [place, share] : make_strain_rule(n_nodes_))
  {
    const auto [values, derivatives] = compute_shapes(n_nodes_, place);
    const Vector3 tangent = compute_tangent(place);
    const double stretch = norm(tangent);
    Point point{values, derivatives, share * stretch,
                make_axes(tangent, normal_)};
    for (double& derivative : point.derivatives)
      derivative /= stretch;
    points_.push_back(point);
  }
  for (unsigned int node = 0; node < n_nodes_; ++node)
    compute_axes(node);
}

std::array<double, 3> BeamElement::compute_tangent(const double place) const
{
  const auto tangent = fe::interpolate<3>(
      n_nodes_, compute_shapes(n_nodes_, place).derivatives, nodes_[0].data());
  if (!(norm(tangent) > 0))
    throw std::invalid_argument("the beam has no length");
  return tangent;
}

BeamPointState BeamElement::interpolate(const Point& point,
                                        const std::vector<double>& nodal) const
{
  const double* q = &nodal[3 * n_nodes_];
  return {fe::interpolate<3>(n_nodes_, point.derivatives, nodal.data()),
          fe::interpolate<4>(n_nodes_, point.values, q),
          fe::interpolate<4>(n_nodes_, point.derivatives, q)};
}

double BeamElement::length() const
{
  double sum = 0;
  for (const Point& point : points_)
    sum += point.weight;
  return sum;
}

std::vector<BeamResultants>
BeamElement::compute_strains(const double* unknowns) const
{
  const auto unit = normalise(n_nodes_, unknowns);
  std::vector<BeamResultants> strains;
  for (const Point& point : points_)
  {
    const BeamPointState state = interpolate(point, unit);
    BeamResultants strain;
    for (unsigned int i = 0; i < 6; ++i)
      strain[i] = compute_value(select_strain(point.axes, i), state);
    // x_0' has unit length and runs along axis 1.
    strain[0] -= 1;
    strains.push_back(strain);
  }
  return strains;
}

std::vector<BeamResultants>
BeamElement::compute_strain_rates(const double* unknowns,
                                  const double* rates) const
{
  const auto unit = normalise(n_nodes_, unknowns);
  std::vector<double> unit_rates(rates, rates + n_unknowns());
  project(n_nodes_, unit, unknowns, unit_rates.data());
  std::vector<BeamResultants> strain_rates;
  for (const Point& point : points_)
  {
    const BeamPointState state = interpolate(point, unit);
    const BeamPointState rate = interpolate(point, unit_rates);
    BeamResultants strain_rate;
    for (unsigned int i = 0; i < 6; ++i)
      strain_rate[i] = compute_rate(
          compute_gradient(select_strain(point.axes, i), state), rate);
    strain_rates.push_back(strain_rate);
  }
  return strain_rates;
}

std::vector<double> BeamElement::compute_unit_forces(
    const std::vector<double>& unit,
    const std::vector<BeamResultants>& resultants) const
{
  std::vector<double> forces(n_unknowns(), 0.);
  for (unsigned int q = 0; q < points_.size(); ++q)
  {
    const Point& point = points_[q];
    const BeamGradient g = compute_gradient(
        combine_strains(point.axes, resultants[q]), interpolate(point, unit));
    const auto influences =
        make_influences(n_nodes_, point.values, point.derivatives);
    for (unsigned int i = 0; i < n_unknowns(); ++i)
      for (unsigned int k = 0; k < influences[i].n; ++k)
        forces[i] +=
            point.weight * influences[i].factor[k] * g[influences[i].number[k]];
  }
  return forces;
}

void BeamElement::add_forces(const double* unknowns,
                             const std::vector<BeamResultants>& resultants,
                             double* forces) const
{
  const auto unit = normalise(n_nodes_, unknowns);
  auto local = compute_unit_forces(unit, resultants);
  project(n_nodes_, unit, unknowns, local.data());
  for (unsigned int i = 0; i < n_unknowns(); ++i)
    forces[i] += local[i];
}

std::vector<double> BeamElement::compute_unit_stiffness(
    const std::vector<double>& unit, const BeamStiffness& stiffness,
    const std::vector<BeamResultants>& resultants) const
{
  const unsigned int n = n_unknowns();
  std::vector<double> matrix(n * n, 0.);
  for (unsigned int q = 0; q < points_.size(); ++q)
  {
    const Point& point = points_[q];
    const BeamPointState state = interpolate(point, unit);
    BeamHessian H =
        compute_hessian(combine_strains(point.axes, resultants[q]), state);
    add_material_part(point.axes, stiffness, state, H);
    const auto influences =
        make_influences(n_nodes_, point.values, point.derivatives);
    for (unsigned int j = 0; j < n; ++j)
    {
      const BeamGradient column = combine_rows(H, influences[j], point.weight);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int k = 0; k < influences[i].n; ++k)
          matrix[i * n + j] +=
              influences[i].factor[k] * column[influences[i].number[k]];
    }
  }
  return matrix;
}

void BeamElement::add_stiffness(const double* unknowns,
                                const BeamStiffness& stiffness,
                                const std::vector<BeamResultants>& resultants,
                                double* matrix) const
{
  const unsigned int n = n_unknowns();
  const auto unit = normalise(n_nodes_, unknowns);
  auto local = compute_unit_stiffness(unit, stiffness, resultants);
  for (unsigned int i = 0; i < n; ++i)
    project(n_nodes_, unit, unknowns, &local[i * n]);
  for (unsigned int j = 0; j < n; ++j)
    project(n_nodes_, unit, unknowns, &local[j], n);
  add_curvature(n_nodes_, unit, unknowns, compute_unit_forces(unit, resultants),
                local.data());
  for (unsigned int i = 0; i < n * n; ++i)
    matrix[i] += local[i];
}

double
BeamElement::compute_energy(const BeamStiffness& stiffness,
                            const std::vector<BeamResultants>& strains) const
{
  double energy = 0;
  for (unsigned int q = 0; q < points_.size(); ++q)
    for (unsigned int i = 0; i < 6; ++i)
      energy += 0.5 * points_[q].weight * stiffness[i] * strains[q][i] *
                strains[q][i];
  return energy;
}

void BeamElement::add_shape_products(double* matrix) const
{
  for (const auto& [place, share] : make_mass_rule())
  {
    const auto values = compute_shapes(n_nodes_, place).values;
    const double weight = share * norm(compute_tangent(place));
    for (unsigned int a = 0; a < n_nodes_; ++a)
      for (unsigned int b = 0; b < n_nodes_; ++b)
        matrix[a * n_nodes_ + b] += weight * values[a] * values[b];
  }
}

std::vector<double> BeamElement::compute_nodal_lengths() const
{
  std::vector<double> lengths;
  for (const auto& [place, share] : make_nodal_rule(n_nodes_))
    lengths.push_back(share * norm(compute_tangent(place)));
  return lengths;
}

std::array<std::array<double, 3>, 3>
BeamElement::compute_axes(const unsigned int node) const
{
  const double place = make_nodal_rule(n_nodes_)[node].place;
  return make_axes(compute_tangent(place), normal_);
}

std::vector<BeamResultants>
BeamElement::extrapolate(const std::vector<BeamResultants>& at_points) const
{
  if (n_nodes_ == 2)
    return {at_points[0], at_points[0]};
  std::vector<BeamResultants> at_nodes(n_nodes_);
  const auto nodal_rule = make_nodal_rule(n_nodes_);
  for (unsigned int node = 0; node < n_nodes_; ++node)
  {
    // From -1 at the first point to 1 at the second.
    const double way = (nodal_rule[node].place - 0.5) / half_spread;
    for (unsigned int i = 0; i < 6; ++i)
      at_nodes[node][i] =
          0.5 * ((1 - way) * at_points[0][i] + (1 + way) * at_points[1][i]);
  }
  return at_nodes;
}
} // namespace taut::fe
