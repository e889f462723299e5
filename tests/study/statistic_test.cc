#include <taut/study/statistic.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace taut::study;

namespace
{
std::optional<double> compute(const std::vector<double>& times,
                              const std::vector<double>& values,
                              const Statistic statistic)
{
  ResultRequest request;
  request.statistic = statistic;
  return compute_statistic(times, values, request);
}
} // namespace

TEST(Statistic, OfAFewValues)
{
  const std::vector<double> times = {0, 1, 2, 4}, values = {3, -1, 5, 1};
  EXPECT_EQ(compute(times, values, Statistic::start), 3);
  EXPECT_EQ(compute(times, values, Statistic::final), 1);
  EXPECT_EQ(compute(times, values, Statistic::minimum), -1);
  EXPECT_EQ(compute(times, values, Statistic::maximum), 5);
  EXPECT_EQ(compute(times, values, Statistic::amplitude), 3);
  EXPECT_EQ(compute(times, values, Statistic::time_of_minimum), 1);
  EXPECT_EQ(compute(times, values, Statistic::time_of_maximum), 2);
}

TEST(Statistic, MeanIsOverTimeAndExactForStraightLines)
{
  // Rows at any times: the integral of 2 t + 1 from 0 to 4 is 20.
  const std::vector<double> times = {0, 0.1, 0.3, 3, 4};
  std::vector<double> values;
  for (const double time : times)
    values.push_back(2 * time + 1);
  EXPECT_NEAR(*compute(times, values, Statistic::mean), 5, 1e-14);
  EXPECT_EQ(compute({2}, {7}, Statistic::mean), 7);
}

TEST(Statistic, TimesAreThoseOfTheFirstExtremum)
{
  const std::vector<double> times = {0, 1, 2, 3}, values = {1, 0, 1, 0};
  EXPECT_EQ(compute(times, values, Statistic::time_of_minimum), 1);
  EXPECT_EQ(compute(times, values, Statistic::time_of_maximum), 0);
}

TEST(Statistic, WindowHoldsItsEnds)
{
  ResultRequest request;
  request.statistic = Statistic::maximum;
  request.from = 1;
  request.to = 2;
  const std::vector<double> times = {0, 1, 2, 3}, values = {9, 1, 2, 9};
  EXPECT_EQ(compute_statistic(times, values, request), 2);
  request.from = 5;
  request.to = 6;
  EXPECT_FALSE(compute_statistic(times, values, request));
}

TEST(Statistic, WhatIsNoNumberDoesNotCount)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> times = {0, 1, 2, 3}, values = {nan, 4, 2, nan};
  EXPECT_EQ(compute(times, values, Statistic::start), 4);
  EXPECT_EQ(compute(times, values, Statistic::final), 2);
  EXPECT_EQ(compute(times, values, Statistic::mean), 3);
  EXPECT_FALSE(compute({0, 1}, {nan, nan}, Statistic::maximum));
}

TEST(Statistic, AColumnHasNoEvent)
{
  EXPECT_FALSE(compute({0, 1}, {1, 2}, Statistic::time));
  EXPECT_FALSE(compute({0, 1}, {1, 2}, Statistic::value));
}
