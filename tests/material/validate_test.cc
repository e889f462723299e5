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

TEST(Validate, RefusesDielectrics)
{
  const std::vector<Spring> springs = {NeoHookean{1.}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused({springs, {}, {ConstantPermittivity{4e-11}}, 0.},
                 {"relative permittivity", "4e-11", "1 (vacuum) or more"});
  expect_refused({springs, {}, {ConstantPermittivity{4.}, 0.}, 0.},
                 {"breakdown strength"});
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
