// The options that hold the width of a film: fibres, and networks that flow
// along one axis only.
#include <gtest/gtest.h>

#include <utility>

#include "structure/viscous_films.h"

namespace taut
{
namespace
{
constexpr double modulus = 2e4;

/// A strip with free sides, stretched to 2 and 1.5 in the frame, then pulled by
/// a half along x.
structure::Device make_pulled_strip(const double fibre_modulus)
{
  structure::Device device;
  device.films = {
      testing::make_film(material::NeoHookean{modulus}, 1e-3, {{2, 1.5}})};
  device.films[0].fibre_modulus = fibre_modulus;
  device.supports = {testing::make_support("film", {{false, false, true}}),
                     testing::make_support("west", {{true, false, false}}),
                     testing::make_support("south_west", {{true, true, true}}),
                     testing::make_support("east", {{true, false, false}},
                                           {{".02", "0", "0"}},
                                           Signal::constant(1))};
  return device;
}

double compute_pull(const double fibre_modulus)
{
  testing::Model model(make_pulled_strip(fibre_modulus),
                       testing::make_rectangle(2, 2, 2, .04, .03));
  testing::Statics statics(*model.structure);
  // Stiff fibres leave the round-off of their own forces.
  statics.find(1e-11);
  return statics.get_reaction(3)[0];
}

TEST(FibresOfAFilm, StiffOnesHoldTheWidthOfTheFramedFilm)
{
  // Nominal stress of pure shear at 3 and 1.5, on 30/1.5 mm by 1 mm.
  const double held = modulus * (3 - 1 / (27 * 2.25)) * .02 * 1e-3;
  for (const double ratio : {1e2, 1e4})
    EXPECT_NEAR(compute_pull(ratio * modulus), held, 10 * held / ratio);
}

TEST(HeldWidthNetworks, RelaxedStartLeavesNothingAlongTheAxis)
{
  structure::Device device = make_pulled_strip(0);
  device.films[0].material.networks = {
      {material::Gent{modulus, 60}, 1, material::FlowLaw::held_width}};
  device.supports.push_back(
      testing::make_support("north", {{false, true, false}}));
  device.supports.push_back(
      testing::make_support("south", {{false, true, false}}));
  testing::Model model(device, testing::make_rectangle(2, 2, 2, .04, .03));
  structure::QuasiStaticSystem system(*model.structure, {});
  const auto state =
      system.make_initial_state(0, structure::Start::relaxed, true, {});
  std::vector<double> rates(state.size());
  system.evaluate(0, state.data(), rates.data());
  const double* A = system.internal(state.data());
  const double* A_rate = system.internal(std::as_const(rates).data());
  for (std::size_t i = 0; i < model.structure->n_internal(); i += 3)
  {
    // a = 1/(l_1^2 l_2) under C = diag(9, 2.25).
    EXPECT_NEAR(A[i], 1 / (9 * 1.5), 1e-10);
    EXPECT_EQ(A[i + 1], 1);
    EXPECT_EQ(A[i + 2], 0);
    EXPECT_NEAR(A_rate[i], 0, 1e-10);
  }
}
} // namespace
} // namespace taut
