// A film in a flat frame that is let go: it swings through large angles and, at
// pre-stretches of 4 and more, goes slack in places on the way.
#include <taut/structure/point_fields.h>
#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "structure/balance.h"
#include "structure/demes.h"

namespace taut::testing
{
namespace
{
/// The share of the points that carry no tension.
double compute_slack_share(structure::StructureSystem& system,
                           const double time, const double* state)
{
  const auto fields = structure::compute_point_fields(
      system.structure(), system.history().at(time), state,
      system.internal(state));
  const auto n_slack =
      std::count_if(fields.begin(), fields.end(),
                    [](const auto& point)
                    { return point.tension == structure::Tension::slack; });
  return double(n_slack) / fields.size();
}

class FreeRun : public ::testing::TestWithParam<double>
{
};

TEST_P(FreeRun, KeepsItsEnergy)
{
  Demes demes;
  demes.pre_stretch = GetParam();
  demes.n_cells = 4;
  // Glued on the face of the legs: the eccentricity starts the motion.
  demes.offset = 5e-4;
  Model model(make_demes_device(demes), make_demes_mesh(demes));
  structure::InertialSystem system(*model.structure);
  auto state =
      system.make_initial_state(0, structure::Start::relaxed, false, {});
  const auto balance = [&](const double time, const double* y)
  {
    const auto s = get_scalars(system, y);
    return system.compute_energies(time, y).total() +
           s[structure::Scalar::dissipated] + s[structure::Scalar::lost] -
           s[structure::Scalar::work];
  };
  const double first = balance(0, state.data());
  const double scale = system.compute_energies(0, state.data()).stored;
  double drift = 0, highest = 0, most_slack = 0;
  time::Observer observer;
  observer.step = [&](const time::Step& step, const auto&)
  {
    drift =
        std::max(drift, std::abs(balance(step.end(), step.state()) - first));
    highest = std::max(
        highest,
        std::abs(measure_demes(system.structure(),
                               system.history().at(step.end()), step.state())
                     .slope));
    most_slack = std::max(
        most_slack, compute_slack_share(system, step.end(), step.state()));
  };
  time::Schedule schedule;
  schedule.end = 0.06;
  time::IntegratorOptions options;
  options.position_tolerance = 1e-8;
  time::integrate(system, state.data(), schedule, options, {}, observer);
  EXPECT_LT(drift, 1e-4 * scale);
  EXPECT_GT(highest, .5);
  // One of the points at least, of 9 a cell in 4 x 4 cells.
  if (GetParam() >= 4)
  {
    EXPECT_GT(most_slack, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(pre_stretches, FreeRun, ::testing::Values(3, 4, 5));
} // namespace
} // namespace taut::testing
