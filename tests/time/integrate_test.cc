#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <cmath>

#include "oscillators.h"

using namespace taut;
using namespace taut::time;

namespace
{
/// Three members with relaxation times far below, near and far above the
/// period, and one with a frequency a thousand times higher, which is at rest.
std::vector<Oscillator> make_members()
{
  const double k = std::pow(2 * M_PI * 50, 2);
  return {{1, k, .3 * k, 1e-2, 0, {{1e-3, 0, 1e-3}}},
          {2, 3 * k, .5 * k, 1, 2., {{0, .2, 0}}},
          {1, 1.5 * k, .2 * k, 1e-4, 0, {{5e-4, .1, 0}}},
          {1, 1e6 * k, 0, 1, 0, {{0, 0, 0}}}};
}

IntegratorOptions make_options(const double tolerance,
                               const Method method = Method::esdirk4)
{
  IntegratorOptions options;
  options.method = method;
  options.position_tolerance = tolerance;
  options.first_step = 1e-7;
  return options;
}

struct Accuracy
{
  double error = 0;
  RunResult result;
};

/// Largest error of a displacement at the end, over its initial amplitude.
Accuracy measure(const Method method, const double tolerance)
{
  Oscillators system(make_members(), Oscillators::Kind::inertial,
                     MPI_COMM_WORLD);
  std::vector<double> state = system.make_start();
  Schedule schedule;
  schedule.end = .1;
  Accuracy accuracy;
  accuracy.result = integrate(system, state.data(), schedule,
                              make_options(tolerance, method), {}, {});
  double sum = 0;
  for (std::size_t i = 0; i < system.n_members(); ++i)
    sum += std::pow(state[i] - system.get_exact(i, .1)[0], 2);
  accuracy.error = std::sqrt(system.sum(sum)) / 1e-3;
  return accuracy;
}

TEST(Integrate, Smoke)
{
  for (const Method method : {Method::esdirk4, Method::esdirk3, Method::bdf})
    for (const double tolerance : {1e-8, 1e-9, 1e-10})
    {
      const Accuracy a = measure(method, tolerance);
      printf("%d %g: err %g steps %ld rej %ld ncf %ld ev %ld fac %ld sol %ld "
             "nni %ld\n",
             int(method), tolerance, a.error, a.result.statistics.steps,
             a.result.statistics.rejected_by_error,
             a.result.statistics.rejected_by_newton,
             a.result.statistics.evaluations,
             a.result.statistics.factorisations, a.result.statistics.solves,
             a.result.statistics.newton_iterations);
    }
}
} // namespace
