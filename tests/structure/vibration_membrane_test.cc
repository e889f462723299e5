// Vibration modes of membranes under tension against theory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "structure/vibrations.h"
#include <boost/math/constants/constants.hpp>

namespace taut
{
namespace
{
constexpr double pi_square = boost::math::constants::pi_sqr<double>();

/// A flat film whose nodes only leave the plane, clamped at its edges.
structure::Device make_membrane(const std::array<double, 2>& pre_stretch)
{
  structure::Device device;
  device.mesh.degree = 2;
  device.films = {
      testing::make_film(material::NeoHookean{2e4}, 1e-3, pre_stretch)};
  device.films[0].tension_field = false;
  device.supports = {testing::make_support("film", {{true, true, false}})};
  for (const char* edge : {"west", "east", "south", "north"})
    device.supports.push_back(
        testing::make_support(edge, {{false, false, true}}));
  return device;
}

constexpr double length = 0.06, width = 0.04;

/// True stresses (Pa) of the incompressible film.
std::array<double, 2> compute_stresses(const std::array<double, 2>& l)
{
  const double across = std::pow(l[0] * l[1], -2);
  return {2e4 * (l[0] * l[0] - across), 2e4 * (l[1] * l[1] - across)};
}

/// (pi^2/rho) (s_1 m^2/a^2 + s_2 n^2/b^2): thickness cancels.
std::vector<double> compute_membrane(const std::array<double, 2>& stresses,
                                     const unsigned int count)
{
  std::vector<double> squares;
  for (unsigned int m = 1; m < 10; ++m)
    for (unsigned int n = 1; n < 10; ++n)
      squares.push_back(pi_square / 1000 *
                        (stresses[0] * std::pow(m / length, 2) +
                         stresses[1] * std::pow(n / width, 2)));
  std::sort(squares.begin(), squares.end());
  squares.resize(count);
  return squares;
}

std::vector<double> find_membrane(const structure::Device& device,
                                  const unsigned int n,
                                  const unsigned int count)
{
  return testing::Resting(
             device, testing::make_rectangle(3 * n, 2 * n, 1, length, width))
      .find_squares(count);
}

TEST(MembraneModes, MembraneUnderUnequalTensionConvergesToTheory)
{
  for (const auto& stretches : {std::array{2., 2.}, std::array{2., 1.3}})
  {
    const auto exact = compute_membrane(compute_stresses(stretches), 4);
    const auto coarse = find_membrane(make_membrane(stretches), 2, 4);
    const auto fine = find_membrane(make_membrane(stretches), 4, 4);
    for (unsigned int i = 0; i < 4; ++i)
    {
      const double before = coarse[i] / exact[i] - 1;
      const double after = fine[i] / exact[i] - 1;
      EXPECT_LT(after, 2e-3);
      // From above with the order 2 p = 4 of conforming elements.
      EXPECT_GT(after, 0);
      EXPECT_NEAR(std::log2(before / after), 4, .3) << "mode " << i;
    }
  }
}

TEST(MembraneModes, VoltageTakesTheFieldOutOfTheTension)
{
  const std::array<double, 2> stretches{2, 1.5};
  auto device = make_membrane(stretches);
  const double voltage = testing::make_voltage(device.films[0], .2, 2e4);
  const auto without = find_membrane(device, 2, 3);
  device.electrodes = {
      testing::make_electrode("film", Signal::constant(voltage))};
  const auto with = find_membrane(device, 2, 3);
  // eps E^2, E = V l_1 l_2/H, in all directions.
  const double field = .2 * .2 * 2e4 * std::pow(stretches[0] * stretches[1], 2);
  auto stresses = compute_stresses(stretches);
  const double before = compute_membrane(stresses, 1)[0];
  for (double& stress : stresses)
    stress -= field;
  const double after = compute_membrane(stresses, 1)[0];
  ASSERT_LT(after, .9 * before);
  // Both carry nearly the same error of the mesh.
  EXPECT_NEAR(with[0] / after, without[0] / before, 1e-4);
  EXPECT_NEAR(with[0] / after, 1, 1e-3);
}

TEST(MembraneModes, PressureOnFreeEdgesIsNotSymmetric)
{
  structure::Device device;
  device.mesh.degree = 2;
  device.films = {testing::make_film(material::NeoHookean{1}, .1, {{2, 2}})};
  device.supports = {testing::make_support("west", {{true, true, true}}),
                     testing::make_support("east", {{true, true, true}})};
  device.pressures = {testing::make_pressure("film", Signal::constant(.01))};
  const auto mesh = testing::make_rectangle(2, 2, 1, 1, 1);
  EXPECT_GT(testing::Resting(device, mesh).make_vibration().asymmetry(), 1e-6);
  for (const char* edge : {"south", "north"})
    device.supports.push_back(
        testing::make_support(edge, {{true, true, true}}));
  EXPECT_LT(testing::Resting(device, mesh).make_vibration().asymmetry(), 1e-12);
}
} // namespace
} // namespace taut
