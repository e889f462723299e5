#pragma once

#include <taut/study/motion_track.h>
#include <taut/time/ode.h>

#include <cmath>
#include <functional>

/// Motions whose class is known.
namespace taut::testing
{
const double pi = std::acos(-1.);

/// Rows of a function and its derivative at n + 1 even times from 0.
inline study::MotionTrack sample(const double end, const int n,
                                 const std::function<double(double)>& value,
                                 const std::function<double(double)>& velocity)
{
  study::MotionTrack track;
  for (int i = 0; i <= n; ++i)
  {
    const double t = end * i / n;
    track.add({t, value(t), velocity(t)});
  }
  return track;
}

/// x'' = acceleration(t, x, x').
inline study::MotionTrack
integrate(const double end, const int n,
          const std::function<double(double, double, double)>& acceleration,
          std::vector<double> start)
{
  study::MotionTrack track;
  time::OdeProblem problem;
  problem.size = 2;
  problem.rate = [&](const double t, const double* y, double* rate)
  {
    rate[0] = y[1];
    rate[1] = acceleration(t, y[0], y[1]);
  };
  time::OdeSchedule schedule{0, end, {}};
  for (int i = 1; i < n; ++i)
    schedule.output_times.push_back(end * i / n);
  time::OdeObserver observer;
  observer.output = [&](const double t, const double* y) {
    track.add({t, y[0], y[1]});
  };
  time::OdeOptions options;
  options.method = time::OdeMethod::explicit_runge_kutta;
  time::integrate_ode(problem, schedule, options, {}, observer, start);
  return track;
}

constexpr double duffing_frequency = 1.2;
const double duffing_period = 2 * pi / duffing_frequency;

/// x'' + 0.3 x' - x + x^3 = force cos(1.2 t), of Jordan and Smith, Nonlinear
/// Ordinary Differential Equations (2007): with the force 0.20 it has the
/// period 1, then 2 at 0.28, 4 at 0.29, 5 at 0.37; chaos at 0.50, 2 at 0.65.
inline study::MotionTrack make_duffing(const double force, const int periods)
{
  return integrate(periods * duffing_period, 32 * periods,
                   [force](const double t, const double x, const double v) {
                     return force * std::cos(duffing_frequency * t) - 0.3 * v +
                            x - x * x * x;
                   },
                   {1, 0});
}
} // namespace taut::testing
