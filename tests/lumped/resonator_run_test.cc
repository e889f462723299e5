#include <taut/base/exceptions.h>
#include <taut/lumped/resonator_run.h>
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
ResonatorRunOptions make_options(const double end_time, const int outputs,
                                 const ResonatorStart start)
{
  ResonatorRunOptions options;
  options.end_time = end_time;
  for (int i = 1; i < outputs; ++i)
    options.output_times.push_back(end_time * i / outputs);
  options.start = start;
  options.ode.relative_tolerance = 1e-11;
  options.ode.absolute_tolerance = 1e-13;
  return options;
}

/// Kinetic + free + dissipated + work of the voltage.
double compute_balance(const ResonatorRow& row)
{
  return row.kinetic_energy + row.free_energy + row.dissipated_energy +
         row.voltage_work;
}

/// A small oscillation about the start against a cosine of the natural
/// frequency.
void expect_natural_oscillation(const Resonator& resonator)
{
  const double amplitude = 1e-5;
  auto options = make_options(0.5, 40, ResonatorStart::unrelaxed);
  options.displacement = amplitude;
  const auto run = run_inertial(resonator, options);
  const double omega = run.rows[0].frequency * std::sqrt(resonator.get_alpha());
  const double rest = run.rows[0].stretch_1a - amplitude;
  ASSERT_GT(omega * options.end_time, 6 * 3.14); // three periods
  // The mean drifts by amplitude^2 / stretch, here 1e-5 of the amplitude.
  for (const auto& row : run.rows)
    EXPECT_NEAR(row.stretch_1a - rest, amplitude * std::cos(omega * row.time),
                1e-4 * amplitude);
}

/// Local extrema of the natural frequency strictly inside the run.
std::vector<ResonatorRow> find_extrema(const ResonatorRun& run)
{
  std::vector<ResonatorRow> extrema;
  for (std::size_t i = 1; i + 1 < run.rows.size(); ++i)
    if ((run.rows[i].frequency - run.rows[i - 1].frequency) *
            (run.rows[i + 1].frequency - run.rows[i].frequency) <
        0)
      extrema.push_back(run.rows[i]);
  return extrema;
}

/// The time at which the frequency stays within 1 % of its last value.
double find_settling_time(const ResonatorRun& run)
{
  const double last = run.rows.back().frequency;
  for (auto row = run.rows.rbegin(); row != run.rows.rend(); ++row)
    if (std::abs(row->frequency - last) > 0.01 * last)
      return row->time;
  return 0;
}

/// The thesis' actuation: relaxed, V* ramped to 0.2 and held.
ResonatorRun actuate(const std::vector<double>& times, const double rate,
                     const double end_time, const int outputs)
{
  auto resonator = make_thesis_resonator(0.5, times);
  resonator.voltage = Signal::ramp(rate, 0, 0.2);
  auto options = make_options(end_time, outputs, ResonatorStart::relaxed);
  options.ode = {};
  return run_quasi_static(resonator, options);
}
} // namespace

TEST(ResonatorInertial, OscillatesAtItsNaturalFrequency)
{
  auto elastic = make_thesis_resonator(1, {});
  elastic.length_ratio = 0.7;
  elastic.inertia_a = 3e-5;
  elastic.inertia_b = 5e-5;
  elastic.inertia_bar = 4e-4;
  elastic.voltage = Signal::constant(0.15);
  expect_natural_oscillation(elastic);
  // Networks too slow to follow are springs: the frozen definition.
  auto frozen = elastic;
  frozen.equilibrium_fraction = 0.3;
  frozen.networks = make_networks(0.3, {1}, {1e9});
  expect_natural_oscillation(frozen);
}

TEST(ResonatorInertial, EnergyIsBalancedUnderASmoothVoltage)
{
  auto resonator = make_thesis_resonator(0.5, {0.05, 2});
  resonator.inertia_bar = 1e-3;
  resonator.voltage = Signal::sine(0.1, 0.05, 3, 0.4);
  auto options = make_options(2, 50, ResonatorStart::unrelaxed);
  options.velocity = 2;
  options.stop_at_failure = false;
  const auto run = run_inertial(resonator, options);
  const double start = compute_balance(run.rows[0]);
  EXPECT_GT(run.rows.back().dissipated_energy, 0.1);
  EXPECT_GT(std::abs(run.rows.back().voltage_work), 0.01);
  // About a thousand steps at 1e-11 each.
  for (const auto& row : run.rows)
    EXPECT_NEAR(compute_balance(row), start, 1e-8);
}

