#include <taut/base/rotation.h>
#include <taut/fe/beam_element.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace taut::fe
{
namespace
{
TEST(BeamGeometry, AxesFollowTheNormal)
{
  const BeamElement element({{0, 0, 0}, {0, 2, 0}}, {0, 5, 1});
  const auto axes = element.compute_axes(1);
  const std::array<Vector3, 3> expected = {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int c = 0; c < 3; ++c)
      EXPECT_NEAR(axes[i][c], expected[i][c], 1e-15);
}

TEST(BeamGeometry, CurvedLengthsAreThoseOfTheArc)
{
  // A fifth of a radian of a unit circle: the parabola through three points of
  // the arc has another speed by half of angle^2, its length errs by angle^4.
  const double half = 0.1;
  const BeamElement element({{std::cos(half), -std::sin(half), 0},
                             {std::cos(half), std::sin(half), 0},
                             {1, 0, 0}},
                            {0, 0, 1});
  const double tolerance = 2 * half * std::pow(half, 4);
  EXPECT_NEAR(element.length(), 2 * half, tolerance);
  const auto lengths = element.compute_nodal_lengths();
  EXPECT_NEAR(lengths[0] + lengths[1] + lengths[2], 2 * half, tolerance);
  const double of_speed = 2 * half * 0.5 * half * half;
  EXPECT_NEAR(lengths[0], 2 * half / 6, of_speed);
  EXPECT_NEAR(lengths[1], 2 * half / 6, of_speed);
  EXPECT_NEAR(lengths[2], 2 * half * 4 / 6, of_speed);
  std::vector<double> products(9, 0.);
  element.add_shape_products(products.data());
  double sum = 0;
  for (const double product : products)
    sum += product;
  EXPECT_NEAR(sum, 2 * half, tolerance);
}

TEST(BeamGeometry, ShapeProductsOfStraightBeamsAreExact)
{
  // Of length 30: 30/30 times the integers of the quadratic shape functions.
  const BeamElement three({{0, 0, 0}, {30, 0, 0}, {15, 0, 0}}, {0, 0, 1});
  std::vector<double> products(9, 0.);
  three.add_shape_products(products.data());
  const std::vector<double> expected = {4, -1, 2, -1, 4, 2, 2, 2, 16};
  for (unsigned int i = 0; i < 9; ++i)
    EXPECT_NEAR(products[i], expected[i], 1e-13);
  const BeamElement two({{0, 0, 0}, {6, 0, 0}}, {0, 0, 1});
  std::vector<double> of_two(4, 0.);
  two.add_shape_products(of_two.data());
  EXPECT_NEAR(of_two[0], 2, 1e-14);
  EXPECT_NEAR(of_two[1], 1, 1e-14);
  EXPECT_NEAR(two.compute_nodal_lengths()[1], 3, 1e-14);
}

TEST(BeamGeometry, ExtrapolationReproducesLinearDistributions)
{
  const BeamElement element({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {0, 0, 1});
  const double spread = 1 / std::sqrt(3.);
  std::vector<BeamResultants> at_points(2);
  for (unsigned int i = 0; i < 6; ++i)
  {
    at_points[0][i] = i + 2. * (1 - spread);
    at_points[1][i] = i + 2. * (1 + spread);
  }
  const auto at_nodes = element.extrapolate(at_points);
  ASSERT_EQ(at_nodes.size(), 3u);
  for (unsigned int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(at_nodes[0][i], i, 1e-14);
    EXPECT_NEAR(at_nodes[1][i], i + 4., 1e-14);
    EXPECT_NEAR(at_nodes[2][i], i + 2., 1e-14);
  }
}

TEST(BeamGeometry, RefusesBeamsWithoutLengthOrAlongTheirNormal)
{
  EXPECT_THROW(BeamElement({{1, 2, 3}, {1, 2, 3}}, {0, 0, 1}),
               std::invalid_argument);
  EXPECT_THROW(BeamElement({{0, 0, 0}, {0, 0, 2}}, {0, 0, 1}),
               std::invalid_argument);
  EXPECT_THROW(BeamElement({{0, 0, 0}, {1, 0, 0}}, {0, 0, 0}),
               std::invalid_argument);
  EXPECT_THROW(BeamElement({{0, 0, 0}}, {0, 0, 1}), std::invalid_argument);
  // Upright at its first node only.
  EXPECT_THROW(BeamElement({{0, 0, 0}, {2, 0, 2}, {0.5, 0, 1.5}}, {0, 0, 1}),
               std::invalid_argument);
}
} // namespace
} // namespace taut::fe
