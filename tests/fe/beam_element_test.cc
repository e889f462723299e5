#include <taut/base/rotation.h>
#include <taut/fe/beam_element.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace taut::fe
{
namespace
{
const BeamStiffness stiffness = {90, 40, 30, 7, 5, 9};

struct NamedElement
{
  std::string name;
  BeamElement element;
  std::vector<Vector3> nodes;
};

NamedElement make_named(const std::string& name,
                        const std::vector<Vector3>& nodes)
{
  return {name, BeamElement(nodes, {0.1, 0.2, 1}), nodes};
}

/// Straight with two and three nodes, and a curved one with its middle node off
/// centre.
std::vector<NamedElement> make_elements()
{
  return {make_named("two nodes", {{0, 0, 0}, {1, 2, 0.5}}),
          make_named("three nodes", {{0, 0, 0}, {1, 2, 0.5}, {0.5, 1, 0.25}}),
          make_named("curved", {{0, 0, 0}, {1, 2, 0.5}, {0.8, 0.9, 0.2}})};
}

/// The reference state with quaternions of length `length`.
std::vector<double> make_reference(const NamedElement& beam,
                                   const double length = 1)
{
  std::vector<double> u(beam.element.n_unknowns(), 0.);
  for (unsigned int a = 0; a < beam.nodes.size(); ++a)
  {
    std::copy(beam.nodes[a].begin(), beam.nodes[a].end(), &u[3 * a]);
    u[3 * beam.nodes.size() + 4 * a] = length;
  }
  return u;
}

/// A bent, twisted, sheared and stretched state, far from the reference.
std::vector<double> make_deformed(const NamedElement& beam)
{
  std::vector<double> u = make_reference(beam);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  for (double& unknown : u)
    unknown += uniform(generator);
  return u;
}

/// x -> R(q) x + shift and Q -> factor (a + 1) q Q at node a: a rigid motion,
/// and other lengths of the quaternions.
std::vector<double> move(const NamedElement& beam, std::vector<double> u,
                         const Quaternion& q, const Vector3& shift,
                         const double factor)
{
  const std::size_t n = beam.nodes.size();
  for (std::size_t a = 0; a < n; ++a)
  {
    const Vector3 x = rotate(q, {u[3 * a], u[3 * a + 1], u[3 * a + 2]});
    double* Q = &u[3 * n + 4 * a];
    const Quaternion turned = multiply(q, {Q[0], Q[1], Q[2], Q[3]});
    for (unsigned int i = 0; i < 3; ++i)
      u[3 * a + i] = x[i] + shift[i];
    for (unsigned int i = 0; i < 4; ++i)
      Q[i] = factor * (a + 1) * turned[i];
  }
  return u;
}

std::vector<BeamResultants> compute_resultants(const BeamElement& element,
                                               const double* u)
{
  auto resultants = element.compute_strains(u);
  for (auto& at_point : resultants)
    for (unsigned int i = 0; i < 6; ++i)
      at_point[i] *= stiffness[i];
  return resultants;
}

double compute_energy(const BeamElement& element, const std::vector<double>& u)
{
  return element.compute_energy(stiffness, element.compute_strains(u.data()));
}

std::vector<double> compute_forces(const BeamElement& element,
                                   const std::vector<double>& u)
{
  std::vector<double> forces(u.size(), 0.);
  element.add_forces(u.data(), compute_resultants(element, u.data()),
                     forces.data());
  return forces;
}

std::vector<double>
compute_stiffness(const BeamElement& element, const std::vector<double>& u,
                  const std::vector<BeamResultants>& resultants)
{
  std::vector<double> matrix(u.size() * u.size(), 0.);
  element.add_stiffness(u.data(), stiffness, resultants, matrix.data());
  return matrix;
}

void expect_near(const std::vector<BeamResultants>& a,
                 const std::vector<BeamResultants>& b, const double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (unsigned int q = 0; q < a.size(); ++q)
    for (unsigned int i = 0; i < 6; ++i)
      EXPECT_NEAR(a[q][i], b[q][i], tolerance)
          << "point " << q << ", component " << i;
}

// Central differences of functions of order one to a hundred: the third
// derivative times step^2 and rounding over the step.
constexpr double step = 1e-5;
constexpr double of_differences = 1e-6;

TEST(BeamElement, ReferenceStateHasNoStrain)
{
  for (const auto& beam : make_elements())
  {
    SCOPED_TRACE(beam.name);
    const std::vector<BeamResultants> none(beam.element.n_points());
    expect_near(beam.element.compute_strains(make_reference(beam, 3).data()),
                none, 1e-15);
  }
}

TEST(BeamElement, StrainsAreObjectiveAndFreeOfTheLengthOfQ)
{
  const Quaternion q = make_rotation({2, -1, 5});
  for (const auto& beam : make_elements())
  {
    SCOPED_TRACE(beam.name);
    const auto u = make_deformed(beam);
    const auto moved = move(beam, u, q, {1, -2, 0.5}, 0.3);
    expect_near(beam.element.compute_strains(moved.data()),
                beam.element.compute_strains(u.data()), 1e-14);
  }
}

TEST(BeamElement, ForcesAreTheGradientOfTheEnergy)
{
  for (const auto& beam : make_elements())
  {
    SCOPED_TRACE(beam.name);
    const auto u = make_deformed(beam);
    const auto forces = compute_forces(beam.element, u);
    for (std::size_t i = 0; i < u.size(); ++i)
    {
      auto plus = u, minus = u;
      plus[i] += step;
      minus[i] -= step;
      EXPECT_NEAR((compute_energy(beam.element, plus) -
                   compute_energy(beam.element, minus)) /
                      (2 * step),
                  forces[i], of_differences)
          << "unknown " << i;
    }
  }
}

TEST(BeamElement, ForcesDoNotPullAtTheLengthOfQ)
{
  for (const auto& beam : make_elements())
  {
    SCOPED_TRACE(beam.name);
    const auto u = make_deformed(beam);
    const auto forces = compute_forces(beam.element, u);
    const std::size_t n = beam.nodes.size();
    for (std::size_t a = 0; a < n; ++a)
    {
      double power = 0;
      for (std::size_t i = 3 * n + 4 * a; i < 3 * n + 4 * (a + 1); ++i)
        power += forces[i] * u[i];
      EXPECT_NEAR(power, 0, 1e-13) << "node " << a;
    }
  }
}

TEST(BeamElement, StiffnessIsTheDerivativeOfTheForces)
{
  for (const auto& beam : make_elements())
  {
    SCOPED_TRACE(beam.name);
    const auto u = make_deformed(beam);
    const auto K = compute_stiffness(
        beam.element, u, compute_resultants(beam.element, u.data()));
    for (std::size_t j = 0; j < u.size(); ++j)
    {
      auto plus = u, minus = u;
      plus[j] += step;
      minus[j] -= step;
      const auto f_plus = compute_forces(beam.element, plus);
      const auto f_minus = compute_forces(beam.element, minus);
      for (std::size_t i = 0; i < u.size(); ++i)
        EXPECT_NEAR((f_plus[i] - f_minus[i]) / (2 * step), K[i * u.size() + j],
                    of_differences)
            << "row " << i << ", column " << j;
    }
  }
}

TEST(BeamElement, GeometricStiffnessTakesAnyResultants)
{
  // The derivative of B^T resultants at fixed resultants, and symmetric.
  for (const auto& beam : make_elements())
  {
    SCOPED_TRACE(beam.name);
    const auto u = make_deformed(beam);
    const std::vector<BeamResultants> given(beam.element.n_points(),
                                            {3, -2, 5, 1, -4, 2});
    const std::vector<BeamResultants> none(beam.element.n_points());
    const auto with = compute_stiffness(beam.element, u, given);
    const auto without = compute_stiffness(beam.element, u, none);
    const std::size_t n = u.size();
    for (std::size_t j = 0; j < n; ++j)
    {
      auto plus = u, minus = u;
      plus[j] += step;
      minus[j] -= step;
      std::vector<double> f_plus(n, 0.), f_minus(n, 0.);
      beam.element.add_forces(plus.data(), given, f_plus.data());
      beam.element.add_forces(minus.data(), given, f_minus.data());
      for (std::size_t i = 0; i < n; ++i)
      {
        EXPECT_NEAR((f_plus[i] - f_minus[i]) / (2 * step),
                    with[i * n + j] - without[i * n + j], of_differences);
        EXPECT_NEAR(with[i * n + j], with[j * n + i], 1e-12);
      }
    }
  }
}

TEST(BeamElement, RatesOfTheStrainsAreTheirDerivatives)
{
  for (const auto& beam : make_elements())
  {
    SCOPED_TRACE(beam.name);
    const auto u = make_deformed(beam);
    auto plus = u, minus = u, rates = u;
    for (std::size_t i = 0; i < u.size(); ++i)
    {
      rates[i] = std::sin(1. + i);
      plus[i] += step * rates[i];
      minus[i] -= step * rates[i];
    }
    auto differences = beam.element.compute_strains(plus.data());
    const auto before = beam.element.compute_strains(minus.data());
    for (unsigned int q = 0; q < before.size(); ++q)
      for (unsigned int i = 0; i < 6; ++i)
        differences[q][i] = (differences[q][i] - before[q][i]) / (2 * step);
    expect_near(beam.element.compute_strain_rates(u.data(), rates.data()),
                differences, of_differences);
  }
}

TEST(BeamElement, UniformStretchAndShearAreExact)
{
  // Axes 1, 2, 3 = x, y, z; the sections do not turn.
  const NamedElement beam = {
      "along x",
      BeamElement({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {0, 0, 1}),
      {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}};
  auto u = make_reference(beam);
  for (unsigned int a = 0; a < 3; ++a)
  {
    const double s = beam.nodes[a][0];
    u[3 * a] += 0.1 * s;
    u[3 * a + 1] += 0.2 * s;
    u[3 * a + 2] -= 0.3 * s;
  }
  expect_near(beam.element.compute_strains(u.data()),
              {{0.1, 0.2, -0.3, 0, 0, 0}, {0.1, 0.2, -0.3, 0, 0, 0}}, 1e-15);
}

/// Largest error of the strains in an element of a beam along `axes[0]`, length
/// `length`, bent and twisted by uniform kappa with its axis as the sections
/// demand.
double compute_strain_error(const unsigned int n_nodes, const double length,
                            const Vector3& kappa)
{
  const double size = std::sqrt(kappa[0] * kappa[0] + kappa[1] * kappa[1] +
                                kappa[2] * kappa[2]);
  std::vector<Vector3> nodes = {{0, 0, 0}, {length, 0, 0}};
  if (n_nodes == 3)
    nodes.push_back({0.5 * length, 0, 0});
  const BeamElement element(nodes, {0, 0, 1});
  std::vector<double> u(element.n_unknowns());
  for (unsigned int a = 0; a < n_nodes; ++a)
  {
    // R(s) = exp(s kappa x) and x(s) = integral of R(s) e_1, a helix.
    const double s = nodes[a][0], angle = size * s;
    const Vector3 e = {kappa[0] / size, kappa[1] / size, kappa[2] / size};
    const double along = s * e[0], bent = std::sin(angle) / size,
                 side = (1 - std::cos(angle)) / size;
    const Vector3 x = {along * e[0] + bent * (1 - e[0] * e[0]),
                       along * e[1] - bent * e[0] * e[1] + side * e[2],
                       along * e[2] - bent * e[0] * e[2] - side * e[1]};
    std::copy(x.begin(), x.end(), &u[3 * a]);
    const Quaternion q =
        make_rotation({s * kappa[0], s * kappa[1], s * kappa[2]});
    std::copy(q.begin(), q.end(), &u[3 * n_nodes + 4 * a]);
  }
  double error = 0;
  for (const auto& strain : element.compute_strains(u.data()))
    for (unsigned int i = 0; i < 3; ++i)
      error = std::max(
          {error, std::abs(strain[i]), std::abs(strain[3 + i] - kappa[i])});
  return error;
}

TEST(BeamElement, UniformBendingAndTwistConvergeAsTheElementShrinks)
{
  for (const Vector3& kappa :
       {Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, -1, 0.7}})
    for (const unsigned int n_nodes : {2u, 3u})
    {
      const double coarse = compute_strain_error(n_nodes, 0.4, kappa);
      const double fine = compute_strain_error(n_nodes, 0.2, kappa);
      // The points of Gauss are better than the quadratic shape functions.
      EXPECT_NEAR(std::log2(coarse / fine), n_nodes == 2 ? 2 : 4, 0.1);
    }
}
} // namespace
} // namespace taut::fe
