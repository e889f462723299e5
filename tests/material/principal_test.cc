#include <taut/material/principal.h>

#include "states.h"

namespace
{
using namespace taut::material;

TEST(Principal, StretchesAndTheirDirections)
{
  const Principal stretches =
      compute_principal_stretches(make_turned(2., 1.5, .4));
  EXPECT_NEAR(stretches.values[0], 2., 1e-14);
  EXPECT_NEAR(stretches.values[1], 1.5, 1e-14);
  EXPECT_NEAR(std::abs(stretches.directions[0][0]), std::cos(.4), 1e-14);
  EXPECT_NEAR(stretches.directions[0][1] / stretches.directions[0][0],
              std::tan(.4), 1e-14);
  EXPECT_NEAR(stretches.directions[1][0] / stretches.directions[1][1],
              -std::tan(.4), 1e-14);
}

TEST(Principal, EqualStretchesHaveOrthogonalDirections)
{
  const Principal stretches = compute_principal_stretches({4., 4., 0.});
  EXPECT_EQ(stretches.values[0], 2.);
  EXPECT_EQ(stretches.values[1], 2.);
  EXPECT_EQ(std::abs(stretches.directions[0][0]), 1.);
  EXPECT_EQ(std::abs(stretches.directions[1][1]), 1.);
}

// The Cauchy stress F S F^T of a gradient with rotation and shear must map the
// deformed directions to multiples of themselves.
TEST(Principal, StressesAreTheEigenvaluesOfTheCauchyStress)
{
  const double F[2][2] = {{1.4, .7}, {-.3, 1.9}};
  const Tensor C = {F[0][0] * F[0][0] + F[1][0] * F[1][0],
                    F[0][1] * F[0][1] + F[1][1] * F[1][1],
                    F[0][0] * F[0][1] + F[1][0] * F[1][1]};
  const Tensor S = {3., -1., .8};
  double cauchy[2][2] = {};
  const double second[2][2] = {{S.xx, S.xy}, {S.xy, S.yy}};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l)
          cauchy[i][j] += F[i][k] * second[k][l] * F[j][l];
  const Principal stresses = compute_principal_stresses(C, S);
  EXPECT_GT(stresses.values[0], stresses.values[1]);
  for (unsigned int n = 0; n < 2; ++n)
  {
    const std::array<double, 2>& v = stresses.directions[n];
    EXPECT_NEAR(std::hypot(v[0], v[1]), 1., 1e-14);
    const double x = F[0][0] * v[0] + F[0][1] * v[1];
    const double y = F[1][0] * v[0] + F[1][1] * v[1];
    EXPECT_NEAR(cauchy[0][0] * x + cauchy[0][1] * y, stresses.values[n] * x,
                1e-13);
    EXPECT_NEAR(cauchy[1][0] * x + cauchy[1][1] * y, stresses.values[n] * y,
                1e-13);
  }
}

// Uniaxial: nominal stress times stretch along, nothing across.
TEST(Principal, UniaxialNeoHookeanTrueStress)
{
  const Elastomer elastomer = {{NeoHookean{1e4}}, {}, {}, 0.};
  const double l = 1.7;
  const Tensor C = make_turned(l, 1. / std::sqrt(l), .3);
  const Principal stresses =
      compute_principal_stresses(C, stress(elastomer, C, nullptr, {0., 299.}));
  EXPECT_NEAR(stresses.values[0], 1e4 * (l * l - 1. / l), 1e-10);
  EXPECT_NEAR(stresses.values[1], 0., 1e-10);
  EXPECT_NEAR(stresses.directions[0][1] / stresses.directions[0][0],
              std::tan(.3), 1e-13);
}

TEST(Principal, TrueFieldAndBreakdownMargin)
{
  const Tensor C = make_turned(2., 1.5, .4);
  EXPECT_NEAR(compute_true_field(C, -1e7), 3e7, 1e-7);
  const Exposure exposure{1e7, 0., 1e-4, 299., 0.};
  EXPECT_NEAR(
      compute_breakdown_margin({ConstantPermittivity{4.}, {4e7}}, C, exposure),
      .25, 1e-14);
  EXPECT_EQ(compute_breakdown_margin({ConstantPermittivity{4.}}, C, exposure),
            1.);
}
} // namespace
