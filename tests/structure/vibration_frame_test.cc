// Vibration modes of frames against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "structure/frames.h"
#include "structure/vibrations.h"
#include <boost/math/constants/constants.hpp>

namespace taut
{
namespace
{
constexpr double half_turn = boost::math::constants::pi<double>();
constexpr double torsional_inertia = 1e-2;

/// A slender beam of unit length, mass and bending stiffness in the plane of
/// its thickness; the other is four times as stiff.
structure::Device make_beam()
{
  structure::Device device;
  auto section = testing::make_stiffnesses(1e7, 1e7, 1, 1, 4);
  section.mass_per_length = 1;
  section.rotary_inertia = {{torsional_inertia, 1e-7, 1e-7}};
  device.frames = {testing::make_frame("beam", section)};
  return device;
}

fe::MeshData make_line(const unsigned int n = 16)
{
  auto mesh = testing::make_line_mesh();
  const auto ends = testing::add_line(
      mesh, "beam", n, testing::make_straight({0, 0, 0}, {1, 0, 0}));
  testing::name_point(mesh, ends[0], "root");
  testing::name_point(mesh, ends[1], "tip");
  fe::add_empty_surface(mesh);
  return mesh;
}

TEST(FrameModes, CantileverBendsAndTwistsAsEulerAndBernoulliSay)
{
  auto device = make_beam();
  device.supports = {testing::make_clamp("root")};
  testing::Resting beam(device, make_line());
  const auto squares = beam.find_squares(5);
  // Roots of cos b cosh b = -1; omega = b^2 sqrt(EI).
  constexpr double first = 1.8751040687, second = 4.6940911330;
  const double twist = std::pow(half_turn / 2, 2) / torsional_inertia;
  // Shear and rotary inertia lower them by less than b^2 1e-6; the mesh leaves
  // (b/16)^4 over a few hundred.
  EXPECT_NEAR(squares[0] / std::pow(first, 4), 1, 1e-5);
  EXPECT_NEAR(squares[1] / (4 * std::pow(first, 4)), 1, 2e-5);
  EXPECT_NEAR(squares[2] / twist, 1, 1e-5);
  EXPECT_NEAR(squares[3] / std::pow(second, 4), 1, 2e-4);
  EXPECT_NEAR(squares[4] / (4 * std::pow(second, 4)), 1, 2e-4);
}

TEST(FrameModes, FreeBeamHasSixRigidMotions)
{
  testing::Resting beam(make_beam(), make_line());
  const auto squares = beam.find_squares(8);
  constexpr double root = 4.7300407449;
  for (unsigned int i = 0; i < 6; ++i)
    EXPECT_LT(std::abs(squares[i]), 1e-7 * squares[6]);
  EXPECT_NEAR(squares[6] / std::pow(root, 4), 1, 2e-4);
  EXPECT_NEAR(squares[7] / (half_turn * half_turn / torsional_inertia), 1,
              1e-4);
}

TEST(FrameModes, CompressedColumnLosesItsStiffness)
{
  // Simply supported: omega_n^2 = (n half_turn)^4 - P (n half_turn)^2.
  for (const double load : {.5, 2.})
  {
    auto device = make_beam();
    device.supports = {testing::make_support("root", {{true, true, true}}),
                       testing::make_support("tip", {{false, true, true}})};
    device.supports[0].held_rotations = {{true, false, false}};
    device.point_loads = {testing::make_point_load("tip", {-1, 0, 0})};
    device.point_loads[0].force =
        Signal::constant(load * half_turn * half_turn);
    testing::Resting column(device, make_line());
    const auto squares = column.find_squares(1);
    EXPECT_NEAR(squares[0] / ((1 - load) * std::pow(half_turn, 4)), 1, 1e-4);
  }
}

TEST(FrameModes, MassWithoutABeamOfItsOwnMass)
{
  // A tip mass on massless legs: 3 EI/L^3/m in both directions, the axial one
  // and no more, whatever the massless unknowns do.
  auto device = make_beam();
  device.frames[0].section.mass_per_length = 0;
  device.frames[0].section.rotary_inertia = {};
  device.supports = {testing::make_clamp("root")};
  structure::PointMass mass;
  mass.name = "tip";
  mass.groups = {"tip"};
  mass.mass = 2;
  device.masses = {mass};
  testing::Resting beam(device, make_line(4));
  const auto squares = beam.find_squares(8);
  ASSERT_EQ(squares.size(), 3u);
  EXPECT_NEAR(squares[0] / (3 / 2.), 1, 1e-5);
  EXPECT_NEAR(squares[1] / (3 * 4 / 2.), 1, 1e-5);
  EXPECT_NEAR(squares[2] / (1e7 / 2), 1, 1e-5);
}
} // namespace
} // namespace taut
