#include <gtest/gtest.h>

#include <cmath>

#include "structure/frames.h"
#include <boost/math/constants/constants.hpp>

// Statics of geometrically exact beams in space against references of 1e-8 or
// better that were computed with independent codes.
namespace taut::testing
{
namespace
{
constexpr double degree = boost::math::constants::degree<double>();

void raise_force(Statics& statics, const double first, const double last,
                 const unsigned int n_steps)
{
  for (unsigned int step = 1; step <= n_steps; ++step)
  {
    statics.loads.point_loads[0].force =
        Signal::constant(first + (last - first) * step / n_steps);
    statics.apply();
    statics.find();
  }
}

fe::Coordinates get_tip(const Model& model, const Statics& statics)
{
  return get_frame_position(*model.structure, statics.get_loads(),
                            statics.u.data(), "tip");
}

/// A circular arc of 45 degrees and radius 100 with a square section of 1 x 1,
/// clamped, under a dead load out of its plane; all of it turned by `turn`.
class Bend
{
public:
  explicit Bend(const unsigned int n, const Quaternion& turn = {1, 0, 0, 0})
      : turn_(turn), model_(make_device(), make_mesh(n)),
        statics_(*model_.structure)
  {
  }

  void load(const double first, const double last)
  {
    raise_force(statics_, first, last, 4);
  }
  /// Along the clamped tangent, towards the centre, out of the plane.
  fe::Coordinates compute_tip() const
  {
    return rotate_back(turn_, get_tip(model_, statics_));
  }

private:
  structure::Device make_device() const
  {
    structure::Device device;
    device.frames = {make_frame(
        "beam", make_stiffnesses(1e7, 5e6, 1e7 / 12, 1e7 / 12, 1e7 / 12))};
    device.frames[0].normal = rotate(turn_, {0, 0, 1});
    device.supports = {make_clamp("root")};
    device.point_loads = {make_point_load("tip", rotate(turn_, {0, 0, 1}))};
    return device;
  }
  fe::MeshData make_mesh(const unsigned int n) const
  {
    auto mesh = make_line_mesh();
    const auto ends =
        add_line(mesh, "beam", n,
                 [&](const double s)
                 {
                   const double angle = 45 * degree * s;
                   return rotate(turn_, {100 * std::sin(angle),
                                         100 * (1 - std::cos(angle)), 0});
                 });
    name_point(mesh, ends[0], "root");
    name_point(mesh, ends[1], "tip");
    fe::add_empty_surface(mesh);
    return mesh;
  }

  const Quaternion turn_;
  Model model_;
  Statics statics_;
};

TEST(FrameBend, ReachesTheReferenceAtThreeLoads)
{
  // The middle nodes of 64 elements lie on the arc.
  Bend bend(64);
  double last = 0;
  for (const auto& [load, x, y, z] : std::array<std::array<double, 4>, 3>{
           {{{300, 58.7791224897, 22.2447809454, 40.1918916701}},
            {{450, 52.2385580112, 18.5081789254, 48.5029273441}},
            {{600, 47.1504385736, 15.6848005330, 53.4748587918}}}})
  {
    bend.load(last, load);
    last = load;
    const auto tip = bend.compute_tip();
    EXPECT_NEAR(tip[0], x, 1e-6 * x);
    EXPECT_NEAR(tip[1], y, 1e-6 * y);
    EXPECT_NEAR(tip[2], z, 1e-6 * z);
  }
}

TEST(FrameBend, IsTheSameAfterARotationOfEverything)
{
  Bend bend(8), turned(8, make_rotation({1.1, -2.3, .7}));
  for (Bend* each : {&bend, &turned})
    each->load(0, 600);
  const auto a = bend.compute_tip(), b = turned.compute_tip();
  for (unsigned int c = 0; c < 3; ++c)
    EXPECT_NEAR(a[c], b[c], 1e-9 * 100);
}

/// The lateral buckling of a right-angle frame of thin strips: legs 240, 30 x
/// 0.6, E = 71240, nu = 0.31, torsion constant 2.16. One end is clamped, a dead
/// load acts on the other parallel to the clamped leg, positive away from the
/// clamp.
class AngleFrame
{
public:
  AngleFrame() : model_(make_device(), make_mesh()), statics_(*model_.structure)
  {
  }

