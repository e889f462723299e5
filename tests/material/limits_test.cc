// What is said of a state beyond the limits of its laws.
#include <taut/material/limits.h>

#include "states.h"

namespace
{
using namespace taut::material;

const Tensor stretched = {4., 4., 0.};

TEST(Limits, OfTheSprings)
{
  const Tensor A = {1., 1., 0.};
  const Elastomer gent = {{NeoHookean{1.}, Gent{1., 5.}}, {}, {}, 0.};
  EXPECT_EQ(describe_limit(gent, stretched, nullptr, no_voltage),
            "I1 = 8.0625 is beyond the limit 8 of the Gent spring 2");
  const Elastomer network = {
      {Gent{1., 60.}}, {{ArrudaBoyce{1., 1.5}, 1.}}, {}, 0.};
  EXPECT_EQ(describe_limit(network, stretched, &A, no_voltage),
            "I1 = 8.0625 is beyond the limit 6.75 of the Arruda-Boyce spring "
            "of network 1");
  const Tensor relaxed_internal = {.25, .25, 0.};
  EXPECT_EQ(describe_limit(network, stretched, &relaxed_internal, no_voltage),
            "");
}

TEST(Limits, OfWhichTheOneExceededMostIsNamed)
{
  const Elastomer elastomer = {{Gent{1., 5.}, Gent{1., 2.}}, {}, {}, 0.};
  EXPECT_EQ(describe_limit(elastomer, stretched, nullptr, no_voltage),
            "I1 = 8.0625 is beyond the limit 5 of the Gent spring 2");
}

TEST(Limits, OfALostState)
{
  const Elastomer elastomer = {{Gent{1., 5.}}, {}, {}, 0.};
  EXPECT_EQ(
      describe_limit(elastomer, {std::nan(""), 1., 0.}, nullptr, no_voltage),
      "I1 is not a number, beyond the limit 8 of the Gent spring 1");
}

TEST(Limits, OfAnExponentialFibreFamily)
{
  Elastomer elastomer = {{NeoHookean{1.}}, {}, {}, 0.};
  elastomer.fibres = {{QuadraticFibres{1.}}, {ExponentialFibres{1., 8.}}};
  // k2 (I4 - 1)^2 = 8 * 9.
  EXPECT_NEAR(limit_margin(elastomer, stretched, nullptr), (50. - 72.) / 50.,
              1e-14);
  EXPECT_EQ(
      describe_limit(elastomer, stretched, nullptr, no_voltage),
      "the exponent k2 e^2 = 72 is beyond the limit 50 of fibre family 2");
  // Pressed together they buckle, and there is nothing that could be exceeded.
  EXPECT_EQ(limit_margin(elastomer, Tensor{.01, 4., 0.}, nullptr), 1.);
}

TEST(Limits, OfAPermittivityThatVanishesUnderVoltage)
{
  // 1 - x/2 with x = l1 + l2 - 2.
  const Elastomer elastomer = {
      {NeoHookean{1.}}, {}, {StretchPermittivity{2., 900., -.5, 0., 0.}}, 0.};
  const Field on = {1., 300.};
  EXPECT_NEAR(limit_margin(elastomer, Tensor{2.25, 2.25, 0.}, nullptr, on), .5,
              1e-14);
  EXPECT_EQ(describe_limit(elastomer, {6.25, 6.25, 0.}, nullptr, on),
            "the permittivity, multiplied by -0.5 by the stretches, is not "
            "positive");
  EXPECT_TRUE(std::isinf(
      limit_margin(elastomer, Tensor{6.25, 6.25, 0.}, nullptr, no_voltage)));
}
} // namespace
