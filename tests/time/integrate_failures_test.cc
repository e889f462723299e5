#include <taut/base/exceptions.h>
#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "oscillators.h"

using namespace taut;
using namespace taut::time;

namespace
{
struct Attempt
{
  std::string message;
  double reached = -1;
  std::vector<double> state;
  /// Displacement of the exact solution at `reached`.
  double exact = 0;
};

const std::vector<Oscillator>
    members(2, Oscillator{1, 4e4, 1e4, .01, 0, {{1e-3, 0, 0}}});

template <class Spoil>
Attempt attempt(const Method method, const Spoil& spoil,
                IntegratorOptions options = {})
{
  Oscillators system(members, Oscillators::Kind::inertial, MPI_COMM_WORLD);
  spoil(system);
  Attempt attempt;
  attempt.state = system.make_start();
  options.method = method;
  options.position_tolerance = 1e-9;
  Schedule schedule;
  schedule.end = .1;
  try
  {
    integrate(system, attempt.state.data(), schedule, options, {}, {},
              &attempt.reached);
  }
  catch (const SolverFailed& failure)
  {
    attempt.message = failure.what();
  }
  attempt.exact = system.get_exact(0, attempt.reached)[0];
  return attempt;
}
} // namespace

class Failures : public testing::TestWithParam<Method>
{
};

TEST_P(Failures, ABarrierIsReachedAndNamed)
{
  const Attempt failed = attempt(GetParam(),
                                 [](Oscillators& system)
                                 {
                                   system.after_evaluate = [](const double time)
                                   {
                                     if (time > .0321)
                                       throw StepRejected("beyond the barrier");
                                   };
                                 });
  EXPECT_NE(failed.message.find("beyond the barrier"), std::string::npos);
  EXPECT_NE(failed.message.find("0.0321"), std::string::npos) << failed.message;
  EXPECT_LE(failed.reached, .0321);
  EXPECT_NEAR(failed.reached, .0321, 1e-5);
  // The last good state: the solution at the time reached.
  EXPECT_NEAR(failed.state[0], failed.exact, 1e-6);
}

TEST_P(Failures, RejectionByOneRankIsSeenByAll)
{
  const Attempt failed = attempt(GetParam(),
                                 [](Oscillators& system)
                                 {
                                   if (system.layout().scalars > 0)
                                     system.after_evaluate = [](const double t)
                                     {
                                       if (t > .01)
                                         throw StepRejected("only rank 0");
                                     };
                                 });
  EXPECT_NE(failed.message.find("only rank 0"), std::string::npos);
}

TEST_P(Failures, FailureOfOneRankEndsAll)
{
  // The other ranks learn the reason as a SolverFailed.
  const auto fail_on_rank_0 = [](Oscillators& system)
  {
    if (system.layout().scalars > 0)
      system.after_evaluate = [](const double t)
      {
        if (t > .01)
          throw SolverFailed("broken on rank 0");
      };
  };
  EXPECT_EQ(attempt(GetParam(), fail_on_rank_0).message, "broken on rank 0");
}

TEST_P(Failures, FirstEvaluationRejected)
{
  const Attempt failed = attempt(
      GetParam(), [](Oscillators& system)
      { system.after_evaluate = [](double) { throw StepRejected("never"); }; });
  EXPECT_NE(failed.message.find("never"), std::string::npos);
  EXPECT_EQ(failed.reached, 0);
  EXPECT_EQ(failed.state[0], 1e-3);
}

TEST_P(Failures, NotANumberIsRejected)
{
  const Attempt failed =
      attempt(GetParam(),
              [](Oscillators& system)
              {
                system.set_load({[](const double time) {
                                  return time > .02 ? std::sqrt(-time) : 0.;
                                }},
                                {});
              });
  EXPECT_NE(failed.message.find("not a finite number"), std::string::npos);
  EXPECT_NEAR(failed.state[0], failed.exact, 1e-6);
}

TEST_P(Failures, AnythingElsePropagates)
{
  EXPECT_THROW(attempt(GetParam(),
                       [](Oscillators& system)
                       {
                         system.after_evaluate = [](const double time)
                         {
                           if (time > .01)
                             throw std::logic_error("a bug");
                         };
                       }),
               std::logic_error);
}

TEST_P(Failures, NewtonThatNeverConverges)
{
  const Attempt failed = attempt(GetParam(), [](Oscillators& system)
                                 { system.has_wrong_tangent = true; });
  EXPECT_FALSE(failed.message.empty());
  EXPECT_EQ(failed.reached, 0);
}

TEST_P(Failures, TooManySteps)
{
  IntegratorOptions options;
  options.max_steps = 7;
  const Attempt failed = attempt(
      GetParam(), [](Oscillators&) {}, options);
  EXPECT_NE(failed.message.find("number of steps"), std::string::npos);
  EXPECT_GT(failed.reached, 0);
  EXPECT_NEAR(failed.state[0], failed.exact, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Methods, Failures,
                         testing::Values(Method::esdirk4, Method::esdirk3,
                                         Method::bdf));

TEST(FailuresOfObservers, Propagate)
{
  Oscillators system(members, Oscillators::Kind::inertial, MPI_COMM_WORLD);
  std::vector<double> state = system.make_start();
  Schedule schedule;
  schedule.end = .1;
  Observer observer;
  observer.step = [](const Step& step, const IntegratorStatistics&)
  {
    if (step.end() > .01)
      throw std::logic_error("disk full");
  };
  double reached = 0;
  EXPECT_THROW(
      integrate(system, state.data(), schedule, {}, {}, observer, &reached),
      std::logic_error);
  EXPECT_GT(reached, .01);
}

TEST(FailuresOfLayouts, VelocitiesThatDoNotMatchPositions)
{
  struct Wrong : Oscillators
  {
    using Oscillators::Oscillators;
    StateLayout layout() const override
    {
      StateLayout layout = Oscillators::layout();
      ++layout.velocities;
      return layout;
    }
  } system(members, Oscillators::Kind::inertial);
  std::vector<double> state(system.layout().size());
  Schedule schedule;
  schedule.end = 1;
  EXPECT_THROW(integrate(system, state.data(), schedule, {}, {}, {}),
               std::logic_error);
}
