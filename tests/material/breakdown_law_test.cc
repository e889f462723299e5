#include <taut/base/exceptions.h>
#include <taut/material/principal.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace taut;
using namespace taut::material;

namespace
{
/// lambda = 3, h = 50 um, 310 K, 1e6 V/(m s).
const BreakdownState state{9., 50e-6, 310., 1e6, .6};

double compute(const StrengthFactor& factor, const BreakdownState& at = state)
{
  return compute_strength({4e7, {factor}}, at);
}

/// What a law out of its range says.
std::string get_refusal(const StrengthFactor& factor, const BreakdownState& at)
{
  try
  {
    compute(factor, at);
  }
  catch (const StepRejected& refusal)
  {
    return refusal.what();
  }
  return "accepted";
}

TEST(BreakdownLaw, ConstantStrengthKnowsNoState)
{
  EXPECT_EQ(compute_strength({4e7}, state), 4e7);
  EXPECT_EQ(compute_strength({4e7}, {-1., -1., -1., -1., -1.}), 4e7);
}

TEST(BreakdownLaw, FactorsAreThoseOfTheirFormulas)
{
  EXPECT_DOUBLE_EQ(compute(StretchStrength{.63, {1., 6.}}),
                   4e7 * std::pow(3., .63));
  EXPECT_DOUBLE_EQ(compute(ThicknessStrength{1e-3, .25, {1e-6, 1e-3}}),
                   4e7 * std::pow(20., .25));
  EXPECT_DOUBLE_EQ(
      compute(TemperatureStrength{PolynomialLaw{300., {-.01}, 273., 373.}}),
      4e7 * .9);
  EXPECT_DOUBLE_EQ(
      compute(TemperatureStrength{ArrheniusLaw{300., 5e3}}),
      4e7 * std::exp(5e3 / 8.31446261815324 * (1 / 310. - 1 / 300.)));
  EXPECT_DOUBLE_EQ(compute(HumidityStrength{ExponentialLaw{.2, -.5}}),
                   4e7 * std::exp(-.2));
  EXPECT_DOUBLE_EQ(compute(RateStrength{1e4, .1, {1., 1e9}}),
                   4e7 * std::pow(100., .1));
}

TEST(BreakdownLaw, FactorsMultiply)
{
  const BreakdownLaw law{4e7,
                         {StretchStrength{.63, {1., 6.}},
                          ThicknessStrength{1e-3, .25, {1e-6, 1e-3}}}};
  EXPECT_DOUBLE_EQ(compute_strength(law, state),
                   4e7 * std::pow(3., .63) * std::pow(20., .25));
}

TEST(BreakdownLaw, RatesAreKeptWithinTheirBounds)
{
  const RateStrength law{1e4, .1, {1e2, 1e5}};
  const auto at_rate = [&](const double rate) {
    return compute(law, {9., 50e-6, 310., rate, .6});
  };
  EXPECT_DOUBLE_EQ(at_rate(0.), 4e7 * std::pow(1e-2, .1));
  EXPECT_DOUBLE_EQ(at_rate(1e9), 4e7 * std::pow(1e1, .1));
}

TEST(BreakdownLaw, OutOfRangeNamesValueAndRange)
{
  const auto expect = [](const StrengthFactor& factor, const BreakdownState& at,
                         const std::vector<std::string>& words)
  {
    const std::string refusal = get_refusal(factor, at);
    for (const std::string& word : words)
      EXPECT_NE(refusal.find(word), std::string::npos) << refusal;
  };
  expect(StretchStrength{.63, {1., 2.5}}, state, {"is 3", "from 1 to 2.5"});
  expect(ThicknessStrength{1e-3, .25, {1e-4, 1e-3}}, state,
         {"thickness", "5e-05", "from 0.0001 to 0.001"});
  expect(TemperatureStrength{PolynomialLaw{300., {-.01}, 273., 305.}}, state,
         {"310 K", "from 273 to 305 K"});
  expect(HumidityStrength{PolynomialLaw{.2, {-.5}, 0., .5}}, state,
         {"0.6", "from 0 to 0.5"});
}

TEST(BreakdownLaw, MarginSeesTheFilmAsItIs)
{
  // Stretches 2 and 1.5: J = 3, h = 1e-4/3.
  const SymmetricTensor2<double> C = {4., 2.25, 0.};
  const Dielectric dielectric{
      ConstantPermittivity{4.},
      {4e7,
       {StretchStrength{1., {1., 6.}}, ThicknessStrength{1e-4, .5, {0., 1e-3}},
        RateStrength{1e6, .5, {1., 1e9}}}}};
  const double strength = 4e7 * std::sqrt(3.) * std::sqrt(3.) * 2.;
  EXPECT_NEAR(
      compute_breakdown_margin(dielectric, C, {1e7, 4e6, 1e-4, 299., 0.}),
      1 - 3e7 / strength, 1e-14);
}

TEST(BreakdownLaw, BareFilmIsNotAsked)
{
  const SymmetricTensor2<double> C = {81., 81., 0.};
  const Dielectric dielectric{ConstantPermittivity{4.},
                              {4e7, {StretchStrength{1., {1., 6.}}}}};
  EXPECT_EQ(compute_breakdown_margin(dielectric, C, {0., 0., 1e-4, 299., 0.}),
            1.);
  EXPECT_THROW(
      compute_breakdown_margin(dielectric, C, {1., 0., 1e-4, 299., 0.}),
      StepRejected);
}
} // namespace
