// Air drag on a film that its supports carry along.
#include <gtest/gtest.h>

#include <cmath>

#include "structure/devices.h"

namespace taut
{
namespace
{
structure::Device make_device(const Signal& motion)
{
  structure::Device device;
  device.films = {
      testing::make_film(material::NeoHookean{2e4}, 1e-3, {{1.3, 1.2}})};
  device.supports = {testing::make_support("west", {{true, true, true}},
                                           {{"1", "0", "0"}}, motion),
                     testing::make_support("east", {{true, true, true}},
                                           {{"1", "0", "0"}}, motion)};
  return device;
}

/// Rate of the state in which all of the film moves with `speed` along x.
std::vector<double> evaluate(const structure::Device& device,
                             const double speed)
{
  testing::Model model(device, testing::make_rectangle(4, 3, 2, .04, .03));
  structure::InertialSystem system(*model.structure);
  auto state =
      system.make_initial_state(0, structure::Start::relaxed, false, {});
  const auto& unknowns = model.structure->free_unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    state[unknowns.size() + i] = unknowns[i] % 3 == 0 ? speed : 0.;
  std::vector<double> rate(state.size());
  system.evaluate(0, state.data(), rate.data());
  return rate;
}

TEST(AirDrag, of_a_film_in_uniform_motion_is_like_a_weight)
{
  constexpr double speed = 2, drag = 3e3;
  auto carried = make_device(Signal::ramp(speed, 0, 1e3));
  carried.environment.air_drag = drag;
  auto heavy = make_device(Signal());
  const double density = heavy.films[0].material.density;
  heavy.environment.gravity = {{-drag * speed / density, 0, 0}};
  const auto dragged = evaluate(carried, speed);
  const auto weighed = evaluate(heavy, speed);
  ASSERT_EQ(dragged.size(), weighed.size());
  const std::size_t n = (dragged.size() - structure::n_scalars) / 2;
  double largest = 0;
  for (std::size_t i = n; i < 2 * n; ++i)
    largest = std::max(largest, std::abs(weighed[i]));
  EXPECT_GT(largest, 0);
  // Both are sums of the same few hundred products: round-off.
  for (std::size_t i = n; i < 2 * n; ++i)
    EXPECT_NEAR(dragged[i], weighed[i], 1e-12 * largest);
}
} // namespace
} // namespace taut
