// Electromechanical pull-in against the closed forms of homogeneous neo-Hookean
// films. Units: modulus, thickness and square are 1.
#include <taut/base/exceptions.h>
#include <taut/structure/watches.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/pull_in.h"
#include "structure/viscous_films.h"
#include "structure/watch_refusal.h"

namespace taut::pull_in
{
namespace
{
using testing::find_root;
using testing::make_pull_in;

structure::Device make_device(const std::array<double, 2>& pre_stretch)
{
  auto device = testing::make_sheet({{material::NeoHookean{1}}, {}, {}, 1}, {});
  device.films[0].pre_stretch = pre_stretch;
  device.films[0].tension_field = false;
  // The field number is the time.
  const double voltage = testing::make_voltage(device.films[0], 1, 1);
  device.electrodes = {
      testing::make_electrode("film", Signal::ramp(voltage, 0, 10 * voltage))};
  device.events = {make_pull_in()};
  return device;
}

/// A sheet that can be stretched evenly from the mesh.
class Sheet
{
public:
  explicit Sheet(
      const structure::Device& device,
      const structure::Networks networks = structure::Networks::as_given)
      : model_(device, testing::make_sheet_mesh()),
        system_(*model_.structure, {}), probes_(system_),
        watches_(system_, probes_, networks),
        state_(system_.make_initial_state(0, structure::Start::unrelaxed, false,
                                          {}))
  {
  }

  double compute_margin(const double field, const double stretch_x,
                        const double stretch_y)
  {
    return watches_.compute_margin(0, field, stretch(stretch_x, stretch_y));
  }
  structure::EventReport report(const double field, const double stretch_x,
                                const double stretch_y)
  {
    return watches_.report(0, field, stretch(stretch_x, stretch_y));
  }

private:
  const double* stretch(const double x, const double y)
  {
    const auto& structure = *model_.structure;
    const auto& free = structure.free_unknowns();
    for (std::size_t i = 0; i < free.size(); ++i)
      state_[i] = ((free[i] % 3 == 0 ? x : y) - 1) *
                  structure.nodes().mesh_position[free[i] / 3][free[i] % 3];
    return state_.data();
  }