TEST(ResonatorInertial, EnergyIsBalancedAcrossJumpsOfTheVoltage)
{
  auto resonator = make_thesis_resonator(0.5, {0.05, 2});
  resonator.inertia_bar = 1e-3;
  resonator.voltage = Signal::steps({0, 0.5, 0.8}, {0.05, 0.12, 0.02});
  auto options = make_options(1.2, 7, ResonatorStart::relaxed);
  options.stop_at_failure = false;
  const auto run = run_inertial(resonator, options);
  const double start = compute_balance(run.rows[0]);
  for (const auto& row : run.rows)
    EXPECT_NEAR(compute_balance(row), start, 1e-8);
}

TEST(ResonatorInertial, BarMovesByTheDifferenceOfTheForces)
{
  auto resonator = make_thesis_resonator(0.5, {0.1});
  resonator.length_ratio = 2;
  resonator.inertia_a = 2e-4;
  resonator.inertia_b = 1e-4;
  resonator.inertia_bar = 5e-4;
  auto options = make_options(0.2, 2000, ResonatorStart::relaxed);
  options.displacement = 0.1;
  const auto run = run_inertial(resonator, options);
  for (std::size_t i = 100; i + 1 < run.rows.size(); i += 100)
  {
    const auto& row = run.rows[i];
    const double h = run.rows[i + 1].time - row.time;
    const double acceleration =
        (run.rows[i + 1].velocity - run.rows[i - 1].velocity) / (2 * h);
    // Differences over (omega h)^2 = 3e-5 / 6 of the acceleration, some 400.
    EXPECT_NEAR(row.force_1b - row.force_1a,
                resonator.inertia_bar * acceleration, 5e-6);
  }
}

TEST(ResonatorInertial, FollowsTheQuasiStaticBalanceWhenSlow)
{
  // The motion lags by V'' / omega^2 and rings with rate / omega from the kink,
  // so the difference falls with 1 / sqrt(alpha).
  auto resonator = make_thesis_resonator(0.5, {0.2});
  resonator.voltage = Signal::ramp(0.05, 0, 1);
  const auto options = make_options(2, 20, ResonatorStart::relaxed);
  const auto slow = run_quasi_static(resonator, options);
  std::vector<double> differences;
  for (const double inertia : {1e-4, 1e-6})
  {
    resonator.inertia_bar = inertia;
    const auto fast = run_inertial(resonator, options);
    double difference = 0;
    for (std::size_t i = 0; i < slow.rows.size(); ++i)
      difference = std::max(difference, std::abs(fast.rows[i].stretch_1a -
                                                 slow.rows[i].stretch_1a));
    EXPECT_LT(difference, 0.05 * std::sqrt(inertia));
    differences.push_back(difference);
  }
  EXPECT_LT(differences[1], 0.3 * differences[0]);
}

TEST(ResonatorInertial, LossOfTensionStopsAViolentMotion)
{
  auto resonator = make_thesis_resonator(0.5, {1});
  resonator.inertia_bar = 1e-3;
  auto options = make_options(1, 2, ResonatorStart::relaxed);
  options.velocity = 60;
  const auto run = run_inertial(resonator, options);
  ASSERT_TRUE(run.failure);
  // The bar moves towards B, which goes slack first.
  EXPECT_EQ(run.failure->failure, ResonatorFailure::loss_of_tension_1);
  EXPECT_EQ(run.failure->place, ResonatorPlace::b);
  EXPECT_NEAR(run.failure->row.stress_1b, 0, 1e-10);
  EXPECT_GT(run.failure->row.stress_1a, 1);
}

TEST(ResonatorQuasiStatic, BreakdownIsLocatedToTheLastDigits)
{
  auto resonator = make_thesis_resonator(0.5, {0.1, 5});
  resonator.strength = 1;
  resonator.voltage = Signal::ramp(0.3, 0, 10);
  const auto run =
      run_quasi_static(resonator, make_options(2, 1, ResonatorStart::relaxed));
  ASSERT_TRUE(run.failure);
  EXPECT_EQ(run.failure->failure, ResonatorFailure::breakdown);
  EXPECT_EQ(run.failure->place, ResonatorPlace::a);
  EXPECT_NEAR(run.failure->row.breakdown_margin, 0, 1e-14);
  EXPECT_EQ(run.rows.back().time, run.failure->row.time);
}

