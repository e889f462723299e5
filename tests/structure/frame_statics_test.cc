#include <gtest/gtest.h>

#include <cmath>

#include "structure/frames.h"
#include <boost/math/constants/constants.hpp>

// Statics of geometrically exact beams in a plane against closed forms and
// references of 1e-8 or better that were computed with independent codes.
namespace taut::testing
{
namespace
{
constexpr double pi = boost::math::constants::pi<double>();

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

/// Position of a point and its rotation about `axis` (rad).
struct PointState
{
  fe::Coordinates x;
  Quaternion q;
};

PointState get_point(const Model& model, const Statics& statics,
                     const std::string& group)
{
  return {get_frame_position(*model.structure, statics.get_loads(),
                             statics.u.data(), group),
          get_frame_rotation(*model.structure, statics.get_loads(),
                             statics.u.data(), group)};
}

double compute_distance(const fe::Coordinates& a, const fe::Coordinates& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The equilibrium of a cantilever under a transverse tip load, in equal steps.
PointState bend_cantilever(const structure::BeamSection& section,
                           const unsigned int n, const double load)
{
  structure::Device device;
  device.frames = {make_frame("beam", section)};
  device.supports = {make_clamp("root")};
  device.point_loads = {make_point_load("tip", {0, 0, 1})};
  const Model model(device, make_cantilever(1, n));
  Statics statics(*model.structure);
  constexpr unsigned int n_steps = 4;
  for (unsigned int step = 1; step <= n_steps; ++step)
  {
    statics.loads.point_loads[0].force =
        Signal::constant(load * step / n_steps);
    statics.apply();
    statics.find();
  }
  return get_point(model, statics, "tip");
}

/// The tip of a cantilever under a dead transverse load P, a = P L^2/EI: w/L,
/// u/L and the angle, by elliptic integrals.
struct ElasticaRow
{
  double load, w, u, angle;
};
const std::array<ElasticaRow, 4> elastica{
    {{1, .3017207738, .0564332363, .4613519497},
     {2, .4934574804, .1606417208, .7817498316},
     {5, .7137915236, .3876283607, 1.2153681176},
     {10, .8106090249, .5549955978, 1.4302855388}}};

TEST(FrameStatics, CantileverFollowsTheElastica)
{
  for (const auto& row : elastica)
  {
    const auto tip = bend_cantilever(slender_beam, 40, row.load);
    EXPECT_NEAR(tip.x[2], row.w, 1e-6);
    EXPECT_NEAR(1 - tip.x[0], row.u, 1e-6);
    EXPECT_NEAR(-compute_angle(tip.q, {0, 1, 0}), row.angle, 1e-6);
  }
}

TEST(FrameStatics, QuadraticBeamsConvergeWithFourthOrder)
{
  const auto exact = bend_cantilever(slender_beam, 128, 5);
  const auto compute_error = [&](const unsigned int n)
  {
    const auto tip = bend_cantilever(slender_beam, n, 5);
    return std::array<double, 2>{
        compute_distance(tip.x, exact.x),
        std::abs(
            compute_angle(multiply(conjugate(tip.q), exact.q), {0, 1, 0}))};
  };
  const auto coarse = compute_error(8), fine = compute_error(16);
  for (unsigned int i = 0; i < 2; ++i)
    EXPECT_NEAR(std::log2(coarse[i] / fine[i]), 4, .2) << i;
}

TEST(FrameStatics, ThinBeamsDoNotLock)
{
  // The error of a coarse mesh, against a fine one of the same beam.
  const auto compute_error = [](const double thickness)
  {
    structure::RectangularSection rectangle;
    rectangle.width = 1;
    rectangle.thickness = thickness;
    rectangle.young_modulus = 12 / std::pow(thickness, 3); // EI = 1
    const auto section = structure::make_section(rectangle);
    return compute_distance(bend_cantilever(section, 4, 5).x,
                            bend_cantilever(section, 64, 5).x);
  };
  // From a thick beam to a thin one shear and stretch lose their part in the
  // displacement; the error of bending alone remains.
  const double thick = compute_error(.1), thin = compute_error(1e-3);
  EXPECT_LT(thin, 1.5 * thick);
  EXPECT_NEAR(compute_error(1e-4), thin, .01 * thin);
}

/// A beam of length 10 along `direction` that a moment about `axis` at its tip
/// rolls up, in steps.
class RollUp
{
public:
  static constexpr double length = 10, bending = 100;

  RollUp(const unsigned int n, const bool follower, const Quaternion& turn)
      : axis_(rotate(turn, {0, 1, 0})), turn_(turn),
        model_(make_device(follower), make_mesh(n)), statics_(*model_.structure)
  {
  }

  void roll(const double turns)
  {
    const auto n_steps = static_cast<unsigned int>(std::ceil(8 * turns));
    for (unsigned int step = 1; step <= n_steps; ++step)
    {
      statics_.loads.point_loads[0].moment =
          Signal::constant(turns * 2 * pi * bending / length * step / n_steps);
      statics_.apply();
      statics_.find();
    }
  }
  /// In the axes of the beam.
  fe::Coordinates compute_tip() const
  {
    return rotate_back(turn_, get_point(model_, statics_, "tip").x);
  }
  /// The turn of the tip, summed along the beam.
  double compute_angle_of_tip() const
  {
    double angle = 0;
    for (unsigned int i = 0; i < n_pieces; ++i)
      angle += compute_angle(
          multiply(conjugate(get_point(model_, statics_, get_name(i)).q),
                   get_point(model_, statics_, get_name(i + 1)).q),
          axis_);
    return angle;
  }

private:
  static constexpr unsigned int n_pieces = 8;

  static std::string get_name(const unsigned int i)
  {
    return i == n_pieces ? "tip" : "point " + std::to_string(i);
  }
  structure::Device make_device(const bool follower) const
  {
    structure::Device device;
    device.frames = {make_frame(
        "beam", make_stiffnesses(1e4, 5e3, bending, bending, bending))};
    device.frames[0].normal = rotate(turn_, {0, 0, 1});
    device.supports = {make_clamp("point 0")};
    auto load = make_point_load("tip", {0, 0, 0});
    load.moment_direction = axis_;
    load.moment = Signal::constant(1);
    load.follower = follower;
    device.point_loads = {load};
    return device;
  }
  fe::MeshData make_mesh(const unsigned int n) const
  {
    auto mesh = make_line_mesh();
    for (unsigned int i = 0; i < n_pieces; ++i)
    {
      const double begin = length * i / n_pieces,
                   end = length * (i + 1) / n_pieces;
      const auto ends = add_line(mesh, "beam", n / n_pieces,
                                 make_straight(rotate(turn_, {begin, 0, 0}),
                                               rotate(turn_, {end, 0, 0})));
      name_point(mesh, ends[0], get_name(i));
      if (i + 1 == n_pieces)
        name_point(mesh, ends[1], get_name(n_pieces));
    }
    fe::add_empty_surface(mesh);
    return mesh;
  }

  const Vector3 axis_;
  const Quaternion turn_;
  Model model_;
  Statics statics_;
};

const Quaternion no_turn{1, 0, 0, 0};
const Quaternion large_turn = make_rotation({1.1, -2.3, .7});

TEST(FrameRollUp, TwoTurnsCloseTheCircleTwice)
{
  RollUp beam(80, false, no_turn);
  beam.roll(2);
  EXPECT_NEAR(beam.compute_angle_of_tip(), 4 * pi, 1e-5);
  for (const double component : beam.compute_tip())
    EXPECT_NEAR(component, 0, 1e-5 * RollUp::length);
}

TEST(FrameRollUp, TipLiesOnTheCircle)
{
  // A turn and a quarter: kappa = 2.5 pi/L.
  RollUp beam(80, false, no_turn);
  beam.roll(1.25);
  const double radius = RollUp::length / (2.5 * pi);
  const auto tip = beam.compute_tip();
  EXPECT_NEAR(beam.compute_angle_of_tip(), 2.5 * pi, 1e-6);
  EXPECT_NEAR(tip[0], radius, 1e-6 * RollUp::length);
  EXPECT_NEAR(tip[2], -radius, 1e-6 * RollUp::length);
}

TEST(FrameRollUp, ConvergesWithFourthOrder)
{
  const auto compute_error = [](const unsigned int n)
  {
    RollUp beam(n, false, no_turn);
    beam.roll(2);
    return std::array<double, 2>{
        compute_distance(beam.compute_tip(), {0, 0, 0}),
        std::abs(beam.compute_angle_of_tip() - 4 * pi)};
  };
  const auto coarse = compute_error(16), fine = compute_error(32);
  for (unsigned int i = 0; i < 2; ++i)
    EXPECT_NEAR(std::log2(coarse[i] / fine[i]), 4, .3) << i;
}

TEST(FrameRollUp, FollowerMomentsAndRotatedBeamsGiveTheSame)
{
  RollUp reference(16, false, no_turn);
  reference.roll(2);
  for (const bool follower : {false, true})
  {
    RollUp beam(16, follower, large_turn);
    beam.roll(2);
    EXPECT_NEAR(beam.compute_angle_of_tip(), reference.compute_angle_of_tip(),
                1e-9);
    EXPECT_LT(compute_distance(beam.compute_tip(), reference.compute_tip()),
              1e-9 * RollUp::length);
  }
}
} // namespace
} // namespace taut::testing
