// Homogeneous actuation in a mesh: closed forms of equibiaxial and pure shear
// films under voltage. Units: modulus, thickness and square are 1.
#include <taut/base/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/statics.h"
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

namespace taut
{
namespace
{
constexpr double modulus = 1;
/// Newton's tolerance where springs and voltage nearly cancel: it is relative
/// to the forces that are left, their round-off is not. Newton overshoots it.
constexpr double loose = 1e-6;

template <class Function>
double find_root(const Function& function, const double low, const double high)
{
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(46),
      iterations);
  return (bracket.first + bracket.second) / 2;
}

/// A distorted square of 2 by 2 cells in its plane, on rollers at all sides;
/// east and north move by the unit amplitude or, with `is_free`, are free.
structure::Device make_device(const material::Spring& spring,
                              const std::array<double, 2>& pre_stretch,
                              const std::array<bool, 2>& is_free)
{
  structure::Device device;
  device.films = {testing::make_film(spring, 1, pre_stretch)};
  // The closed forms go on where the film is pressed.
  device.films[0].tension_field = false;
  device.electrodes = {testing::make_electrode("film", Signal())};
  device.supports = {testing::make_support("film", {{false, false, true}}),
                     testing::make_support("west", {{true, false, false}}),
                     testing::make_support("south", {{false, true, false}})};
  if (!is_free[0])
    device.supports.push_back(testing::make_support(
        "east", {{true, false, false}}, {{"1", "0", "0"}}));
  if (!is_free[1])
    device.supports.push_back(testing::make_support(
        "north", {{false, true, false}}, {{"0", "1", "0"}}));
  return device;
}

double get_voltage(const structure::Device& device, const double field)
{
  return testing::make_voltage(device.films[0], field, modulus);
}

/// An equibiaxial film whose edges are held.
class HeldSquare
{
public:
  explicit HeldSquare(const material::Spring& spring)
      : model_(make_device(spring, {{1, 1}}, {{false, false}}),
               testing::make_sheet_mesh()),
        statics_(*model_.structure)
  {
  }

