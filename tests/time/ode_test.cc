#include <taut/base/exceptions.h>
#include <taut/time/ode.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace taut;
using namespace taut::time;

namespace
{
constexpr double pi = 3.14159265358979323846;
using State = std::vector<double>;

OdeOptions make_options(const OdeMethod method, const double tolerance)
{
  OdeOptions options;
  options.method = method;
  options.relative_tolerance = options.absolute_tolerance = tolerance;
  return options;
}

/// y'' = -y as a system.
OdeProblem make_oscillator()
{
  OdeProblem problem;
  problem.size = 2;
  problem.rate = [](double, const double* y, double* rate)
  {
    rate[0] = y[1];
    rate[1] = -y[0];
  };
  return problem;
}

/// y' = -(y - cos t) / T - sin t, whose solution from 1 is cos t.
OdeProblem make_stiff(const double relaxation_time)
{
  OdeProblem problem;
  problem.size = 1;
  problem.rate = [=](const double time, const double* y, double* rate)
  { rate[0] = -(y[0] - std::cos(time)) / relaxation_time - std::sin(time); };
  return problem;
}

/// y' = -1 / (2 y), which ends at t = 1 with y = sqrt(1 - t) = 0.
OdeProblem make_dead_end()
{
  OdeProblem problem;
  problem.size = 1;
  problem.rate = [](double, const double* y, double* rate)
  {
    if (!(y[0] > 0))
      throw StepRejected("the root has ended");
    rate[0] = -1 / (2 * y[0]);
  };
  return problem;
}

/// Watches the components of the state.
OdeEvents watch_components(const std::vector<bool>& fatal)
{
  OdeEvents events;
  events.fatal = fatal;
  events.values = [n = fatal.size()](double, const double* y, double* values)
  { std::copy(y, y + n, values); };
  return events;
}

double run_oscillator_error(const OdeMethod method, const double tolerance)
{
  State y = {1, 0};
  integrate_ode(make_oscillator(), {0, 6 * pi, {}},
                make_options(method, tolerance), {}, {}, y);
  return std::hypot(y[0] - 1, y[1]);
}
} // namespace

class OdeMethods : public testing::TestWithParam<OdeMethod>
{
};

INSTANTIATE_TEST_SUITE_P(All, OdeMethods,
                         testing::Values(OdeMethod::automatic,
                                         OdeMethod::explicit_runge_kutta,
                                         OdeMethod::implicit_bdf));

TEST_P(OdeMethods, ErrorFollowsTheTolerance)
{
  // Three periods of some hundred to thousand steps.
  EXPECT_LT(run_oscillator_error(GetParam(), 1e-6), 1e-3);
  EXPECT_LT(run_oscillator_error(GetParam(), 1e-10), 1e-7);
}

TEST_P(OdeMethods, OutputsAreAsAccurateAsTheSteps)
{
  State y = {1, 0};
  OdeSchedule schedule{0, 5, {-1, 0, 0.1, 0.7, 2, 4.999, 7}};
  std::vector<double> times;
  OdeObserver observer;
  observer.output = [&](const double time, const double* state)
  {
    times.push_back(time);
    EXPECT_NEAR(state[0], std::cos(time), 1e-8);
    EXPECT_NEAR(state[1], -std::sin(time), 1e-8);
  };
  integrate_ode(make_oscillator(), schedule, make_options(GetParam(), 1e-11),
                {}, observer, y);
  EXPECT_EQ(times, (std::vector<double>{0, 0.1, 0.7, 2, 4.999, 5}));
}

TEST_P(OdeMethods, OutputsDoNotChangeTheSteps)
{
  State plain = {1, 0}, observed = {1, 0};
  const auto options = make_options(GetParam(), 1e-8);
  OdeSchedule schedule{0, 5, {}};
  integrate_ode(make_oscillator(), schedule, options, {}, {}, plain);
  for (int i = 1; i < 100; ++i)
    schedule.output_times.push_back(0.05 * i);
  integrate_ode(make_oscillator(), schedule, options, {}, {}, observed);
  EXPECT_EQ(plain, observed);
}

