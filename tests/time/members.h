#pragma once

#include <taut/time/integrate.h>

#include <cmath>

#include "oscillators.h"

// The oscillators and settings that the tests of integrate share.

/// Stiffness per mass of the slowest member, 50 Hz.
inline const double k = std::pow(2 * M_PI * 50, 2);

/// Relaxation times below, near and far above the period, and a member a
/// thousand times faster that is at rest.
inline std::vector<Oscillator> make_members(const double scale = 1)
{
  std::vector<Oscillator> members = {
      {1, k, .3 * k, 1e-2, 0, {{1e-3, 0, 1e-3}}},
      {2, 3 * k, .5 * k, 1, 2., {{0, .2, 0}}},
      {1, 1.5 * k, .2 * k, 1e-4, 0, {{5e-4, .1, 0}}},
      {1, 1e6 * k, 0, 1, 0, {{0, 0, 0}}}};
  for (Oscillator& member : members)
  {
    member.mass *= scale;
    member.stiffness *= scale;
    member.viscous_stiffness *= scale;
    member.drag *= scale;
  }
  return members;
}

inline Oscillators make_system(const double scale = 1)
{
  return Oscillators(make_members(scale), Oscillators::Kind::inertial,
                     MPI_COMM_WORLD);
}

inline taut::time::IntegratorOptions
make_options(const double tolerance,
             const taut::time::Method method = taut::time::Method::esdirk4)
{
  taut::time::IntegratorOptions options;
  options.method = method;
  options.position_tolerance = tolerance;
  options.first_step = 1e-7;
  return options;
}

inline taut::time::Schedule make_schedule(const double end,
                                          const int n_outputs = 0)
{
  taut::time::Schedule schedule;
  schedule.end = end;
  for (int i = 1; i <= n_outputs; ++i)
    schedule.output_times.push_back(end * i / n_outputs);
  return schedule;
}

/// Norm over all ranks of the error of block 0 (u), 1 (v) or 2 (a).
inline double compute_error(const Oscillators& system, const double time,
                            const double* state, const int block)
{
  const std::size_t n = system.n_members();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    sum += std::pow(state[block * n + i] - system.get_exact(i, time)[block], 2);
  return std::sqrt(system.sum(sum));
}
