#include <taut/base/exceptions.h>
#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <cmath>

#include "oscillators.h"

using namespace taut;
using namespace taut::time;

namespace
{
// A standard solid under dead load: 0 = p - k u - kv (u - a), a' = (u - a)/tau.
constexpr double stiffness = 2, viscous_stiffness = 3, relaxation_time = .5;
constexpr double total = stiffness + viscous_stiffness;
constexpr double creep_time = relaxation_time * total / stiffness;

struct Exact
{
  double u, a;
};

/// `time` after the load began to act on a(0) = a_start.
Exact get_exact(const double load, const double a_start, const double time)
{
  const double end = load / stiffness;
  const double a = end + (a_start - end) * std::exp(-time / creep_time);
  return {(load + viscous_stiffness * a) / total, a};
}

Oscillators make_system(const double load)
{
  // Two equal members, so that two ranks have one each.
  const Oscillator member = {1,
                             stiffness,
                             viscous_stiffness,
                             relaxation_time,
                             0,
                             {{load / total, 0, 0}}};
  Oscillators system({member, member}, Oscillators::Kind::quasi_static,
                     MPI_COMM_WORLD);
  system.set_load({[=](double) { return load; }}, {});
  return system;
}

IntegratorOptions make_options(const double tolerance)
{
  IntegratorOptions options;
  options.method = Method::bdf;
  options.position_tolerance = options.internal_tolerance = tolerance;
  return options;
}

Schedule make_schedule(const double end)
{
  Schedule schedule;
  schedule.end = end;
  for (int i = 1; i < 50; ++i)
    schedule.output_times.push_back(end * i / 50);
  return schedule;
}
} // namespace

TEST(QuasiStatic, CreepMeetsTheExactSolution)
{
  Oscillators system = make_system(1);
  std::vector<double> state = system.make_start();
  const std::size_t n = system.n_members();
  int n_outputs = 0;
  Observer observer;
  observer.output = [&](const double time, const double* y)
  {
    ++n_outputs;
    // Some hundred local errors of 1e-11.
    EXPECT_NEAR(y[0], get_exact(1, 0, time).u, 1e-8);
    EXPECT_NEAR(y[n], get_exact(1, 0, time).a, 1e-8);
  };
  integrate(system, state.data(), make_schedule(10), make_options(1e-11), {},
            observer);
  EXPECT_EQ(n_outputs, 51);
}

TEST(QuasiStatic, WorkIsStoredOrDissipated)
{
  Oscillators system = make_system(1);
  std::vector<double> state = system.make_start();
  const auto compute_potential = [&](const double* y)
  {
    const std::size_t n = system.n_members();
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      sum += stiffness / 2 * y[i] * y[i] +
             viscous_stiffness / 2 * std::pow(y[i] - y[n + i], 2) - y[i];
    return system.sum(sum);
  };
  const double start = compute_potential(state.data());
  integrate(system, state.data(), make_schedule(10), make_options(1e-10), {},
            {});
  const double dissipated =
      system.sum(system.layout().scalars > 0 ? state.back() : 0);
  EXPECT_GT(dissipated, .1);
  // The scalar is not controlled; its rate is as accurate as u and a.
  EXPECT_NEAR(compute_potential(state.data()) + dissipated - start, 0, 1e-6);
}

TEST(QuasiStatic, FindsTheEquilibriumAfterAJump)
{
  Oscillators system = make_system(0);
  system.set_load({[](double) { return 0.; }, [](double) { return 1.; }}, {2});
  std::vector<double> state = system.make_start();
  const std::size_t n = system.n_members();
  int n_outputs = 0;
  Observer observer;
  observer.output = [&](const double time, const double* y)
  {
    ++n_outputs;
    const Exact exact = time <= 2 ? Exact{0, 0} : get_exact(1, 0, time - 2);
    EXPECT_NEAR(y[0], exact.u, 1e-8);
    EXPECT_NEAR(y[n], exact.a, 1e-8);
  };
  integrate(system, state.data(), make_schedule(4.1), make_options(1e-11), {},
            observer);
  EXPECT_EQ(n_outputs, 51);
}

TEST(QuasiStatic, InternalToleranceControlsTheError)
{
  // Positions weigh almost nothing here: what remains is the internal control.
  double errors[2];
  for (const int i : {0, 1})
  {
    Oscillators system = make_system(1);
    std::vector<double> state = system.make_start();
    IntegratorOptions options = make_options(i == 0 ? 1e-4 : 1e-8);
    options.position_tolerance = 1e6;
    integrate(system, state.data(), make_schedule(1), options, {}, {});
    errors[i] = std::abs(state[system.n_members()] - get_exact(1, 0, 1).a);
  }
  EXPECT_LT(errors[0], 1e-2);
  EXPECT_LT(errors[1], 1e-6);
}

TEST(QuasiStatic, RefusesAMethodThatNeedsVelocities)
{
  Oscillators system = make_system(1);
  std::vector<double> state = system.make_start();
  EXPECT_THROW(integrate(system, state.data(), make_schedule(1), {}, {}, {}),
               BadInput);
}