TEST_P(OdeMethods, EventStopsTheRunAtItsTime)
{
  State y = {1, 0.5};
  std::vector<OdeEvent> seen;
  OdeObserver observer;
  observer.event = [&](const OdeEvent& event, const double*)
  { seen.push_back(event); };
  const auto result = integrate_ode(
      make_oscillator(), {0, 10, {}}, make_options(GetParam(), 1e-12),
      watch_components({true, false}), observer, y);
  // y = cos t + sin t / 2, y' = cos t / 2 - sin t.
  EXPECT_TRUE(result.stopped_by_event);
  EXPECT_NEAR(result.time, pi - std::atan(2.), 1e-10);
  EXPECT_NEAR(y[0], 0, 1e-14);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0].index, 1u);
  EXPECT_NEAR(seen[0].time, std::atan(0.5), 1e-10);
  EXPECT_EQ(seen[1].index, 0u);
}

TEST_P(OdeMethods, EventAtTheStartIsReportedButNotFatal)
{
  State y = {-1, 1};
  std::vector<OdeEvent> seen;
  OdeObserver observer;
  observer.event = [&](const OdeEvent& event, const double*)
  { seen.push_back(event); };
  // -cos t + sin t is negative, rises through zero and falls at 5 pi / 4.
  const auto result = integrate_ode(make_oscillator(), {0, 5, {}},
                                    make_options(GetParam(), 1e-11),
                                    watch_components({true}), observer, y);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_TRUE(seen[0].at_start);
  EXPECT_FALSE(seen[1].at_start);
  EXPECT_NEAR(result.time, 5 * pi / 4, 1e-9);
}

TEST_P(OdeMethods, JumpsAtStopTimesAreSeenFromBothSides)
{
  // y' = 1 before t = 1 and -3 after, with a jump of y by 10.
  double end_of_segment = 0;
  OdeProblem problem;
  problem.size = 1;
  problem.stop_times = {-1, 1, 9};
  problem.rate = [&](const double time, const double*, double* rate)
  {
    const bool before = time < 1 || (time == 1 && end_of_segment == 1);
    rate[0] = before ? 1 : -3;
  };
  problem.begin_segment = [&](const double begin, const double end, double* y)
  {
    end_of_segment = end;
    if (begin == 1)
      y[0] += 10;
  };
  State y = {0};
  std::vector<double> values;
  OdeObserver observer;
  observer.output = [&](double, const double* state)
  { values.push_back(state[0]); };
  integrate_ode(problem, {0, 3, {0.5, 1, 2}}, make_options(GetParam(), 1e-12),
                {}, observer, y);
  const std::vector<double> expected = {0, 0.5, 11, 8, 5};
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(values[i], expected[i], 1e-10);
}

TEST_P(OdeMethods, EventInAJumpHappensAtTheStopTime)
{
  OdeProblem problem = make_oscillator();
  problem.stop_times = {0.5};
  problem.begin_segment = [](const double begin, double, double* y)
  {
    if (begin == 0.5)
      y[0] = -y[0];
  };
  State y = {1, 0};
  const auto result =
      integrate_ode(problem, {0, 1, {}}, make_options(GetParam(), 1e-10),
                    watch_components({true}), {}, y);
  EXPECT_TRUE(result.stopped_by_event);
  EXPECT_EQ(result.time, 0.5);
}

TEST_P(OdeMethods, DeadEndIsFatalAndLeavesTheLastGoodState)
{
  State y = {1};
  double reached = 0;
  EXPECT_THROW(integrate_ode(make_dead_end(), {0, 2, {}},
                             make_options(GetParam(), 1e-8), {}, {}, y,
                             &reached),
               SolverFailed);
  EXPECT_GT(reached, 0.999);
  EXPECT_LT(reached, 1.001);
  // y^2 = 1 - t within the accumulated error.
  EXPECT_NEAR(y[0] * y[0], 1 - reached, 1e-4);
}

