#pragma once

#include <taut/structure/systems.h>
#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

/// The balance of energy, total + dissipated + lost - work = constant.
namespace taut::testing
{
/// The scalars of a state, which live on the first rank; collective.
inline std::array<double, structure::n_scalars>
get_scalars(const structure::StructureSystem& system, const double* state)
{
  std::array<double, structure::n_scalars> scalars{};
  if (system.layout().scalars > 0)
    std::copy_n(system.scalars(state), scalars.size(), scalars.begin());
  for (double& scalar : scalars)
    scalar = dealii::Utilities::MPI::sum(scalar, system.communicator());
  return scalars;
}

/// Largest change of the balance in a run, over the largest change of the
/// total energy; `watch` sees every step. `dissipates`: whether networks do.
inline double
compute_drift(structure::StructureSystem& system, const double end,
              const time::IntegratorOptions& options,
              const std::function<void(double, const double*)>& watch = {},
              const bool dissipates = true)
{
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  const auto balance = [&](const double time, const double* y)
  {
    const auto s = get_scalars(system, y);
    return system.compute_energies(time, y).total() +
           s[structure::Scalar::dissipated] + s[structure::Scalar::lost] -
           s[structure::Scalar::work];
  };
  const double start = system.compute_energies(0, state.data()).total();
  const double first = balance(0, state.data());
  double drift = 0, change = 0;
  time::Observer observer;
  observer.step = [&](const time::Step& step, const auto&)
  {
    if (watch)
      watch(step.end(), step.state());
    drift =
        std::max(drift, std::abs(balance(step.end(), step.state()) - first));
    change = std::max(
        change,
        std::abs(system.compute_energies(step.end(), step.state()).total() -
                 start));
  };
  time::Schedule schedule;
  schedule.end = end;
  integrate(system, state.data(), schedule, options, {}, observer);
  EXPECT_EQ(get_scalars(system, state.data())[structure::Scalar::dissipated] >
                0,
            dissipates);
  return drift / change;
}
} // namespace taut::testing
