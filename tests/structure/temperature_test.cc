// Films and frames at temperatures and humidities that change.
#include <taut/base/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/balance.h"
#include "structure/frames.h"
#include "structure/viscous_films.h"

namespace taut
{
namespace
{
material::ThermalLaws make_laws()
{
  material::ThermalLaws laws;
  laws.modulus = material::PolynomialLaw{299, {-.005, 1e-5}, 250, 400};
  laws.relaxation_time = material::ArrheniusLaw{299, 30e3};
  return laws;
}

/// A square stretched and held at its rim.
structure::Device make_held_film(const Signal& temperature)
{
  structure::Device device;
  device.films = {
      testing::make_film(material::Gent{2e4, 60}, 1e-3, {{1.6, 1.4}})};
  device.films[0].temperature = temperature;
  device.films[0].thermal = make_laws();
  device.supports = {testing::make_support("film", {{false, false, true}}),
                     testing::make_support("west", {{true, true, true}}),
                     testing::make_support("east", {{true, true, true}})};
  for (const char* side : {"south", "north"})
    device.supports.push_back(
        testing::make_support(side, {{true, true, true}}));
  return device;
}

double compute_pull(const double temperature)
{
  testing::Model model(make_held_film(Signal::constant(temperature)),
                       testing::make_rectangle(2, 2, 2, .04, .04));
  testing::Statics statics(*model.structure);
  statics.find();
  return statics.get_reaction(1)[0];
}

TEST(Temperature, ForcesScaleAsTheLawOfTheModulus)
{
  const double reference = compute_pull(299);
  for (const double temperature : {270., 320., 360.})
  {
    const double x = temperature - 299;
    EXPECT_NEAR(compute_pull(temperature) / reference,
                1 - .005 * x + 1e-5 * x * x, 1e-10);
  }
}

TEST(Temperature, OutsideTheRangeOfALawStepsAreRejected)
{
  EXPECT_THROW(compute_pull(401), StepRejected);
}

TEST(Temperature, HeatAloneIsReportedBesideTheBalance)
{
  auto device = make_held_film(Signal::constant(330));
  device.films[0].thermal.heat_capacity = 2000;
  device.films[0].thermal.reference = 299;
  testing::Model model(device, testing::make_rectangle(2, 2, 2, .04, .04));
  testing::Statics statics(*model.structure);
  statics.find();
  const auto energies = statics.compute_energies();
  // 1600 mm^2 of a film of 1 mm / (1.6 * 1.4), 1000 kg/m^3.
  const double mass = .04 * .04 * 1e-3 / (1.6 * 1.4) * 1000;
  EXPECT_NEAR(energies.thermal, mass * 2000 * (31 - 330 * std::log(330. / 299)),
              1e-9);
  EXPECT_EQ(energies.total(), energies.stored);
}

/// A film that relaxes and is pulled while it is heated, with voltage and a
/// permittivity that both follow the temperature.
structure::Device make_heated_device(const Signal& temperature)
{
  structure::Device device;
  device.films = {
      testing::make_film(material::Gent{2e4, 60}, 1e-3, {{1.6, 1.4}})};
  auto& film = device.films[0];
  film.material.networks = {{material::NeoHookean{1e4}, .05},
                            {material::MooneyRivlin{2e3, 1e3}, .3}};
  film.material.dielectric.permittivity = material::StretchPermittivity{};
  film.temperature = temperature;
  film.thermal = make_laws();
  film.thermal.heat_capacity = 2000;
  device.electrodes = {
      testing::make_electrode("left", Signal::sine(2000, 1500, 2, .3))};
  device.supports = {testing::make_support("film", {{false, false, true}}),
                     testing::make_support("west", {{true, true, true}}),
                     testing::make_support("east", {{true, true, true}},
                                           {{".004", ".1*(y - .02)", "0"}},
                                           Signal::sine(0, 1, 3, 0))};
  return device;
}

double compute_heated_drift(const Signal& temperature)
{
  testing::Model model(make_heated_device(temperature),
                       testing::make_rectangle(4, 2, 2, .05, .04));
  structure::QuasiStaticSystem system(*model.structure, {});
  return testing::compute_drift(system, .2, testing::make_slow_options(1e-9));
}

TEST(HeatedFilm, BalanceHoldsWhileTheTemperatureRises)
{
  EXPECT_LT(compute_heated_drift(Signal::table({0, .2}, {290, 340})), 1e-6);
}

TEST(HeatedFilm, BalanceHoldsAcrossKinksAndJumps)
{
  EXPECT_LT(compute_heated_drift(Signal::steps({0, .1}, {290, 320})), 1e-6);
  EXPECT_LT(compute_heated_drift(Signal::table({0, .05, .2}, {290, 330, 310})),
            1e-6);
}

TEST(HeatedFilm, BalanceHoldsInMotion)
{
  testing::Model model(make_heated_device(Signal::table({0, .02}, {290, 340})),
                       testing::make_rectangle(4, 2, 2, .05, .04));
  structure::InertialSystem system(*model.structure);
  time::IntegratorOptions options;
  options.position_tolerance = 1e-9;
  options.velocity_time = 5e-3;
  EXPECT_LT(testing::compute_drift(system, .02, options), 1e-6);
}

material::HumidityLaws make_humidity_laws()
{
  return {material::PolynomialLaw{.5, {-.3}, .1, .9},
          material::ExponentialLaw{.5, -2}, material::ExponentialLaw{.5, .8}};
}

TEST(HumidFilm, ForcesAndChargesScaleAsTheirLaws)
{
  const auto compute = [](const double humidity)
  {
    auto device = make_held_film(Signal::constant(299));
    device.films[0].humidity_laws = make_humidity_laws();
    device.films[0].humidity = Signal::constant(humidity);
    device.films[0].material.dielectric.permittivity =
        material::ConstantPermittivity{4};
    device.electrodes = {testing::make_electrode("film", Signal())};
    testing::Model model(device, testing::make_rectangle(2, 2, 2, .04, .04));
    testing::Statics statics(*model.structure);
    statics.find();
    return std::array<double, 2>{{statics.get_reaction(1)[0],
                                  model.structure->compute_capacitances()[0]}};
  };
  const auto reference = compute(.5);
  for (const double humidity : {.2, .7})
  {
    const double x = humidity - .5;
    const auto values = compute(humidity);
    EXPECT_NEAR(values[0] / reference[0], 1 - .3 * x, 1e-10);
    EXPECT_NEAR(values[1] / reference[1], std::exp(.8 * x), 1e-10);
  }
}

TEST(HumidFilm, BalanceHoldsWhileTemperatureAndHumidityChange)
{
  for (const Signal& temperature :
       {Signal::constant(299), Signal::table({0, .2}, {290, 340})})
  {
    auto device = make_heated_device(temperature);
    device.films[0].humidity = Signal::table({0, .05, .2}, {.2, .6, .4});
    device.films[0].humidity_laws = make_humidity_laws();
    testing::Model model(device, testing::make_rectangle(4, 2, 2, .05, .04));
    structure::QuasiStaticSystem system(*model.structure, {});
    EXPECT_LT(
        testing::compute_drift(system, .2, testing::make_slow_options(1e-9)),
        1e-6);
  }
}

// A damped cantilever under a load at its tip, that softens as it sways.
TEST(HumidFrame, BalanceHoldsWhileTemperatureAndHumidityChange)
{
  structure::Device device;
  auto section = testing::make_stiffnesses(1e3, 1e3, 1, 1, 1);
  section.mass_per_length = .1;
  section.rotary_inertia = {{1e-4, 1e-4, 1e-4}};
  device.frames = {testing::make_frame("frame", section)};
  auto& frame = device.frames[0];
  frame.stiffness_damping = 1e-3;
  frame.temperature = Signal::table({0, .5}, {290, 340});
  frame.modulus_law = material::PolynomialLaw{299, {-.005}, 250, 400};
  frame.humidity = Signal::table({0, .2, .5}, {.1, .8, .3});
  frame.humidity_law = material::ExponentialLaw{.5, -1};
  device.supports = {testing::make_clamp("root")};
  device.point_loads = {testing::make_point_load("tip", {{0, 0, 1}})};
  device.point_loads[0].force = Signal::constant(.5);
  auto mesh = testing::make_line_mesh();
  const auto ends = testing::add_line(
      mesh, "frame", 4, testing::make_straight({0, 0, 0}, {1, 0, 0}));
  testing::name_point(mesh, ends[0], "root");
  testing::name_point(mesh, ends[1], "tip");
  fe::add_empty_surface(mesh);
  testing::Model model(device, mesh);
  structure::InertialSystem system(*model.structure);
  time::IntegratorOptions options;
  options.position_tolerance = 1e-8;
  options.velocity_time = 1e-2;
  EXPECT_LT(testing::compute_drift(system, .5, options, {}, false), 1e-5);
}
} // namespace
} // namespace taut
