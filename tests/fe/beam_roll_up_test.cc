#include <gtest/gtest.h>

#include <cmath>

#include "beam_chain.h"

namespace taut::fe
{
namespace
{
const double pi = std::acos(-1.);

double norm(const Vector3& v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// Distance of the tip from the clamp, relative to the length, under the moment
/// that bends the beam into `turns` circles: an error of the discretisation.
double compute_gap(const unsigned int n_elements,
                   const unsigned int nodes_per_element,
                   const unsigned int turns, const BeamStiffness& stiffness)
{
  const double length = 10;
  BeamChain chain(n_elements, nodes_per_element, length, stiffness);
  const unsigned int steps = 4 * turns;
  for (unsigned int i = 1; i <= steps; ++i)
    chain.solve(
        {0, 0, 0},
        {0, -double(i) / steps * turns * 2 * pi * stiffness[4] / length, 0});
  return norm(chain.get_position(chain.n_nodes() - 1)) / length;
}

// E A = 1e4, G A = 5e3, E I = 100.
const BeamStiffness thick = {1e4, 5e3, 5e3, 100, 100, 100};

/// Of a rectangle of thickness 1e-3 lengths with the same bending stiffness.
BeamStiffness make_thin()
{
  const double axial = 100 * 12 / 1e-4;
  return {axial, axial / 3, axial / 3, 100, 100, 100};
}

TEST(BeamRollUp, ClosesOneAndTwoCirclesWithFourthOrder)
{
  for (const unsigned int turns : {1u, 2u})
  {
    const double coarse = compute_gap(8 * turns, 3, turns, thick);
    const double fine = compute_gap(16 * turns, 3, turns, thick);
    EXPECT_NEAR(std::log2(coarse / fine), 4, 0.1);
    EXPECT_LT(fine, 1e-4);
  }
}

TEST(BeamRollUp, TwoNodesClosesTheCircleWithSecondOrder)
{
  const double coarse = compute_gap(16, 2, 1, thick);
  const double fine = compute_gap(32, 2, 1, thick);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
}

TEST(BeamRollUp, ThinBeamsDoNotLock)
{
  for (const unsigned int nodes : {2u, 3u})
  {
    const double of_thin = compute_gap(16, nodes, 1, make_thin());
    const double of_thick = compute_gap(16, nodes, 1, thick);
    EXPECT_LT(of_thin, 1.1 * of_thick);
  }
}

TEST(BeamRollUp, TurnsOfTheTipAreTheMoment)
{
  BeamChain chain(8, 3, 1, {1e6, 1e6, 1e6, 1, 1, 1});
  chain.solve({0, 0, 0}, {0, 0, 1.5});
  EXPECT_NEAR(compute_angle(chain.get_rotation(chain.n_nodes() - 1), {0, 0, 1}),
              1.5, 1e-6);
}

TEST(BeamRollUp, DeadTransverseLoadGivesTheElastica)
{
  // w/L, u/L of an inextensible, unshearable cantilever at P L^2/(E I) = 5,
  // from elliptic integrals. The beam stretches and shears by about
  // (t/L)^2 = 1e-6.
  BeamChain chain(16, 3, 10, make_thin());
  for (const double load : {1., 2., 3., 4., 5.})
    chain.solve({0, 0, load}, {0, 0, 0});
  const Vector3 tip = chain.get_position(chain.n_nodes() - 1);
  EXPECT_NEAR(tip[2] / 10, .7137915236, 2e-6);
  EXPECT_NEAR(1 - tip[0] / 10, .3876283607, 2e-6);
}
} // namespace
} // namespace taut::fe
