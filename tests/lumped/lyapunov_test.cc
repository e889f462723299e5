#include <taut/base/exceptions.h>
#include <taut/lumped/demes_run.h>
#include <taut/lumped/lyapunov.h>
#include <taut/time/ode.h>

#include <gtest/gtest.h>

#include <cmath>

namespace taut::lumped
{
namespace
{
using Rate = std::function<void(double, const double*, double*)>;

Flow make_flow(const Rate& rate)
{
  return [rate](std::vector<double> state, const double begin, const double end)
  {
    time::OdeProblem problem;
    problem.size = state.size();
    problem.rate = rate;
    time::OdeOptions options;
    options.method = time::OdeMethod::explicit_runge_kutta;
    options.relative_tolerance = options.absolute_tolerance = 1e-12;
    time::integrate_ode(problem, {begin, end, {}}, options, {}, {}, state);
    return state;
  };
}

/// Of the parameter set P1 under 1 kV and 5 kV sin(w tau), in units of tau.
LyapunovExponent compute_driven(const double pre_stretch,
                                const double frequency, const int periods)
{
  Demes demes;
  demes.pre_stretch = pre_stretch;
  demes.drive = make_drive(0.3, 5, 1, 5, frequency);
  const auto follow = [&](const std::vector<double>& state, const double begin,
                          const double end)
  {
    DemesRunOptions options;
    options.start_time = begin;
    options.end_time = end;
    options.start = {state[0], state[1], state[2]};
    options.tolerance = 1e-12;
    const auto row = run_demes(demes, options).rows.back();
    return std::vector<double>{row.angle, row.velocity, row.inner_stretch};
  };
  const double period = 2 * std::acos(-1.) / frequency;
  const auto rest = make_rest_start(demes);
  LyapunovOptions options;
  options.begin = 100 * period;
  options.end = (100 + periods) * period;
  options.intervals = 2u * unsigned(periods);
  const auto settled =
      follow({rest.angle, rest.velocity, rest.inner_stretch}, 0, options.begin);
  return compute_lyapunov(follow, settled, options);
}
} // namespace

TEST(Lyapunov, OfADrivenLinearOscillatorIsItsDecayRate)
{
  constexpr double decay = 0.05;
  const double damped = std::sqrt(1 - decay * decay);
  const Flow flow = make_flow(
      [&](const double t, const double* y, double* rate)
      {
        rate[0] = y[1];
        rate[1] = -y[0] - 2 * decay * y[1] + std::cos(1.7 * t);
      });
  // Over whole turns of the difference its direction returns, so that every
  // interval shows the same.
  LyapunovOptions options;
  options.end = 60 * 2 * std::acos(-1.) / damped;
  options.intervals = 60;
  const auto exponent = compute_lyapunov(flow, {1, 0}, options);
  // The flow's 1e-12 against the distance 1e-7.
  EXPECT_NEAR(exponent.value, -decay, 1e-5);
  EXPECT_LT(exponent.uncertainty, 1e-5);
}

TEST(Lyapunov, OfLorenzAttractor)
{
  const Flow flow = make_flow(
      [](double, const double* y, double* rate)
      {
        rate[0] = 10 * (y[1] - y[0]);
        rate[1] = y[0] * (28 - y[2]) - y[1];
        rate[2] = y[0] * y[1] - 8. / 3 * y[2];
      });
  LyapunovOptions options;
  options.end = 500;
  options.intervals = 1000;
  const auto exponent = compute_lyapunov(flow, {-6, -5, 25}, options);
  // 0.9056 (Sprott, Chaos and Time-Series Analysis, 2003); over 400 units of
  // time the mean scatters by what the standard error says.
  EXPECT_NEAR(exponent.value, 0.9056, 4 * exponent.uncertainty);
  EXPECT_LT(exponent.uncertainty, 0.03);
}

TEST(Lyapunov, OfDrivenDemesIsNegative)
{
  // Reference values of this parameter set, to the digits given: -.024, -.003.
  EXPECT_NEAR(compute_driven(3, 1, 60).value, -0.024, 1e-3);
  EXPECT_NEAR(compute_driven(2, 1, 200).value, -0.003, 1e-3);
}

TEST(Lyapunov, RefusesTooLittle)
{
  const Flow still = [](const std::vector<double>& state, double, double)
  { return state; };
  LyapunovOptions options;
  EXPECT_THROW(compute_lyapunov(still, {1}, options), BadInput);
  options.end = 1;
  options.intervals = 19;
  EXPECT_THROW(compute_lyapunov(still, {1}, options), BadInput);
  options.intervals = 20;
  EXPECT_EQ(compute_lyapunov(still, {1}, options).value, 0);
  const Flow merging = [](const std::vector<double>&, double, double)
  { return std::vector<double>{0}; };
  EXPECT_THROW(compute_lyapunov(merging, {1}, options), SolverFailed);
}
} // namespace taut::lumped
