#include <taut/base/exceptions.h>
#include <taut/material/validate.h>

#include <limits>
#include <string>

#include "states.h"

namespace
{
using namespace taut::material;

/// The message must name every one of `parts`.
void expect_refused(const Elastomer& elastomer,
                    const std::vector<std::string>& parts)
{
  try
  {
    validate(elastomer);
    ADD_FAILURE() << "accepted, expected a refusal naming " << parts[0];
  }
  catch (const taut::BadInput& error)
  {
    for (const std::string& part : parts)
      EXPECT_NE(error.message().find(part), std::string::npos)
          << error.message();
  }
}

Elastomer make_with_spring(const Spring& spring)
{
  return {{NeoHookean{1e4}, spring}, {}, {}, 960.};
}

TEST(Validate, AcceptsEveryLaw)
{
  EXPECT_NO_THROW(validate(make_elastomer()));
  EXPECT_NO_THROW(validate({{}, {{NeoHookean{1.}, 1.}}, {}, 0.}));
}

TEST(Validate, RefusesSprings)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused(make_with_spring(NeoHookean{-1.}),
                 {"spring 2", "shear modulus", "-1", "positive"});
  expect_refused(make_with_spring(NeoHookean{nan}), {"spring 2", "nan"});
  expect_refused(make_with_spring(MooneyRivlin{-1., 2.}),
                 {"first coefficient"});
  expect_refused(make_with_spring(MooneyRivlin{2., -1.}),
                 {"second coefficient"});
  expect_refused(make_with_spring(MooneyRivlin{0., 0.}), {"shear modulus"});
  expect_refused(make_with_spring(Gent{0., 60.}), {"shear modulus"});
  expect_refused(make_with_spring(Gent{1., 0.}), {"limit J_lim"});
  expect_refused(make_with_spring(Yeoh{0., 1., 1.}), {"first coefficient"});
  expect_refused(make_with_spring(Yeoh{1., nan, 1.}), {"second coefficient"});
  expect_refused(make_with_spring(Yeoh{1., 1., nan}), {"third coefficient"});
  expect_refused(make_with_spring(ArrudaBoyce{-1., 5.}), {"shear modulus"});
  expect_refused(make_with_spring(ArrudaBoyce{1., 1.}),
                 {"limit stretch", "larger than 1"});
}

TEST(Validate, RefusesNetworks)
{
  expect_refused({{NeoHookean{1.}}, {{NeoHookean{1.}, 0.}}, {}, 0.},
                 {"network 1", "relaxation time"});
  expect_refused(
      {{NeoHookean{1.}}, {{NeoHookean{1.}, 1.}, {Gent{1., -3.}, 1.}}, {}, 0.},
      {"network 2", "limit J_lim", "-3"});
}

TEST(Validate, RefusesRelaxationLaws)
{
  const auto make = [](const RelaxationLaw& law, const FlowLaw flow)
  {
    return Elastomer{
        {NeoHookean{1.}}, {{NeoHookean{1.}, 1., flow, law}}, {}, 0.};
  };
  expect_refused(make(StressActivatedRelaxation{0.}, FlowLaw::isotropic),
                 {"network 1", "activation stress", "positive"});
  expect_refused(make(StretchActivatedRelaxation{-1.}, FlowLaw::isotropic),
                 {"network 1", "coefficient", "0 or more"});
  expect_refused(make(StretchActivatedRelaxation{1.}, FlowLaw::held_width),
                 {"network 1", "held width is constant"});
}

TEST(Validate, RefusesFibreFamilies)
{
  const auto make = [](const FibreFamily& family)
  {
    Elastomer elastomer = {{NeoHookean{1.}}, {}, {}, 0.};
    elastomer.fibres = {family};
    return elastomer;
  };
  const std::array<double, 2> x{{1., 0.}};
  EXPECT_NO_THROW(validate(make({ExponentialFibres{1., 2.}, x, true, .2})));
  expect_refused(make({QuadraticFibres{0.}}), {"fibre family 1", "k1"});
  expect_refused(make({ExponentialFibres{-1., 1.}}), {"k1"});
  expect_refused(make({ExponentialFibres{1., 0.}}), {"k2", "positive"});
  expect_refused(make({QuadraticFibres{1.}, {{1., 1.}}}), {"direction"});
  expect_refused(make({QuadraticFibres{1.}, x, true, .4}),
                 {"dispersion", "0.4", "1/3"});
  expect_refused(make({QuadraticFibres{1.}, x, true, 0., 0.}),
                 {"rest stretch", "positive"});
  expect_refused(make({QuadraticFibres{1.}, x, true, .1, 2.}),
                 {"rest stretch", "dispersed"});
}

TEST(Validate, RefusesDielectrics)
{
  const std::vector<Spring> springs = {NeoHookean{1.}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused({springs, {}, {ConstantPermittivity{4e-11}}, 0.},
                 {"relative permittivity", "4e-11", "1 (vacuum) or more"});
  expect_refused({springs, {}, {ConstantPermittivity{4.}, {0.}}, 0.},
                 {"breakdown strength"});
  const auto expect_refused_law =
      [&](const StrengthFactor& factor, const std::vector<std::string>& words)
  {
    expect_refused(
        {springs, {}, {ConstantPermittivity{4.}, {1e8, {factor}}}, 0.}, words);
  };
  expect_refused_law(StretchStrength{nan, {}}, {"exponent of the stretch"});
  expect_refused_law(StretchStrength{1., {-1., 5.}}, {"lowest stretch", "-1"});
  expect_refused_law(StretchStrength{1., {5., 5.}}, {"highest stretch"});
  expect_refused_law(ThicknessStrength{0., 1., {}}, {"reference thickness"});
  expect_refused_law(ThicknessStrength{1e-3, nan, {}},
                     {"exponent of the thickness"});
  expect_refused_law(ThicknessStrength{1e-3, 1., {1e-3, 1e-4}},
                     {"highest thickness"});
  expect_refused_law(RateStrength{0., .1, {1., 2.}}, {"reference rate"});
  expect_refused_law(RateStrength{1., nan, {1., 2.}}, {"exponent of the rate"});
  expect_refused_law(RateStrength{1., .1, {0., 2.}}, {"lowest rate"});
  expect_refused_law(RateStrength{1., .1, {2., 1.}}, {"highest rate"});
  expect_refused({springs, {}, {StretchPermittivity{-1.}}, 0.},
                 {"permittivity at high temperature"});
  expect_refused({springs, {}, {StretchPermittivity{1., -1.}}, 0.},
                 {"dipole coefficient"});
  expect_refused({springs, {}, {StretchPermittivity{0., 0.}}, 0.}, {"sum"});
  expect_refused({springs, {}, {StretchPermittivity{1., 1., nan}}, 0.},
                 {"linear stretch coefficient"});
  expect_refused({springs, {}, {StretchPermittivity{1., 1., 0., nan}}, 0.},
                 {"quadratic stretch coefficient"});
  expect_refused({springs, {}, {StretchPermittivity{1., 1., 0., 0., nan}}, 0.},
                 {"cubic stretch coefficient"});
}

TEST(Validate, RefusesElastomers)
{
  expect_refused({{}, {}, {}, 960.}, {"neither a spring nor a network"});
  expect_refused({{NeoHookean{1.}}, {}, {}, -1.}, {"density", "-1"});
}
} // namespace
