// A film of even stretch whose voltage rises until it breaks down, with every
// law of the strength.
#include <taut/base/exceptions.h>
#include <taut/structure/point_fields.h>
#include <taut/structure/watches.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/viscous_films.h"

namespace taut::breakdown
{
namespace
{
using material::StrengthFactor;

constexpr double stretch = 2;  ///< in both directions: J = 4
constexpr double strength = 3; ///< (V/m)
constexpr double rate = 2;     ///< of the voltage (V/s); the thickness is 1

/// All edges are held. The temperature rises by 10 K/s from 300 K.
structure::Device make_device(const std::vector<StrengthFactor>& factors)
{
  auto device = testing::make_sheet(
      {{material::NeoHookean{1}}, {}, {}, 1},
      {testing::make_support("east", {{true, false, false}}),
       testing::make_support("north", {{false, true, false}})});
  auto& film = device.films[0];
  film.pre_stretch = {stretch, stretch};
  film.temperature = Signal::table({0, 10}, {300, 400});
  film.material.dielectric.breakdown = {strength, factors};
  device.electrodes = {
      testing::make_electrode("film", Signal::ramp(rate, 0, 1e9))};
  structure::EventDescription event;
  event.name = "spark";
  event.kind = structure::EventDescription::Kind::breakdown;
  event.fatal = true;
  device.events = {event};
  return device;
}

struct Course
{
  explicit Course(const structure::Device& device)
  {
    testing::Model model(device, testing::make_sheet_mesh());
    structure::QuasiStaticSystem system(*model.structure, {});
    structure::Probes probes(system);
    structure::Watches watches(system, probes);
    auto state =
        system.make_initial_state(0, structure::Start::relaxed, false, {});
    EXPECT_EQ(watches.compute_margin(0, 0, state.data()), 1);
    time::Observer observer;
    observer.event = [&](const time::Event& event, const double* y)
    {
      time = event.time;
      report = watches.report(0, time, y);
    };
    time::Schedule schedule;
    schedule.end = 5;
    integrate(system, state.data(), schedule, testing::make_slow_options(1e-9),
              watches.make_time_watches(), observer);
  }
  double time = std::nan("");
  structure::EventReport report;
};

/// The event where the true field rate t J is the strength.
void expect_breakdown(const std::vector<StrengthFactor>& factors,
                      const double at_strength)
{
  const Course run(make_device(factors));
  const double time = at_strength / (rate * stretch * stretch);
  EXPECT_NEAR(run.time, time, 1e-10 * time);
  EXPECT_NEAR(run.report.margin, 0, 1e-10);
  EXPECT_NEAR(run.report.value, at_strength, 1e-9);
  EXPECT_NEAR(run.report.threshold, at_strength, 1e-9);
  EXPECT_EQ(run.report.place, "film");
  EXPECT_TRUE(std::isnan(run.report.direction[0]));
}

TEST(Breakdown, FollowsItsLaw)
{
  const double by_stretch = std::pow(stretch, .63);
  const double by_thickness = std::pow(stretch * stretch / 2, .25);
  const double by_rate = std::pow(rate / .1, .2);
  const material::StretchStrength stretch_law{.63, {1, 6}};
  const material::ThicknessStrength thickness_law{.5, .25, {.1, 1}};
  const material::RateStrength rate_law{.1, .2, {1e-3, 1e3}};
  expect_breakdown({}, strength);
  expect_breakdown({stretch_law}, strength * by_stretch);
  expect_breakdown({thickness_law}, strength * by_thickness);
  expect_breakdown({rate_law}, strength * by_rate);
  expect_breakdown({stretch_law, thickness_law, rate_law},
                   strength * by_stretch * by_thickness * by_rate);
}

TEST(Breakdown, ComesEarlierAsTheFilmWarms)
{
  // rate t J = E_0 (1 - .02 * 10 t).
  const double time = strength / (rate * stretch * stretch + .2 * strength);
  const Course run(make_device({material::TemperatureStrength{
      material::PolynomialLaw{300, {-.02}, 290, 320}}}));
  EXPECT_NEAR(run.time, time, 1e-10 * time);
}

TEST(Breakdown, ComesEarlierInHumidAir)
{
  const double time = strength / (rate * stretch * stretch) * std::exp(-.3);
  auto device = make_device(
      {material::HumidityStrength{material::ExponentialLaw{.2, -.5}}});
  device.films[0].humidity = Signal::constant(.8);
  EXPECT_NEAR(Course(device).time, time, 1e-10 * time);
}

TEST(Breakdown, OutOfTheRangeOfItsLawSaysWhere)
{
  testing::Model model(make_device({material::StretchStrength{.63, {1, 1.5}}}),
                       testing::make_sheet_mesh());
  structure::QuasiStaticSystem system(*model.structure, {});
  structure::Probes probes(system);
  structure::Watches watches(system, probes);
  const auto state =
      system.make_initial_state(0, structure::Start::relaxed, false, {});
  // Without voltage nothing is asked.
  EXPECT_EQ(watches.compute_margin(0, 0, state.data()), 1);
  try
  {
    watches.compute_margin(0, .1, state.data());
    FAIL() << "accepted";
  }
  catch (const StepRejected& refusal)
  {
    const std::string text = refusal.what();
    for (const char* part :
         {"is 2", "from 1 to 1.5", "near (0.", "of the mesh"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
  // What is only shown is left open.
  const auto fields = structure::compute_point_fields(
      *model.structure, system.history().at(.1), state.data(),
      system.internal(state.data()));
  for (const auto& point : fields)
    EXPECT_TRUE(std::isnan(point.breakdown_margin));
}

TEST(Breakdown, OfAFilmThatIsMissingIsRefused)
{
  auto device = make_device({});
  device.events[0].of = "fim";
  device.events[0].source_line = 7;
  testing::Model model(device, testing::make_sheet_mesh());
  structure::QuasiStaticSystem system(*model.structure, {});
  structure::Probes probes(system);
  try
  {
    structure::Watches watches(system, probes);
    FAIL() << "accepted";
  }
  catch (const BadInput& refusal)
  {
    EXPECT_NE(refusal.message().find("did you mean 'film'"), std::string::npos)
        << refusal.what();
    EXPECT_EQ(refusal.line(), 7u);
    EXPECT_EQ(refusal.key(), "Event spark");
  }
}
} // namespace
} // namespace taut::breakdown
