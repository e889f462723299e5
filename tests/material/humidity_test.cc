#include <taut/base/exceptions.h>
#include <taut/material/at_temperature.h>

#include "rheometer.h"
#include "states.h"

namespace
{
using namespace taut::material;

HumidityLaws make_laws()
{
  return {PolynomialLaw{.5, {-.3}, .2, .9}, ExponentialLaw{.5, -2.},
          ExponentialLaw{.5, .8}};
}

TEST(HumidityLaw, FactorsFollowTheirFormulas)
{
  EXPECT_EQ(compute_factor(HumidityLaw(ConstantLaw{}), .3), 1.);
  EXPECT_DOUBLE_EQ(compute_factor(ExponentialLaw{.4, -2.}, .9), std::exp(-1.));
  EXPECT_DOUBLE_EQ(
      compute_factor(HumidityLaw(TableLaw{{0., .5, 1.}, {1., .8, .2}}), .75),
      .5);
}

TEST(HumidityLaw, DerivativesAreThoseOfTheFactors)
{
  const double step = 1e-5, h = .6;
  for (const HumidityLaw& law :
       {HumidityLaw(PolynomialLaw{.5, {-.3, .1}, 0., 1.}),
        HumidityLaw(TableLaw{{0., .5, 1.}, {1., .8, .2}}),
        HumidityLaw(ExponentialLaw{.5, -2.})})
    // Central differences: 1e-10, and rounding over the step.
    EXPECT_NEAR(
        compute_factor_derivative(law, h),
        (compute_factor(law, h + step) - compute_factor(law, h - step)) /
            (2. * step),
        1e-9);
}

TEST(HumidityLaw, OutsideItsRangeOrThatOfHumiditiesNothingIsComputed)
{
  const HumidityLaw polynomial = PolynomialLaw{.5, {-.3}, .2, .9};
  EXPECT_THROW(compute_factor(polynomial, .19), taut::StepRejected);
  EXPECT_THROW(compute_factor_derivative(polynomial, .91), taut::StepRejected);
  for (const HumidityLaw& law :
       {HumidityLaw(ConstantLaw{}), HumidityLaw(ExponentialLaw{.5, 1.})})
    for (const double humidity : {-.01, 1.01, std::nan("")})
      EXPECT_THROW(compute_factor(law, humidity), taut::StepRejected);
  try
  {
    compute_factor(polynomial, .95);
    FAIL() << "accepted";
  }
  catch (const taut::StepRejected& problem)
  {
    EXPECT_STREQ(problem.what(), "the relative humidity is 0.95, its law holds "
                                 "from 0.2 to 0.9");
  }
}

TEST(Humidity, EveryPropertyFollowsItsLaw)
{
  const Elastomer dry = make_elastomer();
  const Elastomer wet = make_at_humidity(dry, make_laws(), .8);
  EXPECT_NEAR(shear_modulus(wet), (1. - .3 * .3) * shear_modulus(dry), 1e-9);
  const Invariants<double> x = compute_invariants(Tensor{4., 2., .3});
  for (const PermittivityLaw& law : {PermittivityLaw(ConstantPermittivity{4.}),
                                     PermittivityLaw(StretchPermittivity{})})
  {
    Elastomer elastomer = dry;
    elastomer.dielectric.permittivity = law;
    const Elastomer moist = make_at_humidity(elastomer, make_laws(), .8);
    EXPECT_NEAR(
        compute_relative_permittivity(moist.dielectric.permittivity, x, 300.) /
            compute_relative_permittivity(law, x, 300.),
        std::exp(.8 * .3), 1e-14);
  }
  for (std::size_t m = 0; m < dry.networks.size(); ++m)
    EXPECT_DOUBLE_EQ(wet.networks[m].relaxation_time,
                     std::exp(-2. * .3) * dry.networks[m].relaxation_time);
}

TEST(Humidity, NetworksRelaxAtTheirOwnTimes)
{
  // At a fixed stretch what is left depends on t/T alone.
  const Elastomer dry = make_single_network(NeoHookean{2.});
  const double faster = std::exp(-2. * .3);
  const auto run = [](const Elastomer& elastomer, const double time)
  {
    return Rheometer({elastomer, Shape::uniaxial},
                     {[](double) { return 2.; }, {}, {}})
        .run({time})[0]
        .internal[0];
  };
  expect_near(run(make_at_humidity(dry, make_laws(), .8), .4 * faster),
              run(dry, .4), 1e-10);
}

// A climate that changes: central differences along the tangents of both laws
// give dW/dT T' + dW/dh h', exactly, as the energy is bilinear in the steps.
TEST(Humidity, StepsOfBothFollowTheTangentOfTheEnergy)
{
  const Elastomer elastomer = make_elastomer();
  ThermalLaws thermal;
  thermal.modulus = PolynomialLaw{299., {-.005}, 250., 400.};
  const double T = 320., h = .6, T_rate = 40., h_rate = -.7;
  const double field = make_strong_field().nominal_squared;
  for (const State& state : make_states(elastomer.networks.size()))
  {
    const auto compute = [&](const double time, const double tangent)
    {
      const double at_T = T + time * T_rate, at_h = h + time * h_rate;
      return energy(
          make_at_humidity(
              make_at_temperature(elastomer, thermal, at_T, tangent * T_rate),
              make_laws(), at_h, tangent * h_rate),
          state.C, state.A.data(), {field, at_T});
    };
    const double scale = std::abs(compute(0., 0.));
    const double step = 1e-4;
    const double power = (compute(0., .1) - compute(0., -.1)) / .2;
    EXPECT_NEAR(power, (compute(step, 0.) - compute(-step, 0.)) / (2. * step),
                1e-6 * scale);
  }
}

TEST(Humidity, LawsAreConstantUnlessOneIsNot)
{
  EXPECT_TRUE(is_constant(HumidityLaws{}));
  for (HumidityLaw HumidityLaws::*const law :
       {&HumidityLaws::modulus, &HumidityLaws::relaxation_time,
        &HumidityLaws::permittivity})
  {
    HumidityLaws laws;
    laws.*law = ExponentialLaw{.5, 1.};
    EXPECT_FALSE(is_constant(laws));
  }
}
} // namespace
