#include <taut/base/exceptions.h>
#include <taut/material/temperature_law.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{
using namespace taut::material;

const PolynomialLaw polynomial = {299., {-.005, 2e-5}, 250., 400.};
const TableLaw table = {{280., 300., 340.}, {1.2, 1., .4}};
const ArrheniusLaw arrhenius = {299., 30e3};

TEST(TemperatureLaw, FactorIsOneAtTheReference)
{
  EXPECT_EQ(compute_factor(ConstantLaw{}, 1e4), 1.);
  EXPECT_EQ(compute_factor(polynomial, 299.), 1.);
  EXPECT_EQ(compute_factor(arrhenius, 299.), 1.);
}

TEST(TemperatureLaw, FactorsFollowTheirFormulas)
{
  EXPECT_DOUBLE_EQ(compute_factor(polynomial, 309.), 1. - .05 + 2e-3);
  EXPECT_DOUBLE_EQ(compute_factor(table, 290.), 1.1);
  EXPECT_DOUBLE_EQ(compute_factor(table, 320.), .7);
  // Relaxation numbers .03 and .0136 at 299 and 320 K.
  EXPECT_NEAR(.03 * compute_factor(arrhenius, 320.), .0136, 5e-5);
}

TEST(TemperatureLaw, TableHoldsToItsEnds)
{
  EXPECT_DOUBLE_EQ(compute_factor(table, 280.), 1.2);
  EXPECT_DOUBLE_EQ(compute_factor(table, 300.), 1.);
  EXPECT_DOUBLE_EQ(compute_factor(table, 340.), .4);
  EXPECT_DOUBLE_EQ(compute_factor_derivative(table, 300.), -.015);
  EXPECT_DOUBLE_EQ(compute_factor_derivative(table, 340.), -.015);
}

TEST(TemperatureLaw, DerivativesAreThoseOfTheFactors)
{
  // Central differences: third derivatives of up to 3e-4 times
  // step^2/6.
  const double step = 1e-3;
  for (const TemperatureLaw& law :
       {TemperatureLaw{ConstantLaw{}}, TemperatureLaw{polynomial},
        TemperatureLaw{table}, TemperatureLaw{arrhenius}})
    for (const double temperature : {283., 310., 330.})
      EXPECT_NEAR(compute_factor_derivative(law, temperature),
                  (compute_factor(law, temperature + step) -
                   compute_factor(law, temperature - step)) /
                      (2. * step),
                  1e-10)
          << law.index() << " at " << temperature;
}

TEST(TemperatureLaw, RangesAreThoseGiven)
{
  EXPECT_EQ(get_range(polynomial).lowest, 250.);
  EXPECT_EQ(get_range(polynomial).highest, 400.);
  EXPECT_EQ(get_range(table).lowest, 280.);
  EXPECT_EQ(get_range(table).highest, 340.);
  EXPECT_TRUE(std::isinf(get_range(ConstantLaw{}).highest));
  EXPECT_TRUE(std::isinf(get_range(arrhenius).highest));
}

TEST(TemperatureLaw, OutsideItsRangeNothingIsComputed)
{
  EXPECT_THROW(compute_factor(polynomial, 249.9), taut::StepRejected);
  EXPECT_THROW(compute_factor_derivative(polynomial, 400.1),
               taut::StepRejected);
  EXPECT_THROW(compute_factor(arrhenius, 0.), taut::StepRejected);
  EXPECT_THROW(compute_factor(table, std::nan("")), taut::StepRejected);
  try
  {
    compute_factor(table, 350.);
    FAIL() << "a temperature outside the table was accepted";
  }
  catch (const taut::StepRejected& problem)
  {
    const std::string message = problem.what();
    EXPECT_NE(message.find("350"), std::string::npos);
    EXPECT_NE(message.find("from 280 to 340 K"), std::string::npos);
  }
}
} // namespace