  testing::Model model_;
  structure::QuasiStaticSystem system_;
  structure::Probes probes_;
  structure::Watches watches_;
  std::vector<double> state_;
};

/// d(nominal stress)/d(stretch) over the same without field.
double compute_share(const double l, const double e)
{
  const double without = 1 + 5 * std::pow(l, -6);
  const double with = without - 3 * e * l * l;
  return with / (std::abs(with) + 3 * e * l * l);
}

TEST(PullIn, MarginIsTheStiffnessLeftOfAnEquibiaxialFilm)
{
  Sheet sheet(make_device({{1, 1}}));
  EXPECT_EQ(sheet.compute_margin(0, 1.1, 1.1), 1);
  // In and out of equilibrium, before and beyond the limit point.
  for (const double l : {1.1, 1.25, 1.3, 1.5})
    for (const double field : {.2, .6, .7})
      EXPECT_NEAR(sheet.compute_margin(field, l, l),
                  compute_share(l, field * field), 1e-10);
}

TEST(PullIn, LimitPointsAreThoseOfTheClosedForms)
{
  // e = l^-2 - l^-8 - s l^-3 under the nominal stress s of dead loads, which
  // do not enter the tangent of a stretched film.
  Sheet sheet(make_device({{1, 1}}));
  struct Reference
  {
    double load, stretch, field;
  };
  for (const auto& [s, stretch, field] :
       {Reference{0, 1.2599210499, .6873648185},
        Reference{1, 1.7463004355, .3585747898}})
  {
    const auto get_field = [s = s](const double l) {
      return std::sqrt(std::pow(l, -2) - std::pow(l, -8) - s * std::pow(l, -3));
    };
    const double root =
        find_root([&](const double l)
                  { return sheet.compute_margin(get_field(l), l, l); },
                  1.29 - .1 * (1 - s), 1.9);
    EXPECT_NEAR(root, stretch, 1e-8);
    EXPECT_NEAR(get_field(root), field, 1e-9);
  }
}

TEST(PullIn, HeldWidthHasNone)
{
  // Width w, length free, up to the loss of tension at l = w.
  constexpr double w = 2;
  auto device = make_device({{1, w}});
  device.supports.push_back(
      testing::make_support("north", {{false, true, false}}));
  Sheet sheet(device);
  for (const double l : {1.2, 1.5, 1.8, 2.})
  {
    const double e = std::pow(w, -2) - std::pow(w * l, -4);
    const double without = 1 + 3 / (std::pow(l, 4) * w * w);
    const double margin = sheet.compute_margin(std::sqrt(e), l, 1);
    EXPECT_NEAR(margin, 1 - e * w * w / without, 1e-10);
    EXPECT_GT(margin, 0);
  }
}

TEST(PullIn, NetworksAreFrozenUnlessTheFilmIsRelaxed)
{
  // Half of the modulus in a network with A = 1, which is that of a spring.
  auto device = make_device({{1, 1}});
  auto& material = device.films[0].material;
  material.springs = {material::NeoHookean{.5}};
  material.networks = {{material::NeoHookean{.5}, 1}};
  constexpr double l = 1.1, e = .16;
  EXPECT_NEAR(Sheet(device).compute_margin(std::sqrt(e), l, l),
              compute_share(l, e), 1e-10);
  Sheet relaxed(device, structure::Networks::relaxed);
  EXPECT_NEAR(relaxed.compute_margin(std::sqrt(e), l, l),
              compute_share(l, 2 * e), 1e-10);
}

TEST(PullIn, OfAWrinkledFilmIsThatOfItsRelaxedEnergy)
{
  // With the width free to wrinkle, w^4 = l^-2/(1 - e l^2) and
  // W = l^2/2 + q/l, q^2 = 1 - e l^2. Both states, with and without field,
  // are wider than the place of .7.
  auto device = make_device({{1, .7}});
  device.films[0].tension_field = true;
  device.supports.push_back(
      testing::make_support("north", {{false, true, false}}));
  Sheet sheet(device);
  const auto compute_curvature = [](const double l, const double e)
  {
    const double q = std::sqrt(1 - e * l * l);
    return 1 + 2 * q / std::pow(l, 3) + e / (q * l) - e * e * l / (q * q * q);
  };
  for (const double l : {1.3, 1.5})
    for (const double e : {.1, .25, .4})
    {
      const double k = compute_curvature(l, e), bare = compute_curvature(l, 0);
      // The cost of wrinkles is 1e-6 of the modulus.
      EXPECT_NEAR(sheet.compute_margin(std::sqrt(e), l, 1),
                  k / (std::abs(k) + std::abs(k - bare)), 1e-4)
          << l << " " << e;
    }
}

TEST(PullIn, ReportSaysWhere)
{
  auto device = make_device({{1, 1}});
  Sheet sheet(device);
  const auto report = sheet.report(.5, 1.1, 1.1);
  EXPECT_EQ(report.place, "film");
  EXPECT_NEAR(report.value, compute_share(1.1, .25), 1e-10);
  EXPECT_EQ(report.value, report.margin);
  EXPECT_EQ(report.threshold, 0);
  EXPECT_TRUE(std::isfinite(report.point[0]));
  EXPECT_TRUE(std::isnan(report.direction[0]));
}

std::string get_refusal(const structure::Device& device)
{
  testing::Model model(device, testing::make_sheet_mesh());
  structure::QuasiStaticSystem system(*model.structure, {});
  return testing::get_watch_refusal(system);
}

TEST(PullIn, RefusesWhatHasNone)
{
  const auto expect = [](const auto& spoil, const char* says)
  {
    auto device = make_device({{1, 1}});
    spoil(device);
    const std::string refusal = get_refusal(device);
    EXPECT_NE(refusal.find(says), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("Event pull-in"), std::string::npos) << refusal;
  };
  expect([](auto& device) { device.electrodes.clear(); }, "electrodes");
  expect([](auto& device) { device.events[0].of = "film"; }, "Of must stay");
  expect([](auto& device) { device.events[0].threshold = 1; }, "below 1");
  expect([](auto& device) { device.events[0].threshold = -.1; }, "from 0");
}
} // namespace
} // namespace taut::pull_in
