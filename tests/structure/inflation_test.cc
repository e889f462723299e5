// Inflation of a flat circular membrane, clamped at its rim, through the limit
// point: at every height of the apex the pressure is an unknown of Newton's
// method. Modulus, thickness and the radius in the mesh are 1.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "structure/patchwork.h"
#include "structure/statics.h"

namespace taut
{
namespace
{
/// Lengths over the radius a before the pre-stretch; p a/(mu H).
struct Row
{
  double pre_stretch, field, polar_stretch, pressure, apex;
};

void PrintTo(const Row& row, std::ostream* stream)
{
  *stream << "polar stretch " << row.polar_stretch << " after "
          << row.pre_stretch << ", field " << row.field;
}

structure::Device make_device(const Row& row)
{
  structure::Device device;
  device.films = {testing::make_film(material::NeoHookean{1}, 1,
                                     {{row.pre_stretch, row.pre_stretch}})};
  device.electrodes = {testing::make_electrode(
      "film",
      Signal::constant(testing::make_voltage(device.films[0], row.field, 1)))};
  device.supports = {testing::make_support("rim", {{true, true, true}}),
                     testing::make_support("x0", {{true, false, false}}),
                     testing::make_support("y0", {{false, true, false}})};
  structure::Pressure gas;
  gas.name = "gas";
  gas.groups = {"film"};
  device.pressures = {gas};
  return device;
}

/// An inflated state.
struct State
{
  double height = 0, pressure = 0;
  std::vector<double> u;
};

class Inflation
{
public:
  Inflation(const Row& row, const unsigned int n)
      : model_(make_device(row), testing::make_quarter_disc(n)),
        structure_(*model_.structure), statics_(structure_),
        loads_(statics_.get_loads())
  {
    const auto& free = structure_.free_unknowns();
    for (std::size_t i = 0; i < free.size(); ++i)
    {
      const auto& X = structure_.nodes().mesh_position[free[i] / 3];
      if (free[i] % 3 == 2 && std::hypot(X[0], X[1]) < 1e-9)
        apex_ = i;
    }
  }

  /// The pressure at which the apex is at `height`, reached in small steps.
  double find_pressure(const double height)
  {
    constexpr double first = .1, step = .05;
    State last, now = make_bowl(first);
    solve(now);
    const unsigned int n_steps = std::ceil((height - first) / step);
    for (unsigned int i = 1; i <= n_steps; ++i)
    {
      State next = predict(last, now, first + (height - first) * i / n_steps);
      solve(next);
      last = std::exchange(now, next);
    }
    statics_.u = now.u;
    return now.pressure;
  }
  double find_largest_stretch()
  {
    double largest = 0;
    for (const auto& C : statics_.compute_metric())
      largest = std::max(largest, C[0]);
    return std::sqrt(largest);
  }

private:
  State make_bowl(const double height) const
  {
    State bowl{height, 0, std::vector<double>(structure_.n_free(), 0.)};
    const auto& free = structure_.free_unknowns();
    for (std::size_t i = 0; i < free.size(); ++i)
    {
      const auto& X = structure_.nodes().mesh_position[free[i] / 3];
      if (free[i] % 3 == 2)
        bowl.u[i] = height * (1 - X[0] * X[0] - X[1] * X[1]);
    }
    return bowl;
  }

  /// Straight on from the last two states.
  static State predict(const State& last, const State& now, const double height)
  {
    State next = now;
    next.height = height;
    if (last.u.empty())
      return next;
    const double ratio = (height - now.height) / (now.height - last.height);
    next.pressure += ratio * (now.pressure - last.pressure);
    for (std::size_t i = 0; i < now.u.size(); ++i)
      next.u[i] += ratio * (now.u[i] - last.u[i]);
    return next;
  }

  std::vector<double> compute_forces(const State& state, const double pressure)
  {
    std::vector<double> forces(state.u.size());
    loads_.pressures[0] = pressure;
    structure_.compute_forces(loads_, state.u.data(), statics_.internal.data(),
                              structure::Networks::relaxed, forces.data(),
                              nullptr);
    return forces;
  }

  /// Newton for displacements and pressure at the height of `state`.
  void solve(State& state)
  {
    double largest = 1;
    for (unsigned int step = 0; step < 30 && largest > 1e-11; ++step)
    {
      auto change = compute_forces(state, state.pressure);
      // Forces are affine in the pressure.
      auto by_pressure = compute_forces(state, 1);
      const auto without = compute_forces(state, 0);
      for (std::size_t i = 0; i < without.size(); ++i)
        by_pressure[i] -= without[i];
      loads_.pressures[0] = state.pressure;
      structure_.factorise(loads_, state.u.data(), statics_.internal.data(),
                           structure::Networks::relaxed,
                           std::numeric_limits<double>::infinity(), false,
                           fe::LinearSolver::Kind::general);
      structure_.solve(change.data(), change.data());
      structure_.solve(by_pressure.data(), by_pressure.data());
      const double rise = state.height - state.u[apex_];
      const double dp = (rise - change[apex_]) / by_pressure[apex_];
      state.pressure += dp;
      largest = std::abs(dp);
      for (std::size_t i = 0; i < change.size(); ++i)
      {
        const double du = change[i] + dp * by_pressure[i];
        state.u[i] += du;
        largest = std::max(largest, std::abs(du));
      }
    }
    EXPECT_LE(largest, 1e-11) << "at height " << state.height;
  }

  testing::Model model_;
  structure::Structure& structure_;
  testing::Statics statics_;
  structure::LoadState loads_;
  std::size_t apex_ = 0;
};

class Membrane : public ::testing::TestWithParam<Row>
{
};

TEST_P(Membrane, pressure_at_given_height_is_the_reference)
{
  const Row& row = GetParam();
  // The mesh has the radius 1 = pre_stretch a.
  const double height = row.apex / row.pre_stretch;
  const double expected = row.pressure * row.pre_stretch;
  double errors[2];
  for (const unsigned int level : {0, 1})
  {
    Inflation inflation(row, 2 << level);
    errors[level] = std::abs(inflation.find_pressure(height) / expected - 1);
    if (level == 1)
    {
      EXPECT_NEAR(inflation.find_largest_stretch(), row.polar_stretch,
                  .02 * row.polar_stretch);
    }
  }
  EXPECT_LT(errors[1], 1e-4);
  // At least of the order of Q2 in L2.
  EXPECT_GT(std::log2(errors[0] / errors[1]), 2.85)
      << errors[0] << " " << errors[1];
}

INSTANTIATE_TEST_SUITE_P(
    rows, Membrane,
    ::testing::Values(Row{1, 0, 1.2, .9992518338, .5309760701},
                      Row{1, 0, 1.5, 1.6435818408, .7987892131},
                      Row{1, 0, 2, 1.8695547483, 1.0830671614},
                      Row{1, 0, 3, 1.8079220953, 1.4888464333},
                      Row{2, 0, 3, .9411968801, 1.4200614512},
                      Row{2, .2, 3, .6437926357, 1.2451889332}));
} // namespace
} // namespace taut