TEST_P(OdeMethods, ForeignErrorsOfTheRatePassThrough)
{
  OdeProblem problem = make_oscillator();
  problem.rate = [](const double time, const double*, double* rate)
  {
    if (time > 0.5)
      throw std::out_of_range("no data");
    rate[0] = rate[1] = 1;
  };
  State y = {0, 0};
  EXPECT_THROW(integrate_ode(problem, {0, 1, {}},
                             make_options(GetParam(), 1e-8), {}, {}, y),
               std::out_of_range);
}

TEST_P(OdeMethods, StateThatIsNotANumberIsFatal)
{
  OdeProblem problem = make_oscillator();
  problem.rate = [](const double time, const double*, double* rate)
  { rate[0] = rate[1] = std::sqrt(0.5 - time); };
  State y = {0, 0};
  EXPECT_THROW(integrate_ode(problem, {0, 1, {}},
                             make_options(GetParam(), 1e-8), {}, {}, y),
               SolverFailed);
}

TEST(Ode, AutomaticMethodCopesWithStiffness)
{
  // An explicit method needs 100 s / (3 T) = 3e6 steps.
  auto options = make_options(OdeMethod::explicit_runge_kutta, 1e-9);
  options.max_steps = 20000;
  State y = {1};
  EXPECT_THROW(
      integrate_ode(make_stiff(1e-5), {0, 100, {}}, options, {}, {}, y),
      SolverFailed);
  options.method = OdeMethod::automatic;
  y = {1};
  integrate_ode(make_stiff(1e-5), {0, 100, {}}, options, {}, {}, y);
  EXPECT_NEAR(y[0], std::cos(100.), 1e-7);
}

TEST(Ode, ValueThatDipsWithinAStepIsSeenByTheSamples)
{
  // y' = 0 makes one long step; the value is negative in its middle only.
  OdeProblem problem;
  problem.size = 1;
  problem.rate = [](double, const double*, double* rate) { rate[0] = 0; };
  OdeEvents events;
  events.fatal = {true};
  events.values = [](const double time, const double*, double* values)
  { values[0] = std::abs(time - 5) - 1; };
  auto options = make_options(OdeMethod::explicit_runge_kutta, 1e-6);
  options.largest_step = 10;
  options.samples_per_step = 9;
  State y = {1};
  const auto result =
      integrate_ode(problem, {0, 10, {}}, options, events, {}, y);
  EXPECT_TRUE(result.stopped_by_event);
  EXPECT_NEAR(result.time, 4, 1e-14);
}

TEST(Ode, EventsOfOneStepComeInOrderOfTime)
{
  OdeProblem problem;
  problem.size = 1;
  problem.rate = [](double, const double*, double* rate) { rate[0] = -1; };
  OdeEvents events;
  events.fatal = {false, false, true};
  events.values = [](double, const double* y, double* values)
  {
    values[0] = y[0] - 1;
    values[1] = y[0] - 2;
    values[2] = y[0] + 1;
  };
  std::vector<std::size_t> order;
  OdeObserver observer;
  observer.event = [&](const OdeEvent& event, const double*)
  { order.push_back(event.index); };
  State y = {10};
  const auto result = integrate_ode(
      problem, {0, 20, {}}, make_options(OdeMethod::explicit_runge_kutta, 1e-6),
      events, observer, y);
  EXPECT_EQ(order, (std::vector<std::size_t>{1, 0, 2}));
  EXPECT_NEAR(result.time, 11, 1e-12);
}

TEST(Ode, ExplicitMethodHasOrderFive)
{
  // The tolerance never interferes; after the first two, all steps have the
  // greatest length.
  const auto run = [](const double step)
  {
    auto options = make_options(OdeMethod::explicit_runge_kutta, 1e3);
    options.largest_step = step;
    State y = {1, 0};
    integrate_ode(make_oscillator(), {0, 4, {}}, options, {}, {}, y);
    return std::hypot(y[0] - std::cos(4.), y[1] + std::sin(4.));
  };
  const double order = std::log2(run(0.0625) / run(0.03125));
  EXPECT_NEAR(order, 5, 0.2);
}