TEST(ResonatorQuasiStatic, RunsPastFailuresIfAskedTo)
{
  auto resonator = make_thesis_resonator(0.5, {1});
  resonator.voltage = Signal::ramp(0.3, 0, 10);
  auto options = make_options(1.2, 1, ResonatorStart::relaxed);
  options.stop_at_failure = false;
  const auto run = run_quasi_static(resonator, options);
  EXPECT_FALSE(run.failure);
  ASSERT_EQ(run.events.size(), 2u);
  EXPECT_EQ(run.events[0].failure, ResonatorFailure::loss_of_tension_1);
  EXPECT_EQ(run.events[1].failure, ResonatorFailure::loss_of_tension_2);
  EXPECT_LT(run.events[0].row.time, run.events[1].row.time);
  EXPECT_NEAR(run.events[1].row.stress_2a, 0, 1e-13);
  EXPECT_EQ(run.rows.back().time, 1.2);
}

TEST(ResonatorQuasiStatic, FailureByThePreStretchIsReportedAtTheStart)
{
  auto resonator = make_thesis_resonator(0.5, {1});
  resonator.pre_stretch_1 = 1.2;
  resonator.pre_stretch_2 = 0.6;
  const auto run = run_quasi_static(
      resonator, make_options(0.1, 1, ResonatorStart::unrelaxed));
  EXPECT_FALSE(run.failure);
  ASSERT_FALSE(run.events.empty());
  for (const auto& event : run.events)
  {
    EXPECT_TRUE(event.at_start);
    EXPECT_EQ(event.row.time, 0);
  }
  EXPECT_EQ(to_text(run.events[0].failure), "loss of tension along x_1");
  EXPECT_EQ(to_text(run.events[0].place), "A and B");
}

TEST(ResonatorQuasiStatic, JumpsWithTheVoltageAtHeldInternalStretches)
{
  auto resonator = make_thesis_resonator(0.5, {0.1, 5});
  resonator.voltage = Signal::steps({0, 1}, {0, 0.15});
  auto options = make_options(2, 1, ResonatorStart::unrelaxed);
  options.output_times = {1};
  const auto run = run_quasi_static(resonator, options);
  ASSERT_EQ(run.rows.size(), 3u);
  const auto& after = run.rows[1];
  EXPECT_EQ(after.voltage, 0.15);
  // Before the jump both strips were alike.
  EXPECT_NEAR(after.internal[0], after.internal[2], 1e-12);
  FrozenResonator frozen(resonator);
  frozen.freeze(after.internal.data());
  EXPECT_NEAR(frozen.find_balance(0, 2), 2, 1e-12);
  EXPECT_NEAR(after.stretch_1a, frozen.find_balance(0.15, 2), 1e-14);
  EXPECT_GT(after.stretch_1a, 2.05);
}

TEST(ResonatorQuasiStatic, RunInTwoPartsEqualsTheWhole)
{
  auto resonator = make_thesis_resonator(0.5, {0.1, 5});
  resonator.voltage = Signal::ramp(0.1, 0, 1);
  auto options = make_options(1.5, 1, ResonatorStart::unrelaxed);
  const auto whole = run_quasi_static(resonator, options);
  options.end_time = 0.7;
  const auto first = run_quasi_static(resonator, options);
  options.start_time = 0.7;
  options.end_time = 1.5;
  options.start = ResonatorStart::given;
  options.internal = first.rows.back().internal;
  const auto second = run_quasi_static(resonator, options);
  // Both have the error of the integrator, some hundred steps of 1e-11.
  EXPECT_NEAR(second.rows.back().stretch_1a, whole.rows.back().stretch_1a,
              1e-10);
}