  bool is_stable(const double load)
  {
    raise_force(statics_, load, load, 1);
    return statics_.count_negative_eigenvalues() == 0;
  }
  double find_critical_load(double stable, double unstable)
  {
    EXPECT_TRUE(is_stable(stable));
    EXPECT_FALSE(is_stable(unstable));
    while (std::abs(unstable - stable) > 1e-8)
    {
      const double middle = .5 * (stable + unstable);
      (is_stable(middle) ? stable : unstable) = middle;
    }
    return .5 * (stable + unstable);
  }

private:
  static structure::Device make_device()
  {
    const double modulus = 71240, shear = modulus / 2.62, area = 18;
    structure::Device device;
    device.frames = {make_frame(
        "frame", make_stiffnesses(modulus * area, shear * area, shear * 2.16,
                                  modulus * 30 * std::pow(.6, 3) / 12,
                                  modulus * .6 * std::pow(30, 3) / 12))};
    device.supports = {make_clamp("root")};
    device.point_loads = {make_point_load("tip", {1, 0, 0})};
    return device;
  }
  static fe::MeshData make_mesh()
  {
    constexpr unsigned int n = 32;
    auto mesh = make_line_mesh();
    const auto first =
        add_line(mesh, "frame", n, make_straight({0, 0, 0}, {240, 0, 0}));
    const auto second =
        add_line(mesh, "frame", n, make_straight({240, 0, 0}, {240, -240, 0}));
    name_point(mesh, first[0], "root");
    name_point(mesh, second[1], "tip");
    fe::add_empty_surface(mesh);
    return mesh;
  }

  Model model_;
  Statics statics_;
};

TEST(FrameBuckling, RightAngleFrameBucklesSidewaysAtTheReference)
{
  EXPECT_NEAR(AngleFrame().find_critical_load(.5, 1.5), 1.08751794, 1e-6);
  EXPECT_NEAR(AngleFrame().find_critical_load(-.5, -1), -.68042741, 1e-6);
}

/// The Princeton beam: a strip under a dead load of 8.896 N at an angle from
/// its stiff axis. Edgewise and flatwise displacement (m), twist (degrees).
std::array<double, 3> bend_princeton_beam(const double angle)
{
  constexpr double length = .508;
  structure::Device device;
  device.frames = {
      make_frame("beam", make_stiffnesses(2.932e6, 9.326e5, 3.221508, 2.505853,
                                          39.846133))};
  device.supports = {make_clamp("root")};
  device.point_loads = {
      make_point_load("tip", {0, std::cos(angle), std::sin(angle)})};
  auto mesh = make_line_mesh();
  const auto ends =
      add_line(mesh, "beam", 64, make_straight({0, 0, 0}, {length, 0, 0}));
  name_point(mesh, ends[0], "root");
  name_point(mesh, ends[1], "tip");
  fe::add_empty_surface(mesh);
  const Model model(device, mesh);
  Statics statics(*model.structure);
  raise_force(statics, 0, 8.896, 4);
  const auto tip = get_tip(model, statics);
  const Vector3 wide =
      rotate(get_frame_rotation(*model.structure, statics.get_loads(),
                                statics.u.data(), "tip"),
             {0, 1, 0});
  return {tip[1], tip[2], std::atan2(wide[2], wide[1]) / degree};
}

TEST(PrincetonBeam, BendsAndTwistsAsTheReference)
{
  // The stiffnesses are rounded to seven digits, a relative 2e-7 at most.
  const auto oblique = bend_princeton_beam(45 * degree);
  EXPECT_NEAR(oblique[0], .00811564, 1e-8);
  EXPECT_NEAR(oblique[1], .10593257, 3e-8);
  EXPECT_NEAR(oblique[2], -1.556328, 2e-6);
  const auto flat = bend_princeton_beam(90 * degree);
  EXPECT_NEAR(flat[1], .14245394, 3e-8);
  EXPECT_NEAR(flat[2], 0, 1e-9);
}
} // namespace
} // namespace taut::testing
