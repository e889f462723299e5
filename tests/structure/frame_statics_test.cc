#include <gtest/gtest.h>

#include <cmath>

#include "structure/frames.h"

// Statics of geometrically exact beams against closed forms and references of
// 1e-8 or better that were computed with independent codes.
namespace taut::testing
{
namespace
{
/// A straight cantilever along x from `root` to `tip`.
fe::MeshData make_cantilever(const double length, const unsigned int n)
{
  auto mesh = make_line_mesh();
  const auto ends =
      add_line(mesh, "beam", n, make_straight({0, 0, 0}, {length, 0, 0}));
  name_point(mesh, ends[0], "root");
  name_point(mesh, ends[1], "tip");
  fe::add_empty_surface(mesh);
  return mesh;
}

/// The tip of a cantilever under a dead transverse load P, a = P L^2/EI: w/L,
/// u/L and the angle, by elliptic integrals.
TEST(FrameStatics, CantileverFollowsTheElastica)
{
  const double expected[4][4] = {{1, .3017207738, .0564332363, .4613519497},
                                 {2, .4934574804, .1606417208, .7817498316},
                                 {5, .7137915236, .3876283607, 1.2153681176},
                                 {10, .8106090249, .5549955978, 1.4302855388}};
  structure::Device device;
  // Nearly inextensible and unshearable: the error is P/EA = 1e-7.
  device.frames = {make_frame("beam", make_stiffnesses(1e8, 1e8, 1, 1, 1))};
  device.supports = {make_clamp("root")};
  device.point_loads = {make_point_load("tip", {0, 0, 1})};
  Model model(device, make_cantilever(1, 40));
  Statics statics(*model.structure);
  for (const auto& [load, w, u, angle] : expected)
  {
    statics.loads.point_loads[0].force = Signal::constant(load);
    statics.apply();
    statics.find();
    const auto tip = get_frame_position(*model.structure, statics.get_loads(),
                                        statics.u.data(), "tip");
    EXPECT_NEAR(tip[2], w, 1e-6);
    EXPECT_NEAR(1 - tip[0], u, 1e-6);
    EXPECT_NEAR(
        -compute_angle(get_frame_rotation(*model.structure, statics.get_loads(),
                                          statics.u.data(), "tip"),
                       {0, 1, 0}),
        angle, 1e-6);
  }
}
} // namespace
} // namespace taut::testing
