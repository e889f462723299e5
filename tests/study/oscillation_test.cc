#include <taut/study/oscillation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace taut::study
{
namespace
{
constexpr double pi = 3.14159265358979323846;

struct History
{
  std::vector<double> times, values;
};

History sample(const std::function<double(double)>& function, const double end,
               const unsigned int n)
{
  History history;
  for (unsigned int i = 0; i <= n; ++i)
  {
    history.times.push_back(end * i / n);
    history.values.push_back(function(history.times.back()));
  }
  return history;
}

Oscillation measure(const History& history)
{
  return measure_oscillation(history.times, history.values, 1e-6);
}

TEST(Oscillation, FrequencyAndMeanOfASineAreThoseOfItsFormula)
{
  const auto sine = [](const double t)
  { return 0.8 + 0.1 * std::sin(2 * pi * 3.5 * t - 1); };
  // Linear between 40 rows a period: (2 pi/40)^2/8 of the amplitude in the
  // values and far less at the crossings, where a sine is straight.
  const auto measured = measure(sample(sine, 2.3, 322));
  EXPECT_NEAR(measured.frequency, 3.5, 3.5e-4);
  EXPECT_NEAR(measured.mean, 0.8, 1e-3 * 0.1);
  EXPECT_LT(measured.rises[1], 2.3);
  EXPECT_LT(measured.falls[1], 2.3);
}

TEST(Oscillation, DampingAndRipplesDoNotCount)
{
  const auto damped = [](const double t)
  {
    return 1 - 0.2 * std::exp(-0.5 * t) * std::cos(2 * pi * 2 * t) +
           1e-4 * std::sin(2 * pi * 90 * t);
  };
  // The slope 0.2 exp(-2) 4 pi of the last swing lets the ripple move the
  // crossings, which are 3.5 s apart, by less than 1e-3 s.
  const auto measured = measure(sample(damped, 4, 4000));
  EXPECT_NEAR(measured.frequency, 2, 2e-3);
  EXPECT_NEAR(measured.mean, 1, 2e-3);
}

TEST(Oscillation, WhatDoesNotSwingHasNone)
{
  const auto creep = [](const double t) { return 1 - std::exp(-t); };
  EXPECT_TRUE(std::isnan(measure(sample(creep, 5, 100)).frequency));
  const auto noise = [](const double t) { return 1 + 1e-8 * std::sin(50 * t); };
  EXPECT_TRUE(std::isnan(measure(sample(noise, 5, 1000)).frequency));
  EXPECT_TRUE(std::isnan(measure({{0, 1}, {0, 1}}).frequency));
}

TEST(Oscillation, MeansOfPartsOfRowsAreExactForStraightLines)
{
  const std::vector<double> times = {0, 1, 3}, values = {0, 2, 6};
  EXPECT_DOUBLE_EQ(compute_mean(times, values, 0.5, 2.5), 3);
}
} // namespace
} // namespace taut::study
