// A guided bar of mass m between two strips of mass M each: the first frequency
// z = omega L/c of the waves in the strips obeys z tan z = 2 M/m. One element
// per strip makes z^2 = 2/(m/M + 2/3) of it, which is the lumped model.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "structure/statics.h"
#include <boost/math/tools/roots.hpp>

namespace taut
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Two unit strips on rollers along their sides with a guided bar between
/// them; z counts the first frequency in c/L, c the wave speed.
double compute_first_frequency(const double bar_mass, const unsigned int degree,
                               const unsigned int cells_per_strip)
{
  structure::Device device;
  device.mesh.degree = degree;
  device.films = {testing::make_film(material::NeoHookean{1}, 1, {{1.5, 1.5}})};
  device.films[0].material.density = 1;
  device.supports = {testing::make_support("west", {{true, true, true}}),
                     testing::make_support("east", {{true, true, true}}),
                     testing::make_support("film", {{false, true, true}})};
  structure::RigidBar bar;
  bar.name = "bar";
  bar.groups = {"middle"};
  const double strip_mass = 1 / (1.5 * 1.5);
  bar.mass = bar_mass * strip_mass;
  bar.free = {{true, false, false}};
  bar.rotates = false;
  device.bars = {bar};
  testing::Model model(
      device, testing::make_rectangle(2 * cells_per_strip, 1, 1, 2, 1));
  auto& structure = *model.structure;
  testing::Statics statics(structure);
  structure.factorise(statics.get_loads(), statics.u.data(),
                      statics.internal.data(), structure::Networks::relaxed,
                      infinity, false, fe::LinearSolver::Kind::symmetric);

  // Inverse iteration from the sine-like first mode.
  const std::size_t n = structure.n_free();
  std::vector<double> mode(n, 1.), inertia(n);
  double square = 0, last = 1;
  for (unsigned int step = 0;
       step < 200 && std::abs(square - last) > 1e-14 * square; ++step)
  {
    last = square;
    structure.multiply_mass(mode.data(), inertia.data());
    structure.solve(inertia.data(), inertia.data());
    double largest = 0;
    for (const double entry : inertia)
      largest = std::max(largest, std::abs(entry));
    square = 1 / largest;
    for (std::size_t i = 0; i < n; ++i)
      mode[i] = inertia[i] / largest;
  }
  // d s/d l = mu (1 + 3 l^-4 w^-2) in the film; in the mesh, P P/det P of it.
  const double stiffness = 1 + 3 * std::pow(1.5, -6);
  return std::sqrt(square / (stiffness * 1.5 * 1.5));
}

/// First root of z tan z = 2/r, r = m/M.
double find_wave_frequency(const double ratio)
{
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      [=](const double z) { return ratio * z * std::sin(z) - 2 * std::cos(z); },
      1e-6, 1.6, boost::math::tools::eps_tolerance<double>(50), iterations);
  return bracket.first;
}

double find_lumped_frequency(const double ratio)
{
  return std::sqrt(2 / (ratio + 2. / 3));
}

TEST(BarMass, OneElementPerStripIsTheLumpedModel)
{
  for (const double ratio : {0., .5, 1., 10.})
    EXPECT_NEAR(compute_first_frequency(ratio, 1, 1),
                find_lumped_frequency(ratio), 1e-12);
}

TEST(BarMass, ManyElementsCarryTheWaves)
{
  for (const double ratio : {0., .5, 1., 10.})
    EXPECT_NEAR(compute_first_frequency(ratio, 2, 16) /
                    find_wave_frequency(ratio),
                1, 1e-7);
}

TEST(BarMass, LumpedFrequencyIsTooHighAsTabulated)
{
  // Percent over the exact one, digits as printed in the source of the table.
  struct Row
  {
    double ratio, percent, rounding;
  };
  for (const auto& [ratio, percent, rounding] :
       {Row{0, 10.3, .05}, Row{1, 1.7, .05}, Row{2, .66, .005},
        Row{5, .14, .005}, Row{10, .04, .005}})
    EXPECT_NEAR(100 * (compute_first_frequency(ratio, 1, 1) /
                           compute_first_frequency(ratio, 2, 16) -
                       1),
                percent, rounding)
        << "m/M = " << ratio;
}
} // namespace
} // namespace taut