  /// Force on the east edge.
  double compute_force(const double stretch, const double e)
  {
    statics_.set_voltage(get_voltage(model_.structure->device(), std::sqrt(e)));
    for (const unsigned int support : {3, 4})
      statics_.set_amplitude(support, stretch - 1);
    const auto& X = model_.structure->nodes().mesh_position;
    const auto& free = model_.structure->free_unknowns();
    for (std::size_t i = 0; i < free.size(); ++i)
      statics_.u[i] = (stretch - 1) * X[free[i] / 3][free[i] % 3];
    statics_.find(loose);
    return statics_.get_reaction(3)[0];
  }
  /// e at which the edges carry nothing; forces are affine in e.
  double find_free_field(const double stretch)
  {
    const double without = compute_force(stretch, 0);
    return without / (without - compute_force(stretch, 1));
  }
  /// The stretch at which the free field is largest (sign 1) or smallest.
  std::pair<double, double> find_extremum(const int sign, const double low,
                                          const double high)
  {
    const auto [stretch, value] = boost::math::tools::brent_find_minima(
        [&](const double l) { return -sign * find_free_field(l); }, low, high,
        50);
    return {stretch, std::sqrt(-sign * value)};
  }

private:
  testing::Model model_;
  testing::Statics statics_;
};

TEST(Equibiaxial, NeoHookeanForceAndPullInAreThoseOfTheClosedForm)
{
  HeldSquare square(material::NeoHookean{1});
  for (const double l : {1.1, 1.5, 2.})
    for (const double e : {0., .3})
      EXPECT_NEAR(square.compute_force(l, e),
                  l - std::pow(l, -5) - e * std::pow(l, 3), 1e-11);
  const auto [stretch, field] = square.find_extremum(1, 1.1, 1.5);
  // A maximum is found to the root of round-off, its value to round-off.
  EXPECT_NEAR(stretch, std::pow(4, 1. / 6), 1e-6);
  EXPECT_NEAR(field, .6873648185, 1e-10);
}

TEST(Equibiaxial, GentPeakValleyAndSnapAreThoseOfTheClosedForm)
{
  // e = (l^-2 - l^-8)/(1 - (2 l^2 + l^-4 - 3)/100), numbers to 1e-8.
  HeldSquare square(material::Gent{1, 100});
  const auto peak = square.find_extremum(1, 1.1, 1.5);
  EXPECT_NEAR(peak.first, 1.26380444, 1e-6);
  EXPECT_NEAR(peak.second, .68936322, 1e-8);
  const auto valley = square.find_extremum(-1, 4, 6);
  EXPECT_NEAR(valley.first, 5.07425996, 1e-5);
  EXPECT_NEAR(valley.second, .27460055, 1e-8);
  const double e = peak.second * peak.second;
  const double snapped = find_root(
      [&](const double l) { return square.find_free_field(l) - e; }, 6, 7.1);
  EXPECT_NEAR(snapped, 7.02628063, 1e-8);
}

/// A square under the dead load s = 1 on its free edges.
structure::Device make_dead_loaded()
{
  auto device = make_device(material::NeoHookean{1}, {{1, 1}}, {{true, true}});
  structure::EdgeLoad load;
  load.force = Signal::constant(1);
  load.name = "pull along x";
  load.groups = {"east"};
  load.direction = {{1, 0, 0}};
  device.edge_loads.push_back(load);
  load.name = "pull along y";
  load.groups = {"north"};
  load.direction = {{0, 1, 0}};
  device.edge_loads.push_back(load);
  return device;
}

constexpr double dead_load_pull_in = .3585747898;

/// The stretch at which e = l^-2 - l^-8 - l^-3, between two bounds.
double find_dead_load_stretch(const double field, const double low,
                              const double high)
{
  return find_root(
      [=](const double l) {
        return std::pow(l, -2) - std::pow(l, -8) - std::pow(l, -3) -
               field * field;
      },
      low, high);
}

TEST(DeadLoad, StretchFollowsTheClosedFormUpToPullIn)
{
  auto device = make_dead_loaded();
  const double voltage = get_voltage(device, 1);
  device.electrodes[0].voltage = Signal::ramp(voltage, 0, voltage);
  testing::Model model(device, testing::make_sheet_mesh());
  auto& structure = *model.structure;
  structure::LoadHistory history(device);
  structure::Equilibrium problem(structure, history,
                                 structure::Networks::relaxed, nullptr);
  std::vector<double> u(structure.n_free(), 0.);
  const auto get_stretch = [&](const double field)
  {
    const auto metric = fe::compute_metric(
        structure.cells(),
        structure.compute_positions(history.at(field), u.data()));
    EXPECT_LT(
        testing::compute_deviation(metric, {{metric[0][0], metric[0][0], 0}}),
        1e-6);
    return std::sqrt(metric[0][0]);
  };
  time::PathOptions options;
  options.first_step = options.largest_step = .1;
  options.smallest_step = 1e-9;
  options.newton.max_step = .3;
  const auto ignore = [](double, const double*) {};
  history.enter_interval(0);
  time::find_equilibrium(problem, 0, u.data(), options.newton);
  EXPECT_NEAR(get_stretch(0), 1.2851990332, 1e-9);
  const double below = dead_load_pull_in - 1e-6;
  time::follow_path(problem, 0, below, u.data(), options, ignore);
  // The stretch moves with the root of the distance to the pull-in.
  EXPECT_NEAR(get_stretch(below), find_dead_load_stretch(below, 1.3, 1.7463004),
              1e-6);
  double reached = below;
  EXPECT_THROW(time::follow_path(problem, below, .4, u.data(), options,
                                 [&](const double field, const double*)
                                 { reached = field; }),
               SolverFailed);
  EXPECT_NEAR(reached, dead_load_pull_in, 1e-7);
}

TEST(DeadLoad, BranchBeyondPullInIsUnstable)
{
  testing::Model model(make_dead_loaded(), testing::make_sheet_mesh());
  auto& structure = *model.structure;
  testing::Statics statics(structure);
  const double field = dead_load_pull_in - 1e-4;
  statics.set_voltage(get_voltage(structure.device(), field));
  const auto find_at = [&](const double stretch)
  {
    const auto& free = structure.free_unknowns();
    for (std::size_t i = 0; i < free.size(); ++i)
      statics.u[i] = (stretch - 1) *
                     structure.nodes().mesh_position[free[i] / 3][free[i] % 3];
    statics.find();
    EXPECT_LT(
        testing::compute_deviation(statics.compute_metric(),
                                   {{stretch * stretch, stretch * stretch, 0}}),
        1e-8);
  };
  find_at(find_dead_load_stretch(field, 1.3, 1.7463));
  EXPECT_EQ(statics.count_negative_eigenvalues(), 0);
  find_at(find_dead_load_stretch(field, 1.7463005, 2.2));
  EXPECT_EQ(statics.count_negative_eigenvalues(), 1);
}

double compute_stretch(testing::Statics& statics)
{
  return std::sqrt(statics.compute_metric()[0][0]);
}

TEST(PureShear, WithoutLoadTensionAcrossIsLostAtTheReferenceFields)
{
  for (const auto& [width, expected] :
       {std::pair<double, double>{2., .49607837}, {3., .33310463}})
  {
    // Stretched to (w, w) in the mesh, width held, length free.
    testing::Model model(
        make_device(material::NeoHookean{1}, {{width, width}}, {{true, false}}),
        testing::make_sheet_mesh());
    auto& structure = *model.structure;
    testing::Statics statics(structure);
    const auto compute_tension_across = [&](const double field)
    {
      statics.set_voltage(get_voltage(structure.device(), field));
      statics.find(loose);
      return statics.get_reaction(3)[1];
    };
    // Linear between two fields 1e-6 from the root: 1e-9.
    const double low = expected * (1 - 1e-6), high = expected * (1 + 1e-6);
    const double before = compute_tension_across(low);
    const double stretch_before = compute_stretch(statics);
    const double after = compute_tension_across(high);
    const double share = before / (before - after);
    EXPECT_NEAR(low + share * (high - low), expected, 1e-8);
    EXPECT_NEAR(stretch_before +
                    share * (compute_stretch(statics) - stretch_before),
                width, 1e-5);
  }
}

TEST(PureShear, StretchUnderLoadFollowsTheClosedForm)
{
  // e = w^-2 - w^-4 l^-4 - s/(l w^2).
  const double width = 1.7;
  for (const double s : {.3, .7})
    for (const double l : {1.6, 2.5})
    {
      const double e = std::pow(width, -2) - std::pow(width * l, -4) -
                       s / (l * width * width);
      auto device =
          make_device(material::NeoHookean{1}, {{l, width}}, {{true, false}});
      structure::EdgeLoad load;
      load.name = "pull";
      load.groups = {"east"};
      load.direction = {{1, 0, 0}};
      load.force = Signal::constant(s / width);
      device.edge_loads = {load};
      device.electrodes[0].voltage =
          Signal::constant(get_voltage(device, std::sqrt(e)));
      testing::Model model(device, testing::make_sheet_mesh());
      testing::Statics statics(*model.structure);
      for (auto& displacement : statics.u)
        displacement = .02;
      statics.find();
      EXPECT_LT(testing::compute_deviation(statics.compute_metric(),
                                           {{l * l, width * width, 0}}),
                1e-10);
    }
}
} // namespace
} // namespace taut
