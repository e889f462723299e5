// Fields of homogeneous states, against closed forms.
#include <taut/structure/point_fields.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/devices.h"

namespace taut
{
namespace
{
using structure::PointFields;
using structure::Tension;
using Direction = structure::Direction;

constexpr double modulus = 2e4;         // Pa
constexpr double network_modulus = 1e4; // Pa
constexpr double thickness = 1e-3;      // m
constexpr double voltage = 3000;        // V
constexpr double permittivity = 4 * 8.8541878128e-12;
constexpr double strength = 5e7; // V/m
/// The map is affine, the arithmetic that of sums of a few terms.
constexpr double round_off = 1e-11;

/// A flat film whose plane is turned by `angle` about the x axis; the first
/// pre-stretch is along x. Its internal variables are those of networks that
/// have relaxed at the stretches `inner`.
struct Sheet
{
  Sheet(const std::array<double, 2>& stretches,
        const std::array<double, 2>& inner, const double angle = 0)
      : model(make_device(stretches),
              testing::make_grid(3, 2, 1,
                                 [angle](const double xi, const double eta)
                                 {
                                   return fe::Coordinates{
                                       .04 * xi, .03 * eta * std::cos(angle),
                                       .03 * eta * std::sin(angle)};
                                 })),
        structure(*model.structure), history(structure.device()),
        u(structure.n_free(), 0.), internal(structure.n_internal())
  {
    for (std::size_t i = 0; i < internal.size(); i += 3)
    {
      internal[i] = 1 / std::pow(inner[0], 2);
      internal[i + 1] = 1 / std::pow(inner[1], 2);
      internal[i + 2] = 0;
    }
  }

  static structure::Device make_device(const std::array<double, 2>& stretches)
  {
    structure::Device device;
    auto film =
        testing::make_film(material::NeoHookean{modulus}, thickness, stretches);
    film.material.networks = {{material::NeoHookean{network_modulus}, 1.}};
    film.material.dielectric = {material::ConstantPermittivity{4}, {strength}};
    device.films = {film};
    device.electrodes = {
        testing::make_electrode("left", Signal::constant(voltage))};
    device.supports = {testing::make_support("west", {{true, true, true}})};
    return device;
  }

  std::vector<PointFields> compute()
  {
    return structure::compute_point_fields(structure, history.at(0), u.data(),
                                           internal.data());
  }
  bool has_electrode(const std::size_t point) const
  {
    const auto& cells = structure.cells();
    return cells.cells()[point / cells.element().n_nodes].electrode >= 0;
  }

  testing::Model model;
  structure::Structure& structure;
  structure::LoadHistory history;
  std::vector<double> u, internal;
};

/// True stress along direction i of an incompressible film in plane stress:
/// G (l_i^2 - l_3^2) of the spring, the same of the network with its elastic
/// stretches l_i/inner_i, less eps E^2.
double stress(const std::array<double, 2>& l,
              const std::array<double, 2>& inner, const unsigned int i,
              const double field)
{
  const auto part = [i](const double G, const double l1, const double l2)
  { return G * (std::pow(i == 0 ? l1 : l2, 2) - std::pow(l1 * l2, -2)); };
  return part(modulus, l[0], l[1]) +
         part(network_modulus, l[0] / inner[0], l[1] / inner[1]) -
         permittivity * field * field;
}

TEST(PointFields, UniformStretch)
{
  const std::array<double, 2> l{{2, 1.5}}, inner{{1.8, 1.6}};
  Sheet sheet(l, inner);
  const auto fields = sheet.compute();
  for (std::size_t point = 0; point < fields.size(); ++point)
  {
    const PointFields& f = fields[point];
    const double field =
        sheet.has_electrode(point) ? voltage / thickness * 3 : 0;
    EXPECT_NEAR(f.true_field, field, round_off * 1e7);
    EXPECT_NEAR(f.breakdown_margin, 1 - field / strength, round_off);
    EXPECT_NEAR(f.thickness, thickness / 3, round_off * thickness);
    for (unsigned int i = 0; i < 2; ++i)
    {
      EXPECT_NEAR(f.stretches[i], l[i], round_off);
      EXPECT_NEAR(f.stresses[i], stress(l, inner, i, field),
                  round_off * modulus);
      EXPECT_NEAR(f.internal_stretches.at(0)[i], inner[i], round_off);
    }
    EXPECT_EQ(f.tension, Tension::taut);
  }
}

TEST(PointFields, DirectionsLieInTheTurnedFilm)
{
  const double angle = .7;
  Sheet sheet({{1.2, 1.9}}, {{1.2, 1.9}}, angle);
  const Direction across{{0, std::cos(angle), std::sin(angle)}};
  for (const PointFields& f : sheet.compute())
    for (const auto& directions : {f.stretch_directions, f.stress_directions})
    {
      // A direction has no sign.
      EXPECT_NEAR(
          std::abs(directions[0][1] * across[1] + directions[0][2] * across[2]),
          1, round_off);
      EXPECT_NEAR(std::abs(directions[1][0]), 1, round_off);
    }
}

TEST(PointFields, TensionState)
{
  // Uniaxial tension would make l_2 = 1/sqrt(l_1); a narrower film is pressed
  // across, and one that is shorter than undeformed in both directions is
  // slack.
  for (const PointFields& f : Sheet({{2, .6}}, {{2, .6}}).compute())
    EXPECT_EQ(f.tension, Tension::wrinkled);
  for (const PointFields& f : Sheet({{.8, .8}}, {{.8, .8}}).compute())
    EXPECT_EQ(f.tension, Tension::slack);
}

/// Moves the free nodes by up to 0.5 mm, so that the film shears.
void disturb(Sheet& sheet)
{
  for (std::size_t i = 0; i < sheet.u.size(); ++i)
    sheet.u[i] = 5e-4 * std::sin(double(i * i));
}

TEST(PointFields, CriticalValuesAreTheSameNumbers)
{
  Sheet sheet({{2, 1.1}}, {{1.5, 1.3}});
  disturb(sheet);
  const auto fields = sheet.compute();
  const auto critical =
      structure::compute_critical_values(sheet.structure, sheet.history.at(0),
                                         sheet.u.data(), sheet.internal.data());
  ASSERT_EQ(critical.size(), fields.size());
  for (std::size_t point = 0; point < fields.size(); ++point)
  {
    EXPECT_NEAR(critical[point].smaller_stress, fields[point].stresses[1],
                round_off * modulus);
    EXPECT_NEAR(critical[point].true_field, fields[point].true_field,
                round_off * 1e7);
  }
}
} // namespace
} // namespace taut
