#include <taut/base/exceptions.h>
#include <taut/lumped/resonator_statics.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "resonator_cases.h"

using namespace taut;
using namespace taut::lumped;
using resonator_cases::make_thesis_resonator;

namespace
{
/// Smallest and largest shift of those that survive.
std::pair<TuningPoint, TuningPoint>
find_extremes(const std::vector<TuningPoint>& points)
{
  std::vector<TuningPoint> safe;
  std::copy_if(points.begin(), points.end(), std::back_inserter(safe),
               [](const TuningPoint& point) { return !point.failure; });
  const auto [low, high] =
      std::minmax_element(safe.begin(), safe.end(),
                          [](const TuningPoint& a, const TuningPoint& b)
                          { return a.shift < b.shift; });
  return {*low, *high};
}

std::vector<TuningPoint> tune(const double length_ratio)
{
  auto resonator = make_thesis_resonator(0.5, {1});
  resonator.length_ratio = length_ratio;
  std::vector<double> stretches;
  for (int i = 0; i <= 15; ++i)
    stretches.push_back(1 + 0.2 * i);
  return compute_tuning(resonator, 0.2, stretches, stretches);
}
} // namespace

TEST(ResonatorStatics, RelaxedStateCarriesNoLoadInItsNetworks)
{
  const auto one = make_thesis_resonator(0.5, {1});
  const auto three = make_thesis_resonator(0.5, {0.01, 1, 100});
  const auto a = find_relaxed_state(one, 0.2);
  const auto b = find_relaxed_state(three, 0.2);
  EXPECT_NEAR(a.stress_1a, b.stress_1a, 1e-14);
  EXPECT_NEAR(a.stress_1a, a.stress_1b, 1e-14);
  // Claim 18: the number of networks does not matter, but they stiffen: the
  // ground network alone gives 1.253 without a voltage.
  EXPECT_NEAR(a.frequency, b.frequency, 1e-13);
  const double with = find_relaxed_state(one, 0).frequency;
  EXPECT_NEAR(with, 1.6028, 5e-5);
  EXPECT_NEAR(std::sqrt(with * with - 2 * 0.5 * 4 / 4.), 1.253, 5e-4);
}

TEST(ResonatorStatics, SlackVoltageOfTheGentLimits)
{
  // Table of the static loss of tension in the notes.
  auto resonator = make_thesis_resonator(0.5, {1});
  const std::vector<std::pair<double, double>> table = {
      {60, 0.23225}, {67, 0.22391},  {70, 0.22106},
      {80, 0.21365}, {100, 0.20443}, {120, 0.19891}};
  for (const auto& [limit, voltage] : table)
  {
    resonator.gent_limit = limit;
    EXPECT_NEAR(compute_slack_voltage(resonator), voltage, 6e-6);
  }
}

TEST(ResonatorStatics, FailureByLossOfTensionMeetsTheClosedForm)
{
  auto resonator = make_thesis_resonator(0.5, {1});
  for (const double k : {0.8, 1., 2.})
  {
    resonator.length_ratio = k;
    const auto failure = find_static_failure(resonator);
    EXPECT_EQ(failure.failure, ResonatorFailure::loss_of_tension_1);
    EXPECT_EQ(failure.place, ResonatorPlace::a_and_b);
    EXPECT_FALSE(failure.at_start);
    EXPECT_NEAR(failure.row.voltage, compute_slack_voltage(resonator), 1e-13);
    EXPECT_NEAR(failure.row.stretch_1b, 0.5, 1e-13);
    EXPECT_NEAR(failure.row.stress_1a, 0, 1e-13);
  }
}

TEST(ResonatorStatics, OtherFailuresAreLocatedToo)
{
  auto resonator = make_thesis_resonator(0.5, {1});
  resonator.pre_stretch_2 = 1.2;
  const auto across = find_static_failure(resonator);
  EXPECT_EQ(across.failure, ResonatorFailure::loss_of_tension_2);
  EXPECT_EQ(across.place, ResonatorPlace::a);
  EXPECT_NEAR(across.row.stress_2a, 0, 1e-13);
  EXPECT_GT(across.row.stress_1a, 0);
  resonator.strength = 0.5;
  const auto breakdown = find_static_failure(resonator);
  EXPECT_EQ(breakdown.failure, ResonatorFailure::breakdown);
  EXPECT_NEAR(breakdown.row.breakdown_margin, 0, 1e-13);
  resonator.pre_stretch_2 = 0.6;
  resonator.pre_stretch_1 = 1.2;
  EXPECT_TRUE(find_static_failure(resonator).at_start);
}

