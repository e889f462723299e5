#include <taut/base/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scalar_problem.h"

using namespace taut;
using namespace taut::time;

namespace
{
/// A hardening spring, x + x^3 = load.
ScalarProblem make_spring()
{
  return ScalarProblem([](const double load, const double x)
                       { return x + x * x * x - load; },
                       [](double, const double x) { return 1 + 3 * x * x; }, 1);
}
} // namespace

TEST(EquilibriumPath, EveryAcceptedPointIsAnEquilibrium)
{
  for (const double end : {10., -10.})
  {
    ScalarProblem problem = make_spring();
    double x = 0;
    std::vector<double> loads;
    PathOptions options;
    options.first_step = .01;
    options.largest_step = 3;
    follow_path(problem, 0, end, &x, options,
                [&](const double load, const double* u)
                {
                  EXPECT_NEAR(u[0] + u[0] * u[0] * u[0], load, 1e-9);
                  loads.push_back(load);
                });
    EXPECT_EQ(loads.back(), end);
    EXPECT_NEAR(x, std::copysign(2., end), 1e-9);
    EXPECT_DOUBLE_EQ(std::abs(loads.front()), .01);
    for (std::size_t i = 1; i < loads.size(); ++i)
    {
      EXPECT_GT(std::abs(loads[i]), std::abs(loads[i - 1]));
      EXPECT_LE(std::abs(loads[i] - loads[i - 1]), 3 + 1e-12);
    }
  }
}

TEST(EquilibriumPath, CutsBackWhereAStepIsTooLong)
{
  // Admissible only within .3 of the last equilibrium.
  double last = 0;
  int n_rejected = 0;
  ScalarProblem problem(
      [&](const double load, const double x)
      {
        if (std::abs(x - last) > .3)
        {
          ++n_rejected;
          throw StepRejected("too far");
        }
        return x + x * x * x - load;
      },
      [](double, const double x) { return 1 + 3 * x * x; }, 1);
  double x = 0;
  PathOptions options;
  options.first_step = options.largest_step = 10;
  options.smallest_step = 1e-3;
  follow_path(problem, 0, 10, &x, options,
              [&](double, const double* u) { last = u[0]; });
  EXPECT_GT(n_rejected, 0);
  EXPECT_NEAR(x, 2, 1e-9);
}

TEST(EquilibriumPath, GivesUpAtAFold)
{
  // x^2 - 2 x + load = 0: x = 1 - sqrt(1 - load) up to load 1.
  ScalarProblem problem([](const double load, const double x)
                        { return load - x * (2 - x); },
                        [](double, const double x) { return 2 * x - 2; }, 1);
  double x = 0, last_load = 0;
  PathOptions options;
  options.first_step = options.largest_step = .3;
  options.smallest_step = 1e-6;
  std::string message;
  try
  {
    follow_path(problem, 0, 2, &x, options,
                [&](const double load, const double*) { last_load = load; });
  }
  catch (const SolverFailed& failure)
  {
    message = failure.what();
  }
  EXPECT_NE(message.find("no equilibrium"), std::string::npos);
  EXPECT_LE(last_load, 1 + 1e-9);
  // Halving the step finds the fold to a few smallest steps.
  EXPECT_NEAR(last_load, 1, 1e-5);
  // u is the last good state: the residual is quadratic in the distance from
  // the fold, so x is known only to the root of its tolerance there.
  EXPECT_NEAR(x, 1 - std::sqrt(std::max(0., 1 - last_load)), 2e-5);
}

TEST(EquilibriumPath, OtherFailuresPropagate)
{
  ScalarProblem problem = make_spring();
  double x = 0;
  EXPECT_THROW(follow_path(problem, 0, 1, &x, {},
                           [](double, const double*)
                           { throw StepRejected("by the caller"); }),
               StepRejected);
  ScalarProblem broken([](double, double) -> double
                       { throw std::logic_error("a bug"); },
                       [](double, double) { return 1.; }, 1);
  EXPECT_THROW(follow_path(broken, 0, 1, &x, {}, [](double, const double*) {}),
               std::logic_error);
}

TEST(EquilibriumPath, RefusesStepsThatAreNotPositive)
{
  for (double PathOptions::*step :
       {&PathOptions::first_step, &PathOptions::smallest_step,
        &PathOptions::largest_step})
  {
    ScalarProblem problem = make_spring();
    double x = 0;
    PathOptions options;
    options.*step = 0;
    EXPECT_THROW(
        follow_path(problem, 0, 1, &x, options, [](double, const double*) {}),
        BadInput);
  }
}
