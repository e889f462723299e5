// A film that curls its frame: rest shapes, a free motion from flat, ranks.
#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/balance.h"
#include "structure/demes.h"

namespace taut::testing
{
namespace
{
struct Rest
{
  structure::RestShape path;
  DemesShape shape;
};

Rest find_rest(const Demes& demes, const MPI_Comm communicator,
               const double direction = 1)
{
  Model model(make_demes_device(demes), make_demes_mesh(demes), 0, {},
              communicator);
  auto& structure = *model.structure;
  structure::LoadHistory history(structure.device());
  history.enter_interval(0);
  std::vector<double> u(structure.n_free(), 0.);
  structure::RestPathOptions options;
  options.direction = {{0, 0, direction}};
  Rest rest;
  rest.path = structure::find_rest_shape(structure, history,
                                         structure::Networks::relaxed, nullptr,
                                         0, options, u.data());
  rest.shape = measure_demes(structure, history.at(0), u.data());
  return rest;
}

TEST(Demes, CurlsToEitherSideAndIsStableThere)
{
  const Rest up = find_rest({}, MPI_COMM_WORLD);
  const Rest down = find_rest({}, MPI_COMM_WORLD, -1);
  EXPECT_GT(up.path.flat_negative_eigenvalues, 0);
  EXPECT_EQ(up.path.negative_eigenvalues, 0);
  EXPECT_EQ(down.path.negative_eigenvalues, 0);
  // Without its held width the film pulls less than in pure shear (.903), and
  // more than the same film in uniaxial tension with 3/4 of its force.
  EXPECT_GT(up.shape.slope, .7);
  EXPECT_LT(up.shape.slope, .903);
  // The device is its own mirror image; 1e-8 from the equilibria's tolerance.
  EXPECT_NEAR(up.shape.slope, -down.shape.slope, 1e-8);
  EXPECT_NEAR(up.shape.chord, down.shape.chord, 1e-8 * up.shape.chord);
}

TEST(Demes, RestsAlikeOnOneRankAndMore)
{
  const Rest together = find_rest({}, MPI_COMM_WORLD);
  const Rest alone = find_rest({}, MPI_COMM_SELF);
  EXPECT_NEAR(together.shape.slope, alone.shape.slope, 1e-8);
  EXPECT_NEAR(together.shape.chord, alone.shape.chord,
              1e-8 * alone.shape.chord);
}

TEST(Demes, StaysFlatBelowTheThreshold)
{
  Demes demes;
  demes.pre_stretch = 1.3;
  const Rest rest = find_rest(demes, MPI_COMM_WORLD);
  EXPECT_EQ(rest.path.flat_negative_eigenvalues, 0);
  EXPECT_NEAR(rest.shape.slope, 0, 1e-6);
}

/// From flat, released; the film goes slack on its way at high pre-stretch.
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
  double drift = 0, highest = 0;
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
  };
  time::Schedule schedule;
  schedule.end = 0.15;
  time::IntegratorOptions options;
  options.position_tolerance = 1e-7;
  time::integrate(system, state.data(), schedule, options, {}, observer);
  EXPECT_LT(drift, 1e-4 * scale);
  EXPECT_GT(highest, .5);
}

INSTANTIATE_TEST_SUITE_P(pre_stretches, FreeRun, ::testing::Values(3, 4, 5));
} // namespace
} // namespace taut::testing