TEST(ResonatorStatics, StaticFailureIsOnTheBranchOfTheRelaxedStates)
{
  auto resonator = make_thesis_resonator(0.5, {1});
  resonator.pre_stretch_1 = 3;
  const auto failure = find_static_failure(resonator);
  const auto row = find_relaxed_state(resonator, failure.row.voltage);
  EXPECT_NEAR(row.stretch_1a, failure.row.stretch_1a, 1e-12);
  EXPECT_NEAR(row.stress_2a, 0, 1e-12);
}

TEST(ResonatorStatics, BalanceIsStableWhileThereIsTension)
{
  // Omega_n^2 >= s_1 / lambda_1A + k ds_1B / dlambda_1B, see ResonatorFailure.
  auto resonator = make_thesis_resonator(0.5, {1, 10});
  for (const double k : {0.1, 1., 3.})
    for (const double internal : {0.8, 1.5, 2.5})
      for (const double voltage : {0., 0.1, 0.2})
      {
        resonator.length_ratio = k;
        FrozenResonator frozen(resonator);
        const std::vector<double> values = {internal, 2, 1,        3,
                                            1,        2, internal, 1.5};
        frozen.freeze(values.data());
        const double stretch = frozen.find_balance(voltage);
        const auto b = frozen.respond_b(stretch);
        EXPECT_GE(frozen.compute_frequency_squared(stretch, voltage),
                  b.stress_1 / stretch + k * b.stiffness_1);
        EXPECT_GT(b.stiffness_1, 0);
      }
}

TEST(ResonatorStatics, RefusesWhatHasNoAnswer)
{
  auto resonator = make_thesis_resonator(0.5, {1});
  resonator.gent_limit = 20; // reached at 3.5 x 4, before the tension is lost
  EXPECT_THROW(compute_slack_voltage(resonator), BadInput);
  resonator.gent_limit = 10;
  EXPECT_THROW(find_relaxed_state(resonator, 0.1), BadInput);
  EXPECT_THROW(find_static_failure(resonator), BadInput);
  EXPECT_THROW(compute_tuning(resonator, 0.2, {2}, {4}), BadInput);
}

TEST(ResonatorStatics, BreakdownComesBeforeTheGentLimit)
{
  auto resonator = make_thesis_resonator(0.5, {1});
  resonator.gent_limit = 20;
  const auto failure = find_static_failure(resonator);
  EXPECT_NE(failure.failure, ResonatorFailure::loss_of_tension_1);
  EXPECT_NEAR(failure.failure == ResonatorFailure::breakdown
                  ? failure.row.breakdown_margin
                  : failure.row.stress_2a,
              0, 1e-10);
}

TEST(ResonatorClaims, TuningOverThePreStretches)
{
  // Claims 23 to 25, lambda_1p and lambda_2p in steps of 0.2 from 1 to 4.
  const auto [low_k2, high_k2] = find_extremes(tune(2));
  EXPECT_NEAR(high_k2.shift, 2.234, 5e-4);
  EXPECT_NEAR(high_k2.pre_stretch_1, 1.4, 1e-12);
  EXPECT_NEAR(high_k2.pre_stretch_2, 4, 1e-12);
  EXPECT_NEAR(low_k2.shift, -0.207, 5e-4);
  EXPECT_NEAR(low_k2.pre_stretch_1, 4, 1e-12);
  EXPECT_NEAR(low_k2.pre_stretch_2, 4, 1e-12);
  const auto [low_k1, high_k1] = find_extremes(tune(1));
  EXPECT_NEAR(high_k1.shift, 1.183, 5e-4);
  EXPECT_NEAR(low_k1.shift, -0.056, 5e-4);
  const auto [low_k03, high_k03] = find_extremes(tune(0.3));
  EXPECT_NEAR(high_k03.shift, 0.360, 5e-4);
  EXPECT_NEAR(low_k03.shift, -0.398, 5e-4);
}

TEST(ResonatorClaims, TuningLeavesOutWhatFails)
{
  auto resonator = make_thesis_resonator(0.5, {1});
  const auto points = compute_tuning(resonator, 0.25, {1.2, 2}, {0.6, 4});
  ASSERT_EQ(points.size(), 4u);
  for (const auto& point : points)
  {
    EXPECT_TRUE(point.failure);
    EXPECT_EQ(point.shift, 0);
  }
}
