// A sheet that is stretched, released until it is slack, and stretched again.
#include <taut/structure/watches.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "structure/viscous_films.h"

namespace taut::slack_sheet
{
namespace
{
using Kind = structure::EventDescription::Kind;

constexpr double width = .9;

structure::EventDescription make_event(const std::string& name, const Kind kind)
{
  structure::EventDescription event;
  event.name = name;
  event.kind = kind;
  return event;
}

/// Width held at .9; the length goes from 1.5 to .95 until time 1 and back
/// until time 2.
structure::Device make_device()
{
  auto device = testing::make_sheet({{material::NeoHookean{1}}, {}, {}, 1}, {});
  device.films[0].pre_stretch = {1.5, width};
  device.supports.push_back(
      testing::make_support("north", {{false, true, false}}));
  device.supports.push_back(
      testing::make_support("east", {{true, false, false}}, {{"1", "0", "0"}},
                            Signal::table({0, 1, 2}, {0, .95 / 1.5 - 1, 0})));
  structure::Probe stress;
  stress.name = "tension";
  stress.kind = structure::Probe::Kind::mean_stress;
  stress.of = "film";
  device.probes = {stress};
  device.events = {make_event("wrinkles", Kind::wrinkling),
                   make_event("slack", Kind::slackness),
                   make_event("taut again", Kind::probe_above)};
  device.events[2].of = "tension";
  device.events[2].threshold = 1e-3;
  return device;
}

TEST(SlackSheet, ForceComesBackAndEveryEventHappensOnce)
{
  testing::Model model(make_device(), testing::make_sheet_mesh());
  structure::QuasiStaticSystem system(*model.structure, {});
  structure::Probes probes(system);
  structure::Watches watches(system, probes);
  auto state =
      system.make_initial_state(0, structure::Start::relaxed, true, {});
  std::map<std::string, std::vector<double>> events;
  time::Observer observer;
  observer.event = [&](const time::Event& event, const double*)
  {
    if (!event.at_start)
      events[model.structure->device().events[event.watch].name].push_back(
          event.time);
  };
  std::vector<double> tension;
  observer.output = [&](const double time, const double* y)
  { tension.push_back(probes.evaluate(time, y)[0]); };
  time::Schedule schedule;
  schedule.end = 2;
  for (int i = 0; i <= 40; ++i)
    schedule.output_times.push_back(i / 20.);
  integrate(system, state.data(), schedule, testing::make_slow_options(1e-9),
            watches.make_time_watches(), observer);
  const auto get_time = [](const double l) { return (1.5 - l) / .55; };
  // Wrinkles below l = w^-2, slack below 1; on the way back the tension
  // l - l^-2 of the wrinkled film rises above the threshold.
  ASSERT_EQ(events["wrinkles"].size(), 1u);
  EXPECT_NEAR(events["wrinkles"][0], get_time(std::pow(width, -2)), 1e-5);
  ASSERT_EQ(events["slack"].size(), 1u);
  EXPECT_NEAR(events["slack"][0], get_time(1), 1e-5);
  ASSERT_EQ(events["taut again"].size(), 1u);
  EXPECT_NEAR(events["taut again"][0], 2 - get_time(1 + 1e-3 / 3), 1e-5);
  // The cost of wrinkles is 1e-6 of the modulus.
  ASSERT_EQ(tension.size(), 41u);
  for (int i = 0; i <= 20; ++i)
  {
    EXPECT_NEAR(tension[i], tension[40 - i], 1e-8);
    const double l = 1.5 - .55 * i / 20;
    const double expected = l > std::pow(width, -2)
                                ? l - std::pow(l, -3) * std::pow(width, -2)
                                : std::max(l - std::pow(l, -2), 0.);
    EXPECT_NEAR(tension[i], expected, 1e-5);
  }
}
} // namespace
} // namespace taut::slack_sheet
