// A film that curls its frame: rest shapes on both sides and on all ranks.
#include <gtest/gtest.h>

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
  // The ends hold the width of the film, its long edges do not: the slope lies
  // between those of the elastica whose film is in uniaxial tension, S (l -
  // l^-2), and in pure shear, S (l - l^-3), by 4 K(k)^2 EI/L_1^2 = N, k =
  // sin(slope/2).
  EXPECT_GT(up.shape.slope, .8016757732);
  EXPECT_LT(up.shape.slope, .9030373789);
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

} // namespace
} // namespace taut::testing
