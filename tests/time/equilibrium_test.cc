#include <taut/base/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>

#include "scalar_problem.h"

using namespace taut;
using namespace taut::time;

namespace
{
/// x^3 = 8.
ScalarProblem make_cube()
{
  return ScalarProblem([](double, const double x) { return x * x * x - 8; },
                       [](double, const double x) { return 3 * x * x; }, 8);
}

std::string get_rejection(ScalarProblem& problem, const double start,
                          const EquilibriumOptions& options = {})
{
  double x = start;
  try
  {
    find_equilibrium(problem, 0, &x, options);
  }
  catch (const StepRejected& rejection)
  {
    EXPECT_EQ(x, start) << "overwritten without success";
    return rejection.what();
  }
  return "";
}
/// x_i + x_i^3 = i + 1, ten unknowns on each rank.
class Cubics : public EquilibriumProblem
{
public:
  static constexpr std::size_t n = 10;
  MPI_Comm communicator() const override
  {
    return MPI_COMM_WORLD;
  }
  std::size_t n_unknowns() const override
  {
    return n;
  }
  void compute_residual(double, const double* u, double* r) override
  {
    for (std::size_t i = 0; i < n; ++i)
      r[i] = u[i] + u[i] * u[i] * u[i] - double(i + 1);
  }
  void prepare(double, const double* u) override
  {
    for (std::size_t i = 0; i < n; ++i)
      slopes[i] = 1 + 3 * u[i] * u[i];
  }
  void solve(const double* r, double* d) override
  {
    for (std::size_t i = 0; i < n; ++i)
      d[i] = r[i] / slopes[i];
  }
  double reference_force() const override
  {
    return 10;
  }

private:
  std::vector<double> slopes = std::vector<double>(n);
};
} // namespace

TEST(Equilibrium, CubeRoot)
{
  ScalarProblem problem = make_cube();
  double x = 1;
  const EquilibriumStatistics statistics = find_equilibrium(problem, 0, &x, {});
  // Residual below 1e-10 * 8 N at a slope of 12 N/m.
  EXPECT_NEAR(x, 2, 1e-10);
  EXPECT_LE(statistics.final_residual, 8e-10);
  EXPECT_EQ(statistics.factorisations, statistics.iterations);
}

TEST(Equilibrium, AlreadyThereCostsNoFactorisation)
{
  ScalarProblem problem = make_cube();
  double x = 2;
  EXPECT_EQ(find_equilibrium(problem, 0, &x, {}).factorisations, 0u);
  EXPECT_EQ(x, 2);
}

TEST(Equilibrium, RoundOffIsNotAFailure)
{
  // The root of x^3 = 7 is no floating-point number: the residual stays above
  // 1e-16 of the force.
  ScalarProblem problem([](double, const double x) { return x * x * x - 7; },
                        [](double, const double x) { return 3 * x * x; }, 7);
  EquilibriumOptions options;
  options.tolerance = 1e-20;
  double x = 1;
  find_equilibrium(problem, 0, &x, options);
  EXPECT_NEAR(x, std::cbrt(7.), 1e-13);
}

TEST(Equilibrium, ThereIsNone)
{
  ScalarProblem problem([](double, const double x) { return x * x + 1; },
                        [](double, const double x) { return 2 * x; }, 1);
  EXPECT_NE(get_rejection(problem, 1).find("residual 1"), std::string::npos);
}

TEST(Equilibrium, TooFewIterations)
{
  ScalarProblem problem = make_cube();
  EquilibriumOptions options;
  options.max_iterations = 2;
  EXPECT_NE(get_rejection(problem, 100, options).find("MAXITER"),
            std::string::npos);
}

TEST(Equilibrium, LineSearchAvoidsInadmissibleStates)
{
  // Newton from 10 goes to 10 - 10 (ln 10 - 1) = -3.03, where there is no
  // logarithm.
  int n_rejected = 0;
  ScalarProblem problem(
      [&](double, const double x)
      {
        n_rejected += x <= 0;
        if (x <= 0)
          throw StepRejected("a stretch is negative");
        return std::log(x) - 1;
      },
      [](double, const double x) { return 1 / x; }, 1);
  double x = 10;
  find_equilibrium(problem, 0, &x, {});
  EXPECT_GT(n_rejected, 0);
  EXPECT_NEAR(x, std::exp(1.), 1e-9);
}

TEST(Equilibrium, InadmissibleWhereverItGoes)
{
  ScalarProblem problem(
      [](double, const double x)
      {
        if (x != 1)
          throw StepRejected("turned inside out");
        return 1.;
      },
      [](double, double) { return 1.; }, 1);
  EXPECT_NE(get_rejection(problem, 1).find("turned inside out"),
            std::string::npos);
}

TEST(Equilibrium, StartIsInadmissible)
{
  ScalarProblem problem([](double, double) -> double
                        { throw StepRejected("not even here"); },
                        [](double, double) { return 1.; }, 1);
  EXPECT_NE(get_rejection(problem, 1).find("not even here"), std::string::npos);
}

TEST(Equilibrium, ResidualIsNotANumber)
{
  ScalarProblem problem([](double, const double x) { return std::sqrt(x); },
                        [](double, double) { return 1.; }, 1);
  EXPECT_NE(get_rejection(problem, -1).find("finite"), std::string::npos);
}

TEST(Equilibrium, SingularTangent)
{
  ScalarProblem problem = make_cube();
  EXPECT_NE(get_rejection(problem, 0).find("singular"), std::string::npos);
}

TEST(Equilibrium, RejectedFactorisation)
{
  ScalarProblem problem(
      [](double, const double x) { return x - 1; },
      [](double, double) -> double { throw StepRejected("no factors"); }, 1);
  EXPECT_NE(get_rejection(problem, 0).find("no factors"), std::string::npos);
}

TEST(Equilibrium, FailureOfTheSystemPropagates)
{
  ScalarProblem problem([](double, double) -> double
                        { throw SolverFailed("out of memory"); },
                        [](double, double) { return 1.; }, 1);
  double x = 0;
  EXPECT_THROW(find_equilibrium(problem, 0, &x, {}), SolverFailed);
}

TEST(Equilibrium, StepsAreLimited)
{
  ScalarProblem problem = make_cube();
  EquilibriumOptions options;
  options.max_step = .1;
  double x = 4;
  find_equilibrium(problem, 0, &x, options);
  EXPECT_NEAR(x, 2, 1e-10);
  EXPECT_GT(problem.longest_step, .09);
  EXPECT_LT(problem.longest_step, .1 + 1e-12);
}

TEST(Equilibrium, OfManyUnknownsOnAllRanks)
{
  Cubics problem;
  std::vector<double> u(Cubics::n, 0.);
  find_equilibrium(problem, 0, u.data(), {});
  for (std::size_t i = 0; i < Cubics::n; ++i)
    EXPECT_NEAR(u[i] + u[i] * u[i] * u[i], double(i + 1), 1e-9);
}
