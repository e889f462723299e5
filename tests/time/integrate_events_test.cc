#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <cmath>

#include "oscillators.h"

using namespace taut::time;

namespace
{
const double period = .02;
const double k = std::pow(2 * M_PI / period, 2);

/// u = cos(2 pi t / period).
Oscillators make_swing()
{
  return Oscillators({{1, k, 0, 1, 0, {{1, 0, 0}}}},
                     Oscillators::Kind::inertial);
}

Watch watch_position(const double level, const bool fatal = false)
{
  return {"position",
          [=](const double, const double* y) { return y[0] - level; }, fatal};
}

struct Record
{
  std::vector<Event> events;
  std::vector<double> positions;
  std::vector<double> outputs;
  double last_output_position = 0;
  RunResult result;
  std::vector<double> state;
};

Record run(Oscillators& system, const Schedule& schedule,
           const IntegratorOptions& options, const std::vector<Watch>& watches)
{
  Record record;
  record.state = system.make_start();
  Observer observer;
  observer.event = [&](const Event& event, const double* y)
  {
    record.events.push_back(event);
    record.positions.push_back(y[0]);
  };
  observer.output = [&](const double time, const double* y)
  {
    record.outputs.push_back(time);
    record.last_output_position = y[0];
  };
  record.result = integrate(system, record.state.data(), schedule, options,
                            watches, observer);
  return record;
}

Record swing(const std::vector<Watch>& watches, const double tolerance,
             const double end = .5 * period)
{
  Oscillators system = make_swing();
  Schedule schedule;
  schedule.end = end;
  for (int i = 1; i <= 100; ++i)
    schedule.output_times.push_back(end * i / 100);
  IntegratorOptions options;
  options.position_tolerance = tolerance;
  return run(system, schedule, options, watches);
}
} // namespace

TEST(Events, TimeMeetsTheExactRoot)
{
  // Order 4 of method and dense output: at this tolerance the steps are about
  // 1e-3 of a radian, where both errors are below 1e-12.
  const Record record = swing({watch_position(0)}, 1e-14);
  ASSERT_EQ(record.events.size(), 1u);
  EXPECT_NEAR(record.events[0].time / (period / 4), 1, 1e-10);
  EXPECT_FALSE(record.events[0].at_start);
}

TEST(Events, AreRootsOfTheDenseOutput)
{
  // Long steps: the root is that of the interpolant to round-off.
  const Record record = swing({watch_position(.3)}, 1e-5);
  ASSERT_EQ(record.positions.size(), 1u);
  // 1e-14 of the time at a slope of 2 pi / period.
  EXPECT_NEAR(record.positions[0], .3, 1e-13);
  EXPECT_EQ(record.result.outcome, Outcome::completed);
}

TEST(Events, OfOneStepComeInOrderOfTime)
{
  const Record record = swing(
      {watch_position(-.01), watch_position(.01), watch_position(0)}, 1e-4);
  ASSERT_EQ(record.events.size(), 3u);
  EXPECT_EQ(record.events[0].watch, 1u);
  EXPECT_EQ(record.events[1].watch, 2u);
  EXPECT_EQ(record.events[2].watch, 0u);
  EXPECT_LT(record.events[0].time, record.events[1].time);
  EXPECT_LT(record.events[1].time, record.events[2].time);
}

TEST(Events, AWatchIsArmedAgainOnceItIsPositive)
{
  const Record record = swing({watch_position(0)}, 1e-9, 3 * period);
  ASSERT_EQ(record.events.size(), 3u);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(record.events[i].time / period, i + .25, 1e-6);
}

TEST(Events, AWatchThatHoversIsHeardOnce)
{
  // u falls through .95 of its amplitude and comes back to it; it recovers to
  // .04 above that once in a period, to .06 never.
  const auto count = [](const double recovered)
  {
    Watch watch = watch_position(.95);
    watch.recovered = recovered;
    return swing({watch}, 1e-9, 2.5 * period).events.size();
  };
  EXPECT_EQ(count(.04), 3u);
  EXPECT_EQ(count(.06), 1u);
}

TEST(Events, AWatchThatFiredBeforeTheRunFiresOnceItHasRecovered)
{
  // u starts at 1, .05 above the level, and falls through it after .05 periods.
  const auto count = [](const double recovered, const bool is_armed)
  {
    Watch watch = watch_position(.95);
    watch.recovered = recovered;
    watch.is_armed = is_armed;
    return swing({watch}, 1e-9, 1.5 * period).events.size();
  };
  EXPECT_EQ(count(.06, true), 1u);
  EXPECT_EQ(count(.06, false), 0u);
  EXPECT_EQ(count(.04, false), 2u);
}