TEST(ResonatorQuasiStatic, VoltageMayBeInOtherUnits)
{
  auto resonator = make_thesis_resonator(0.5, {0.1});
  resonator.voltage = Signal::ramp(0.1, 0, 1);
  const auto options = make_options(1, 1, ResonatorStart::unrelaxed);
  const auto dimensionless = run_quasi_static(resonator, options);
  resonator.voltage = Signal::ramp(3.1e3, 0, 3.1e4);
  resonator.voltage_unit = 3.1e4;
  const auto volts = run_quasi_static(resonator, options);
  EXPECT_NEAR(volts.rows.back().voltage, 0.1, 1e-15);
  EXPECT_NEAR(volts.rows.back().stretch_1a,
              dimensionless.rows.back().stretch_1a, 1e-12);
}

TEST(ResonatorQuasiStatic, RefusesImpossibleRuns)
{
  const auto resonator = make_thesis_resonator(0.5, {0.1});
  auto options = make_options(-1, 1, ResonatorStart::unrelaxed);
  EXPECT_THROW(run_quasi_static(resonator, options), BadInput);
  options = make_options(1, 1, ResonatorStart::given);
  options.internal = {1, 1, 1};
  EXPECT_THROW(run_quasi_static(resonator, options), BadInput);
  auto spoiled = resonator;
  spoiled.gent_limit = 10;
  options = make_options(1, 1, ResonatorStart::relaxed);
  EXPECT_THROW(run_quasi_static(spoiled, options), BadInput);
  EXPECT_THROW(run_inertial(spoiled, options), BadInput);
}

// Statements of the thesis (numbers of the claims table, rounded there).

TEST(ResonatorClaims, LargerEquilibriumFractionSustainsMore)
{
  // Claim 7 (figure 3.4): failure voltage and stretch for chi = 0.1 and 0.5.
  const auto fail = [](const double fraction)
  {
    auto resonator = make_thesis_resonator(fraction, {0.01});
    resonator.voltage = Signal::ramp(0.3, 0, 1);
    return run_quasi_static(resonator,
                            make_options(2, 1, ResonatorStart::unrelaxed))
        .failure->row;
  };
  EXPECT_NEAR(fail(0.1).voltage, 0.0984, 5e-5);
  EXPECT_NEAR(fail(0.1).stretch_1a, 2.832, 5e-4);
  EXPECT_NEAR(fail(0.5).voltage, 0.2225, 5e-5);
  EXPECT_NEAR(fail(0.5).stretch_1a, 3.410, 5e-4);
}

TEST(ResonatorClaims, FrequencyFallsThenRisesUnderActuation)
{
  // Claims 13 and 15: 1.603, down to 1.554 at V* = 0.131, up to 1.698.
  const auto one = actuate({100}, 0.3, 2. / 3, 2000);
  EXPECT_NEAR(one.rows[0].frequency, 1.6028, 5e-5);
  const auto extrema = find_extrema(one);
  ASSERT_EQ(extrema.size(), 1u);
  EXPECT_NEAR(extrema[0].frequency, 1.554, 5e-4);
  EXPECT_NEAR(extrema[0].voltage, 0.131, 5e-4);
  EXPECT_NEAR(one.rows.back().frequency, 1.698, 5e-4);
  const auto three = actuate({0.01, 1, 100}, 0.3, 2. / 3, 2000);
  const auto lowest = std::min_element(three.rows.begin(), three.rows.end(),
                                       [](const auto& a, const auto& b)
                                       { return a.frequency < b.frequency; });
  EXPECT_NEAR(lowest->frequency, 1.558, 5e-4);
  EXPECT_NEAR(three.rows.back().frequency, 1.764, 5e-4);
}

TEST(ResonatorClaims, NetworksDecideTheTimeButNotTheFinalState)
{
  // Claim 16. The rows of the reference trajectories around the moment in which
  // 99 % of the final frequency is passed are 581 s and 615 s after the start
  // of the ramp with three networks, 1140 s and 1207 s with T = 100 s.
  const auto three = actuate({0.01, 1, 100}, 0.3, 4000, 4000);
  const auto one = actuate({100}, 0.3, 4000, 4000);
  EXPECT_NEAR(three.rows.back().frequency, 2.2160, 5e-5);
  EXPECT_NEAR(one.rows.back().frequency, 2.2160, 1e-4);
  EXPECT_GT(find_settling_time(three), 581);
  EXPECT_LT(find_settling_time(three), 615);
  EXPECT_GT(find_settling_time(one), 1140);
  EXPECT_LT(find_settling_time(one), 1207);
}
