#include <gtest/gtest.h>

#include <cmath>

#include "structure/frames.h"
#include <boost/math/constants/constants.hpp>

// Joints of frames: rigid corners and hinges.
namespace taut::testing
{
namespace
{
constexpr double half_pi = boost::math::constants::half_pi<double>();
/// For small loads: a strain of 1e-6 of them stays far above round-off.
const auto thick = make_stiffnesses(1e6, 1e6, 1, 1, 1);

Quaternion get_rotation_of(const Model& model, const Statics& statics,
                           const std::string& group, const unsigned int frame)
{
  const auto& frames = model.structure->device_nodes().frames;
  const auto place = *structure::find_group_places({group}, frames.mesh,
                                                   model.structure->mesh())
                          .begin();
  return fe::get_quaternion(
      model.structure->nodes()
          .rotations[frames.nodes[place].rotations.at(frame)],
      model.structure->compute_positions(statics.get_loads(),
                                         statics.u.data()));
}

fe::Coordinates get_position(const Model& model, const Statics& statics,
                             const std::string& group)
{
  return get_frame_position(*model.structure, statics.get_loads(),
                            statics.u.data(), group);
}

void apply_force(Statics& statics, const double force)
{
  statics.loads.point_loads[0].force = Signal::constant(force);
  statics.apply();
  statics.find();
}

/// Two clamped beams of length 1 with a hinge between them; the far clamp
/// slides along the beam, so that each half is a cantilever under P/2.
TEST(FrameHinge, TransmitsNoMoment)
{
  structure::Device device;
  device.frames = {make_frame("left", slender_beam),
                   make_frame("right", slender_beam)};
  structure::Hinge hinge;
  hinge.groups = {"hinge"};
  device.hinges = {hinge};
  auto slide = make_clamp("east");
  slide.held[0] = false;
  device.supports = {make_clamp("west"), slide};
  device.point_loads = {make_point_load("hinge", {0, 0, 1})};
  auto mesh = make_line_mesh();
  const auto left =
      add_line(mesh, "left", 40, make_straight({0, 0, 0}, {1, 0, 0}));
  const auto right =
      add_line(mesh, "right", 40, make_straight({1, 0, 0}, {2, 0, 0}));
  name_point(mesh, left[0], "west");
  name_point(mesh, left[1], "hinge");
  name_point(mesh, right[1], "east");
  fe::add_empty_surface(mesh);
  const Model model(device, mesh);
  Statics statics(*model.structure);
  for (const double load : {1., 2., 3., 4.})
    apply_force(statics, load);
  // The elastica at (P/2) L^2/EI = 2.
  const auto x = get_position(model, statics, "hinge");
  EXPECT_NEAR(x[2], .4934574804, 1e-6);
  EXPECT_NEAR(x[0], 1 - .1606417208, 1e-6);
  EXPECT_NEAR(get_position(model, statics, "east")[0], 2 - 2 * .1606417208,
              2e-6);
  for (const unsigned int frame : {0u, 1u})
    EXPECT_NEAR(compute_angle(get_rotation_of(model, statics, "hinge", frame),
                              {0, 1, 0}),
                (frame == 0 ? -1 : 1) * .7817498316, 1e-6);
}

/// Two legs of length 1, along x and then along -z, as two frames.
fe::MeshData make_corner_mesh(const unsigned int n)
{
  auto mesh = make_line_mesh();
  const auto first =
      add_line(mesh, "first", n, make_straight({0, 0, 0}, {1, 0, 0}));
  const auto second =
      add_line(mesh, "second", n, make_straight({1, 0, 0}, {1, 0, -1}));
  name_point(mesh, first[0], "root");
  name_point(mesh, first[1], "corner");
  name_point(mesh, second[1], "tip");
  for (const unsigned int i : {1u, 2u})
  {
    name_point(mesh, first[1] - i, "before " + std::to_string(i));
    name_point(mesh, first[1] + i, "behind " + std::to_string(i));
  }
  fe::add_empty_surface(mesh);
  return mesh;
}

structure::Device make_corner_device(const structure::BeamSection& section)
{
  structure::Device device;
  device.frames = {make_frame("first", section), make_frame("second", section)};
  device.frames[0].normal = device.frames[1].normal = {{0, 1, 0}};
  device.supports = {make_clamp("root")};
  device.point_loads = {make_point_load("tip", {1, 0, 0})};
  return device;
}

/// Direction of the leg at the corner, away from it, from three of its points.
double compute_direction(const Model& model, const Statics& statics,
                         const std::string& side)
{
  const auto x0 = get_position(model, statics, "corner");
  const auto x1 = get_position(model, statics, side + " 1");
  const auto x2 = get_position(model, statics, side + " 2");
  return std::atan2(-3 * x0[2] + 4 * x1[2] - x2[2],
                    -3 * x0[0] + 4 * x1[0] - x2[0]);
}

TEST(FrameCorner, KeepsItsAngle)
{
  const auto compute_corner = [](const unsigned int n)
  {
    const Model model(make_corner_device(slender_beam), make_corner_mesh(n));
    Statics statics(*model.structure);
    for (const double load : {.5, 1., 1.5, 2.})
      apply_force(statics, load);
    EXPECT_GT(std::abs(compute_angle(
                  get_rotation_of(model, statics, "corner", 0), {0, 1, 0})),
              .5);
    return std::remainder(compute_direction(model, statics, "behind") -
                              compute_direction(model, statics, "before"),
                          4 * half_pi);
  };
  // The directions are of second order in the distance of the points.
  const double coarse = compute_corner(40), fine = compute_corner(80);
  EXPECT_NEAR((4 * fine - coarse) / 3, half_pi, 2e-6);
}

TEST(FrameCorner, PassesOnTheMoment)
{
  // Small loads: the corner turns by P/EI, the tip moves by that and P/(3 EI).
  const Model model(make_corner_device(thick), make_corner_mesh(8));
  Statics statics(*model.structure);
  constexpr double load = 1e-3;
  apply_force(statics, load);
  // The load stretches the first leg, which stiffens it by a relative
  // P L^2/(3 EI).
  EXPECT_NEAR(std::abs(compute_angle(
                  get_rotation_of(model, statics, "corner", 0), {0, 1, 0})),
              load, load * load);
  EXPECT_NEAR(get_position(model, statics, "tip")[0] - 1, load * 4 / 3,
              load * load);
}

/// Three beams of length 1 that meet: two clamped, one free with a moment at
/// its end, which turns the joint by m/(4 EI + 4 EI).
TEST(FrameJoint, SharesAMomentBetweenBeams)
{
  structure::Device device;
  device.frames = {make_frame("beam", thick), make_frame("column", thick)};
  device.frames[0].normal = device.frames[1].normal = {{0, 1, 0}};
  device.supports = {make_clamp("west"), make_clamp("east")};
  constexpr double moment = 1e-3;
  auto load = make_point_load("top", {0, 0, 0});
  load.moment_direction = {{0, 1, 0}};
  load.moment = Signal::constant(moment);
  device.point_loads = {load};
  auto mesh = make_line_mesh();
  const auto left =
      add_line(mesh, "beam", 8, make_straight({-1, 0, 0}, {0, 0, 0}));
  const auto right =
      add_line(mesh, "beam", 8, make_straight({0, 0, 0}, {1, 0, 0}));
  const auto column =
      add_line(mesh, "column", 8, make_straight({0, 0, 0}, {0, 0, 1}));
  name_point(mesh, left[0], "west");
  name_point(mesh, right[0], "joint");
  name_point(mesh, right[1], "east");
  name_point(mesh, column[1], "top");
  fe::add_empty_surface(mesh);
  const Model model(device, mesh);
  Statics statics(*model.structure);
  statics.find();
  // Relative errors: the angle to the square, 1e-6, the shear, 1e-5.
  const double joint =
      compute_angle(get_rotation_of(model, statics, "joint", 0), {0, 1, 0});
  const double top =
      compute_angle(get_rotation_of(model, statics, "top", 1), {0, 1, 0});
  EXPECT_NEAR(joint, moment / 8, 1e-4 * moment / 8);
  EXPECT_NEAR(top - joint, moment, 1e-4 * moment);
  EXPECT_NEAR(get_position(model, statics, "top")[0], moment / 8 + moment / 2,
              1e-4 * moment);
}
} // namespace
} // namespace taut::testing
