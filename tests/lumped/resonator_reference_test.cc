#include <taut/lumped/resonator_run.h>
#include <taut/lumped/resonator_statics.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "resonator_cases.h"
#include "resonator_reference.h"

using namespace taut;
using namespace taut::lumped;
using resonator_reference::Row;
using resonator_reference::Trajectory;

namespace
{
// With a local tolerance of 1e-12 the global error of these runs is below 1e-10
// (found by comparison with 1e-13); the numbers of the reference have 14
// digits.
constexpr double integration_error = 1e-10;

Resonator make_resonator(const Trajectory& trajectory)
{
  auto resonator = resonator_cases::make_thesis_resonator(
      trajectory.equilibrium_fraction, trajectory.relaxation_times);
  resonator.voltage =
      Signal::ramp(trajectory.rate, trajectory.start, trajectory.limit);
  return resonator;
}

ResonatorRunOptions make_options(const Trajectory& trajectory)
{
  ResonatorRunOptions options;
  options.start =
      trajectory.relaxed ? ResonatorStart::relaxed : ResonatorStart::unrelaxed;
  for (const auto& row : trajectory.rows)
    options.output_times.push_back(row[0]);
  options.end_time = trajectory.failure.mode == 0
                         ? trajectory.rows.back()[0]
                         : 1.5 * trajectory.failure.time;
  options.ode.relative_tolerance = 1e-12;
  options.ode.absolute_tolerance = 1e-14;
  return options;
}

Row flatten(const ResonatorRow& row)
{
  Row values = {row.time,       row.voltage,          row.stretch_1a,
                row.stretch_1b, row.stress_1a,        row.stress_2a,
                row.stress_2b,  row.breakdown_margin, row.frequency};
  values.insert(values.end(), row.internal.begin(), row.internal.end());
  return values;
}

void expect_equal(const Row& row, const Row& expected, const double tolerance)
{
  ASSERT_EQ(row.size(), expected.size());
  for (std::size_t i = 0; i < row.size(); ++i)
    EXPECT_NEAR(row[i], expected[i],
                tolerance * std::max(1., std::abs(expected[i])))
        << "column " << i << " at t = " << expected[0];
}

void expect_same_failure(const ResonatorRun& run, const Trajectory& trajectory,
                         const double tolerance)
{
  ASSERT_EQ(run.failure.has_value(), trajectory.failure.mode != 0);
  if (!run.failure)
    return;
  const auto& expected = trajectory.failure;
  const bool in_1 = expected.mode == 1;
  EXPECT_EQ(run.failure->failure, in_1 ? ResonatorFailure::loss_of_tension_1
                                       : ResonatorFailure::loss_of_tension_2);
  EXPECT_EQ(run.failure->place,
            in_1 ? ResonatorPlace::a_and_b : ResonatorPlace::a);
  const auto& row = run.failure->row;
  EXPECT_NEAR(row.time, expected.time, tolerance * expected.time);
  EXPECT_NEAR(row.voltage, expected.voltage, tolerance * expected.voltage);
  EXPECT_NEAR(row.stretch_1a, expected.stretch_1a,
              tolerance * expected.stretch_1a);
}
} // namespace

class ResonatorReference : public testing::TestWithParam<Trajectory>
{
};

TEST_P(ResonatorReference, TrajectoryAndFailureAreReproduced)
{
  const auto& trajectory = GetParam();
  const double tolerance = trajectory.error + integration_error;
  const auto run =
      run_quasi_static(make_resonator(trajectory), make_options(trajectory));
  // The first row is the start.
  ASSERT_GT(run.rows.size(), trajectory.rows.size());
  for (std::size_t i = 0; i < trajectory.rows.size(); ++i)
    expect_equal(flatten(run.rows[i + 1]), trajectory.rows[i], tolerance);
  expect_same_failure(run, trajectory, tolerance);
}

TEST_P(ResonatorReference, FailureIsAccurateAtDefaultTolerances)
{
  const auto& trajectory = GetParam();
  auto options = make_options(trajectory);
  options.ode = {};
  options.output_times.clear();
  const auto run = run_quasi_static(make_resonator(trajectory), options);
  expect_same_failure(run, trajectory, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(
    All, ResonatorReference,
    testing::ValuesIn(resonator_reference::get_trajectories()),
    [](const testing::TestParamInfo<Trajectory>& info)
    {
      std::string name = info.param.name;
      std::replace_if(
          name.begin(), name.end(), [](const char c) { return !isalnum(c); },
          '_');
      return name;
    });

TEST(ResonatorStaticReference, RelaxedStatesAreReproduced)
{
  const auto resonator = resonator_cases::make_thesis_resonator(0.5, {1});
  for (const auto& expected : resonator_reference::get_relaxed_states())
  {
    const auto row = find_relaxed_state(resonator, expected[0]);
    // No integration: round-off, amplified where stresses cancel.
    expect_equal({row.voltage, row.stretch_1a, row.stress_1a, row.stress_2a,
                  row.stress_2b, row.breakdown_margin, row.frequency},
                 expected, 1e-12);
  }
}
