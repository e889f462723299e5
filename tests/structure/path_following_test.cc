#include <gtest/gtest.h>

#include <cmath>

#include "structure/bow.h"
#include "structure/patchwork.h"
#include "structure/paths.h"

// Static paths of films and of films on frames through limit points and
// bifurcations, forward and backward, against closed forms and references of
// 1e-8 or better.
namespace taut::testing
{
namespace
{
TEST(PathFollowing, LeesFrameSnapsAtTheReferenceLoads)
{
  const auto model = make_lee(12);
  Path path(*model->structure);
  path.follow(0, 2);
  const auto limits = path.select(Kind::limit);
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_NEAR(limits[0].parameter / 1.85465587, 1, 1e-6);
  EXPECT_NEAR(limits[1].parameter / -.93961424, 1, 1e-6);
}

/// A quarter of a square of Gent rubber, free in its plane, under the voltage
/// Et = t: Et^2 = (l^-2 - l^-8)/(1 - (2 l^2 + l^-4 - 3)/J). One bilinear cell,
/// in which every shape is homogeneous or far from it.
std::unique_ptr<Model> make_gent_square()
{
  structure::Device device;
  device.films = {make_film(material::Gent{1, 100}, 1, {{1, 1}})};
  device.films[0].tension_field = false;
  device.electrodes = {make_electrode(
      "film", Signal::ramp(make_voltage(device.films[0], 1, 1), 0,
                           std::numeric_limits<double>::infinity()))};
  device.supports = {make_support("film", {{false, false, true}}),
                     make_support("west", {{true, false, false}}),
                     make_support("south", {{false, true, false}})};
  return std::make_unique<Model>(device, make_rectangle(1, 1, 1, 1, 1));
}

double get_stretch(const Model& model, const Path& path,
                   const Path::Point& point)
{
  const auto metric = fe::compute_metric(
      model.structure->cells(),
      model.structure->compute_positions(path.get_loads(point.parameter),
                                         point.shape.data()));
  return std::sqrt(metric[0][0]);
}

TEST(PathFollowing, AGentFilmSnapsThroughAndBack)
{
  const auto model = make_gent_square();
  Path path(*model->structure);
  // Relative to a stress of 1e-3 moduli; those that cancel reach 1e4 moduli.
  path.options.newton.tolerance = 1e-7;
  path.follow(0, 1);
  auto limits = path.select(Kind::limit);
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_NEAR(limits[0].parameter, .68936322, 5e-9);
  EXPECT_NEAR(limits[1].parameter, .27460055, 5e-9);
  // The parameter is stationary: half of the digits.
  EXPECT_NEAR(get_stretch(*model, path, limits[0]), 1.26380444, 1e-4);
  EXPECT_NEAR(get_stretch(*model, path, limits[1]), 5.07425996, 1e-3);
  auto landings = path.select(Kind::landing);
  ASSERT_EQ(landings.size(), 1u);
  EXPECT_NEAR(get_stretch(*model, path, landings[0]), 7.02628063, 1e-6);

  path.follow(1, 0);
  limits = path.select(Kind::limit);
  landings = path.select(Kind::landing);
  ASSERT_EQ(limits.size(), 2u);
  ASSERT_EQ(landings.size(), 1u);
  EXPECT_NEAR(limits[0].parameter, .27460055, 5e-9);
  EXPECT_NEAR(landings[0].parameter, .27460055, 5e-9);
  EXPECT_LT(get_stretch(*model, path, landings[0]), 1.05);
}

/// Where paths of bows begin: a film without tension would not keep its ends in
/// their plane.
constexpr double unstretched = .01;

/// A bow whose film is stretched from 1 to the pre-stretch in the time from 0
/// to 1, and then has the voltage Et = t - 1.
std::unique_ptr<Model> make_stretched_bow(const Bow& bow)
{
  constexpr double endless = std::numeric_limits<double>::infinity();
  auto device = make_bow_device(bow);
  device.films[0].pre_stretch_share = Signal::ramp(1, 0, 1);
  device.electrodes[0].voltage =
      Signal::ramp(make_voltage(device.films[0], 1, bow.modulus), 1, endless);
  return std::make_unique<Model>(device, make_bow_mesh(bow));
}

Path make_bow_path(const Model& model, const double side)
{
  Path path(*model.structure);
  path.options.takes_stable_branch = true;
  path.options.direction.resize(path.u.size());
  const auto& free = model.structure->free_unknowns();
  std::vector<bool> turns(model.structure->nodes().n_local, false);
  for (const auto& rotation : model.structure->nodes().rotations)
    turns[rotation.vector] = turns[rotation.scalar()] = true;
  for (std::size_t i = 0; i < free.size(); ++i)
    if (free[i] % 3 == 2 && !turns[free[i] / 3])
      path.options.direction[i] = side;
  return path;
}

TEST(PathFollowing, AFilmThatIsStretchedInItsFrameBendsIt)
{
  // K_bb is 1 at the pre-stretch at which the frame buckles.
  constexpr double threshold = 1.6798174067;
  for (const double side : {1., -1.})
  {
    Bow bow;
    bow.pre_stretch = 3;
    bow.stiffness_number = bow.pre_stretch / threshold;
    const auto model = make_stretched_bow(bow);
    Path path = make_bow_path(*model, side);
    path.follow(unstretched, 1);
    const auto bifurcations = path.select(Kind::bifurcation);
    ASSERT_EQ(bifurcations.size(), 1u);
    // The beam yields by 1e-7 of its curvature.
    EXPECT_NEAR(1 + bifurcations[0].parameter * (bow.pre_stretch - 1),
                threshold, 3e-6);
    EXPECT_EQ(path.select(Kind::branch_switch).size(), 1u);
    for (const auto& point : path.points)
      EXPECT_EQ(point.negative_eigenvalues, 0);
    const auto middle = get_frame_position(*model->structure, path.get_loads(1),
                                           path.u.data(), "beam_middle");
    EXPECT_GT(side * middle[2], .1 * bow.length());
    // And it straightens again when the film is let go.
    path.follow(1, unstretched);
    const auto meetings = path.select(Kind::bifurcation);
    ASSERT_EQ(meetings.size(), 1u);
    EXPECT_NEAR(1 + meetings[0].parameter * (bow.pre_stretch - 1), threshold,
                3e-6);
    for (const auto& point : path.points)
      EXPECT_EQ(point.negative_eigenvalues, 0) << point.parameter;
  }
}

struct BowRow
{
  double pre_stretch, slope, stretch, middle;
};

TEST(PathFollowing, TheStableBranchEndsInTheExactRestShape)
{
  for (const auto& row : {BowRow{2, .9030373789, 1.6091813971, .2636755134},
                          BowRow{3, 1.5264068249, 1.4507784387, .3765497001},
                          BowRow{4, 1.7630879393, 1.3510502791, .3968142391}})
  {
    Bow bow;
    bow.pre_stretch = row.pre_stretch;
    const auto model = make_stretched_bow(bow);
    Path path = make_bow_path(*model, 1);
    EXPECT_EQ(path.follow(unstretched, 1).end, time::CurveEnd::reached);
    const auto shape =
        measure_bow(*model->structure, path.get_loads(1), path.u.data());
    EXPECT_NEAR(shape.slope, row.slope, 1e-5);
    EXPECT_NEAR(shape.chord / bow.film_length, row.stretch, 1e-5);
    EXPECT_NEAR(shape.middle / bow.length(), row.middle, 1e-5);
  }
}

TEST(PathFollowing, AVoltageFlattensTheBowAndLetsItBendAgain)
{
  Bow bow;
  bow.pre_stretch = 3;
  const auto model = make_stretched_bow(bow);
  Path path = make_bow_path(*model, 1);
  path.follow(unstretched, 1);
  path.options.parameters = {1.2, 1.4, 1.6, 1.8};
  const std::vector<double> slopes{1.5091254270, 1.4476943834, 1.2942757789,
                                   .7364634942};
  const auto measure = [&](const Path::Point& point)
  {
    return measure_bow(*model->structure, path.get_loads(point.parameter),
                       point.shape.data())
        .slope;
  };
  for (const bool forward : {true, false})
  {
    path.follow(forward ? 1 : 1.9, forward ? 1.9 : 1);
    const auto bifurcations = path.select(Kind::bifurcation);
    ASSERT_EQ(bifurcations.size(), 1u);
    EXPECT_NEAR(bifurcations[0].parameter, 1.8446884888, 1e-6);
    EXPECT_EQ(path.select(Kind::branch_switch).size(), 1u);
    const auto requested = path.select(Kind::requested);
    ASSERT_EQ(requested.size(), slopes.size());
    for (std::size_t i = 0; i < slopes.size(); ++i)
      EXPECT_NEAR(measure(requested[forward ? i : slopes.size() - 1 - i]),
                  slopes[i], 1e-5);
    for (const auto& point : path.points)
      EXPECT_EQ(point.negative_eigenvalues, 0);
    EXPECT_NEAR(measure(path.points[forward ? path.points.size() - 1 : 0]), 0,
                1e-9);
  }
}
/// An eighth of a closed neo-Hookean sphere; modulus, radius and thickness are
/// 1, so that p = 2 (l^-1 - l^-7), largest at l = 7^(1/6).
TEST(PathFollowing, ABalloonHasItsLargestPressureAtTheReference)
{
  structure::Device device;
  device.films = {make_film(material::NeoHookean{1}, 1, {{1, 1}})};
  device.films[0].axis = {{.3, .5, -.8}};
  device.supports = {make_support("x0", {{true, false, false}}),
                     make_support("y0", {{false, true, false}}),
                     make_support("z0", {{false, false, true}})};
  device.pressures = {make_pressure("film", make_slope(1))};
  const Model model(device, make_octant(8));
  Path path(*model.structure);
  path.options.steps = 4;
  path.options.largest_step = .3;
  path.options.most_points = 8;
  path.follow(.5, 2);
  const auto limits = path.select(Kind::limit);
  ASSERT_EQ(limits.size(), 1u);
  EXPECT_NEAR(limits[0].parameter, 1.2394629024, 1.2e-6);
  EXPECT_EQ(path.points.back().negative_eigenvalues, 1);
}

/// A flat neo-Hookean membrane whose rim is clamped at the radius 1, with
/// modulus and thickness 1: the heights of its apex wherever the path passes
/// the pressure, on a quarter with 3 n^2 cells.
std::vector<Path::Point> inflate(const double pressure, const unsigned int n,
                                 std::vector<double>& heights)
{
  structure::Device device;
  device.films = {make_film(material::NeoHookean{1}, 1, {{1, 1}})};
  device.supports = {make_support("rim", {{true, true, true}}),
                     make_support("x0", {{true, false, false}}),
                     make_support("y0", {{false, true, false}})};
  device.pressures = {make_pressure("film", make_slope(1))};
  const Model model(device, make_quarter_disc(n));
  Path path(*model.structure);
  path.options.parameters = {pressure};
  path.options.steps = 3;
  path.options.largest_step = .3;
  path.options.most_points = 9;
  const auto& free = model.structure->free_unknowns();
  std::size_t apex = 0;
  for (std::size_t i = 0; i < free.size(); ++i)
  {
    const auto& X = model.structure->nodes().mesh_position[free[i] / 3];
    if (free[i] % 3 != 2)
      continue;
    // A flat film without tension has no stiffness, a bowl has.
    path.u[i] = .6 * (1 - X[0] * X[0] - X[1] * X[1]);
    if (std::hypot(X[0], X[1]) < 1e-9)
      apex = i;
  }
  path.follow(1.2, 2.4);
  for (const auto& point : path.points)
    heights.push_back(point.shape[apex]);
  return path.points;
}

TEST(PathFollowing, AnInflatedMembraneGoesPastItsLargestPressure)
{
  // At the polar stretch 3, beyond the limit point.
  constexpr double pressure = 1.8079220953, reference = 1.4888464333;
  double errors[2];
  for (const unsigned int level : {0, 1})
  {
    std::vector<double> heights;
    const auto points = inflate(pressure, 8 << level, heights);
    unsigned int n_limits = 0;
    errors[level] = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      n_limits += points[i].kind == Kind::limit;
      if (points[i].kind != Kind::requested || n_limits == 0)
        continue;
      errors[level] = std::abs(heights[i] - reference);
      // The curve falls by 0.39 per height there.
      if (level == 1)
      {
        EXPECT_LT(.39 * errors[level], 1e-6 * pressure);
      }
      EXPECT_EQ(points[i].negative_eigenvalues, 1);
    }
    EXPECT_EQ(n_limits, 1u);
  }
  // Energies of Q2 converge with the fourth order.
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 4, .2);
}
} // namespace
} // namespace taut::testing
