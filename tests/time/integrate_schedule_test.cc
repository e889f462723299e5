#include <gtest/gtest.h>

#include <cmath>

#include "members.h"

using namespace taut::time;

TEST(IntegrateSchedule, OutputAndEventsNeverChangeTheSteps)
{
  std::vector<double> states[2];
  long steps[2];
  for (const int many : {0, 1})
  {
    Oscillators system = make_system();
    states[many] = system.make_start();
    std::vector<Watch> watches;
    if (many)
      watches.push_back({"time", [](const double time, const double*)
                         { return .0123 - time; }});
    steps[many] = integrate(system, states[many].data(),
                            make_schedule(.05, many ? 1000 : 1),
                            make_options(1e-9), watches, {})
                      .statistics.steps;
  }
  EXPECT_EQ(steps[0], steps[1]);
  EXPECT_EQ(states[0], states[1]);
}

TEST(IntegrateSchedule, OutputsAreMadeOnceAtTheTimesAsked)
{
  Oscillators system = make_system();
  std::vector<double> state = system.make_start();
  Schedule schedule = make_schedule(.01, 7);
  schedule.output_times.insert(schedule.output_times.begin(), {-1, 0});
  schedule.output_times.push_back(.02);
  std::vector<double> times;
  Observer observer;
  observer.output = [&](const double time, const double*)
  { times.push_back(time); };
  integrate(system, state.data(), schedule, make_options(1e-8), {}, observer);
  ASSERT_EQ(times.size(), 8u);
  EXPECT_EQ(times.front(), 0);
  for (int i = 1; i <= 7; ++i)
    EXPECT_DOUBLE_EQ(times[i], .01 * i / 7);
}

TEST(IntegrateSchedule, StopsExactlyAtAJumpOfTheLoad)
{
  const double jump = .0123, load = 10, omega = std::sqrt(k);
  Oscillators system({{1, k, 0, 1, 0, {{0, 0, 0}}}},
                     Oscillators::Kind::inertial);
  system.set_load({[](double) { return 0.; }, [=](double) { return load; }},
                  {jump});
  std::vector<double> state = system.make_start();
  Schedule schedule = make_schedule(.05);
  // The same time but for round-off: one stop.
  schedule.restart_times = {jump * (1 + 1e-14)};
  int n_ends_at_jump = 0, n_checkpoints = 0;
  Observer observer;
  observer.step = [&](const Step& step, const IntegratorStatistics&)
  {
    EXPECT_TRUE(step.end() <= jump || step.start() >= jump);
    n_ends_at_jump += step.end() == jump;
  };
  observer.checkpoint = [&](const double time, const double*)
  {
    EXPECT_EQ(time, jump);
    ++n_checkpoints;
  };
  integrate(system, state.data(), schedule, make_options(1e-10), {}, observer);
  EXPECT_EQ(n_ends_at_jump, 1);
  EXPECT_EQ(n_checkpoints, 1);
  EXPECT_EQ(system.piece, 1u);
  const double exact = load / k * (1 - std::cos(omega * (.05 - jump)));
  // A hundred steps with local errors of the tolerance.
  EXPECT_NEAR(state[0], exact, 100 * 1e-10);
}

TEST(IntegrateSchedule, ResumedRunEqualsTheWholeRun)
{
  for (const Method method : {Method::esdirk4, Method::bdf})
    for (const bool by_steps : {false, true})
    {
      Oscillators system = make_system();
      std::vector<double> whole = system.make_start();
      Schedule schedule = make_schedule(.05);
      if (by_steps)
        schedule.restart_every_steps = 37;
      else
        schedule.restart_times = {.0171, .03};
      double saved_time = 0;
      std::vector<double> saved;
      Observer observer;
      observer.checkpoint = [&](const double time, const double* state)
      {
        if (saved.empty())
          saved.assign(state, state + whole.size());
        if (saved_time == 0)
          saved_time = time;
      };
      integrate(system, whole.data(), schedule, make_options(1e-9, method), {},
                observer);
      ASSERT_FALSE(saved_time == 0);
      schedule.start = saved_time;
      integrate(system, saved.data(), schedule, make_options(1e-9, method), {},
                {});
      // The same operations in the same order: equal to the last digit.
      EXPECT_EQ(saved, whole);
    }
}

TEST(IntegrateSchedule, InterruptionEndsInGoodOrder)
{
  Oscillators system = make_system();
  std::vector<double> state = system.make_start();
  int n_steps = 0;
  double last_output = 0, last_step = 0;
  Observer observer;
  observer.step = [&](const Step& step, const IntegratorStatistics&)
  {
    ++n_steps;
    last_step = step.end();
  };
  observer.interrupted = [&] { return n_steps == 20; };
  observer.output = [&](const double time, const double*)
  { last_output = time; };
  const RunResult result = integrate(system, state.data(), make_schedule(.1),
                                     make_options(1e-9), {}, observer);
  EXPECT_EQ(result.outcome, Outcome::interrupted);
  EXPECT_EQ(n_steps, 20);
  EXPECT_EQ(result.time, last_step);
  EXPECT_EQ(result.time, last_output);
  EXPECT_LT(compute_error(system, result.time, state.data(), 0), 1e-6);
}