TEST(Events, TheRunKnowsWhichWatchesAreArmed)
{
  Oscillators system = make_swing();
  auto state = system.make_start();
  Schedule schedule;
  schedule.end = .1 * period;
  IntegratorOptions options;
  options.position_tolerance = 1e-9;
  std::vector<bool> armed;
  Observer observer;
  observer.armed = [&](const std::vector<bool>& now) { armed = now; };
  integrate(system, state.data(), schedule, options,
            {watch_position(.95), watch_position(-.5)}, observer);
  EXPECT_EQ(armed, (std::vector<bool>{false, true}));
}

TEST(Events, NegativeAtTheStartIsReportedOnce)
{
  const Record record = swing({watch_position(1.5)}, 1e-7, period);
  ASSERT_EQ(record.events.size(), 1u);
  EXPECT_TRUE(record.events[0].at_start);
  EXPECT_EQ(record.events[0].time, 0);
  EXPECT_EQ(record.result.outcome, Outcome::completed);
}

TEST(Events, FatalAtTheStartEndsTheRunAtOnce)
{
  const Record record =
      swing({watch_position(1.5, true), watch_position(1.4)}, 1e-7);
  ASSERT_EQ(record.events.size(), 1u);
  EXPECT_EQ(record.result.outcome, Outcome::stopped_by_event);
  EXPECT_EQ(record.result.time, 0);
  EXPECT_EQ(record.result.statistics.steps, 0);
  EXPECT_EQ(record.outputs, std::vector<double>({0}));
}

TEST(Events, FatalEndsTheRunAtTheEvent)
{
  const Record record = swing(
      {watch_position(.3, true), watch_position(.29), watch_position(.31)},
      1e-5);
  // The watch that fires later in the same step is not heard.
  ASSERT_EQ(record.events.size(), 2u);
  EXPECT_EQ(record.events[0].watch, 2u);
  EXPECT_EQ(record.events[1].watch, 0u);
  EXPECT_EQ(record.result.outcome, Outcome::stopped_by_event);
  EXPECT_EQ(record.result.time, record.events[1].time);
  EXPECT_NEAR(record.state[0], .3, 1e-13);
  // v of the interpolated state, consistent to order 3 of steps of .1 rad.
  EXPECT_NEAR(record.state[1] * period / (2 * M_PI), -std::sqrt(1 - .09), 1e-3);
  EXPECT_EQ(record.outputs.back(), record.result.time);
  EXPECT_EQ(record.last_output_position, record.state[0]);
  for (std::size_t i = 1; i < record.outputs.size(); ++i)
    EXPECT_LT(record.outputs[i - 1], record.outputs[i]);
}

namespace
{
/// Creep u(t) of a standard solid under a load that comes at time 1.
Oscillators make_creep()
{
  Oscillators system({{1, 2, 3, .5, 0, {{0, 0, 0}}}},
                     Oscillators::Kind::quasi_static);
  system.set_load({[](double) { return 0.; }, [](double) { return 1.; }}, {1});
  return system;
}

Watch watch_height(const double level)
{
  return {"height", [=](const double, const double* y) { return level - y[0]; },
          true};
}

Record creep(const double level)
{
  Oscillators system = make_creep();
  Schedule schedule;
  schedule.end = 10;
  schedule.output_times = {1, 2};
  IntegratorOptions options;
  options.method = Method::bdf;
  options.position_tolerance = options.internal_tolerance = 1e-13;
  options.largest_step = .01;
  return run(system, schedule, options, {watch_height(level)});
}
} // namespace

TEST(Events, OfAQuasiStaticRunMeetTheExactRoot)
{
  // u = .2 + .6 a, a = .5 (1 - exp(-t/1.25)); u = .4 at exp = 1/3.
  const Record record = creep(.4);
  ASSERT_EQ(record.events.size(), 1u);
  EXPECT_NEAR(record.events[0].time, 1 + 1.25 * std::log(3.), 1e-10);
  EXPECT_EQ(record.outputs.back(), record.result.time);
  EXPECT_NEAR(record.state[0], .4, 1e-13);
}

TEST(Events, AJumpOfTheLoadFiresAtItsTime)
{
  // The load lifts u from 0 to .2 at once.
  const Record record = creep(.1);
  ASSERT_EQ(record.events.size(), 1u);
  EXPECT_EQ(record.events[0].time, 1);
  EXPECT_FALSE(record.events[0].at_start);
  EXPECT_NEAR(record.positions[0], .2, 1e-15);
  // Before and after the jump.
  EXPECT_EQ(record.outputs, std::vector<double>({0, 1, 1}));
  EXPECT_NEAR(record.last_output_position, .2, 1e-15);
}
