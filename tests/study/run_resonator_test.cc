#include <taut/base/exceptions.h>
#include <taut/study/lumped_case.h>
#include <taut/study/run_resonator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/lumped_records.h"

namespace taut::study
{
namespace
{
const double permittivity = 4.7 * lumped::vacuum_permittivity;

Case make_resonator_case()
{
  Case result;
  result.model = "resonator";
  auto& device = result.lumped_resonator;
  device.length_active = 0.02;
  device.length_passive = 0.01;
  device.width = 0.03;
  device.thickness = 1e-3;
  device.pre_stretch = {2, 3};
  device.bar_mass = 0.02;
  device.density = 960;
  device.shear_modulus = 40e3;
  device.equilibrium_share = 0.5;
  device.relaxation_times = {0.01, 1, 100};
  device.breakdown_strength = 155e6;
  device.voltage =
      Signal::ramp(9300, 0, std::numeric_limits<double>::infinity());
  result.procedure.analysis = structure::Analysis::quasi_static;
  result.procedure.start = structure::Start::unrelaxed;
  result.procedure.end_time = 2;
  result.output.history_intervals = 20;
  result.output.history_times = {0.123};
  return result;
}

Case make_swing()
{
  Case result = make_resonator_case();
  result.lumped_resonator.voltage = Signal::steps({0, 0.01}, {0, 1000});
  result.procedure.analysis = structure::Analysis::transient;
  result.procedure.start = structure::Start::relaxed;
  result.procedure.end_time = 0.5;
  result.output.history_intervals = 500;
  return result;
}

using lumped_records::Records;

TEST(RunResonator, RowsAreInSiUnits)
{
  const Case run_case = make_resonator_case();
  const auto& device = run_case.lumped_resonator;
  Records records;
  const auto summary = run_resonator(run_case, records);
  ASSERT_GT(records.rows.size(), 3u);
  // At the start every network acts as a spring: a Gent solid of the whole
  // modulus with D = J - l1^2 - l2^2 - (l1 l2)^-2 + 3.
  const double rest = 67 - 4 - 9 - 1 / 36. + 3;
  EXPECT_NEAR(records.get(0, "nominal stress 1 passive"),
              40e3 * 67 * (2 - 1 / (8. * 9)) / rest, 1e-9 * 40e3);
  EXPECT_NEAR(records.get(0, "nominal stress 2 active"),
              40e3 * 67 * (3 - 1 / (27. * 4)) / rest, 1e-9 * 40e3);
  for (std::size_t i = 0; i < records.rows.size(); ++i)
  {
    const double voltage = 9300 * records.get(i, "time");
    const double stretch = records.get(i, "stretch active");
    const double round_off = 1e-12;
    EXPECT_NEAR(records.get(i, "voltage"), voltage, round_off * 1e4);
    // Both strips together keep their length.
    EXPECT_NEAR(0.02 * stretch + 0.01 * records.get(i, "stretch passive"), 0.06,
                round_off);
    EXPECT_NEAR(records.get(i, "bar displacement"), 0.02 * (stretch - 2),
                round_off);
    // Q = eps V (l1 l2)^2 L1 L2 / L3
    EXPECT_NEAR(records.get(i, "charge"),
                permittivity * voltage * std::pow(3 * stretch, 2) *
                    device.length_active * device.width / device.thickness,
                1e-9 * 1e-5);
    EXPECT_NEAR(records.get(i, "true field"),
                voltage / device.thickness * 3 * stretch, 1e-9 * 1e8);
    EXPECT_NEAR(records.get(i, "breakdown margin"),
                155e6 - records.get(i, "true field"), 1e-9 * 1e8);
  }
  EXPECT_EQ(summary.final_row, records.rows.back());
}

TEST(RunResonator, RowsComeAtTheTimesAskedFor)
{
  Records records;
  run_resonator(make_resonator_case(), records);
  EXPECT_EQ(records.get(0, "time"), 0);
  EXPECT_EQ(records.get(1, "time"), 0.1);
  EXPECT_EQ(records.get(2, "time"), 0.123);
  EXPECT_EQ(records.get(3, "time"), 0.2);
}

TEST(RunResonator, LossOfTensionEndsTheRun)
{
  Records records;
  const auto summary = run_resonator(make_resonator_case(), records);
  EXPECT_EQ(summary.status, Status::event);
  ASSERT_EQ(records.events.size(), 1u);
  const EventRecord& event = records.events[0];
  EXPECT_EQ(event.kind, "tension_loss");
  EXPECT_EQ(event.place, "active + passive");
  EXPECT_TRUE(event.fatal);
  EXPECT_EQ(event.direction, (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(event.time, summary.time_reached);
  EXPECT_LT(event.time, 2);
  // The run's last row is the event: s_1 = 0 in both strips, to the width of
  // the search for the root.
  EXPECT_NEAR(event.value, 0, 1e-6 * 40e3);
  EXPECT_NEAR(records.get(records.rows.size() - 1, "nominal stress 1 active"),
              0, 1e-6 * 40e3);
}

TEST(RunResonator, BreakdownEndsTheRun)
{
  Case weak = make_resonator_case();
  weak.lumped_resonator.breakdown_strength = 20e6;
  Records records;
  EXPECT_EQ(run_resonator(weak, records).status, Status::event);
  ASSERT_EQ(records.events.size(), 1u);
  EXPECT_EQ(records.events[0].kind, "breakdown");
  EXPECT_EQ(records.events[0].place, "active");
  EXPECT_NEAR(records.events[0].value, 20e6, 1e-6 * 20e6);
  EXPECT_EQ(records.events[0].threshold, 20e6);
}

TEST(RunResonator, SwingsAtItsNaturalFrequency)
{
  // One network that does not relax within the run: an elastic resonator. The
  // step of 100 V moves it so little that its period is that of the linear
  // motion; times of crossing are interpolated between rows 1 ms apart.
  Case swing = make_swing();
  swing.lumped_resonator.relaxation_times = {1e9};
  swing.lumped_resonator.voltage = Signal::steps({0, 0.01}, {0, 100});
  Records records;
  EXPECT_EQ(run_resonator(swing, records).status, Status::completed);
  const double frequency =
      records.get(records.rows.size() - 1, "natural frequency");
  std::vector<double> turns;
  for (std::size_t i = 1; i < records.rows.size(); ++i)
  {
    const double v_0 = records.get(i - 1, "bar velocity");
    const double v_1 = records.get(i, "bar velocity");
    if (v_0 > 0 && v_1 <= 0)
      turns.push_back(records.get(i - 1, "time") + 1e-3 * v_0 / (v_0 - v_1));
  }
  ASSERT_GT(turns.size(), 3u);
  const double period = (turns.back() - turns.front()) / (turns.size() - 1);
  EXPECT_NEAR(period * frequency, 1, 1e-3);
}

TEST(RunResonator, BalancesItsEnergy)
{
  Records records;
  const auto summary = run_resonator(make_swing(), records);
  EXPECT_EQ(summary.status, Status::completed);
  // Some hundred steps with a local error of 1e-10.
  EXPECT_LT(summary.balance_relative, 1e-6);
  EXPECT_GT(records.get(records.rows.size() - 1, "dissipated energy"), 0);
}

TEST(RunResonator, EquilibriaAreThoseOfALongRun)
{
  // After 30 of the longest relaxation times at a held voltage.
  Case held = make_resonator_case();
  held.lumped_resonator.voltage = Signal::constant(5000);
  held.procedure.end_time = 3000;
  Records slow, still;
  EXPECT_EQ(run_resonator(held, slow).status, Status::completed);
  held.procedure.analysis = structure::Analysis::equilibrium;
  EXPECT_EQ(run_resonator(held, still).status, Status::completed);
  ASSERT_EQ(still.rows.size(), slow.rows.size());
  // Tolerances of the slow run.
  for (const char* name : {"stretch active", "natural frequency", "charge"})
    EXPECT_NEAR(still.get(0, name) / slow.get(slow.rows.size() - 1, name), 1,
                1e-7)
        << name;
}

TEST(RunResonator, EquilibriaEndWhereTheTensionIsLost)
{
  Case still = make_resonator_case();
  still.procedure.analysis = structure::Analysis::equilibrium;
  still.lumped_resonator.length_passive = 0.02;
  still.lumped_resonator.pre_stretch = {2, 4};
  Records records;
  const auto summary = run_resonator(still, records);
  EXPECT_EQ(summary.status, Status::event);
  ASSERT_EQ(records.events.size(), 1u);
  EXPECT_EQ(records.events[0].name, "loss of tension along x_1");
  const double last = double(records.rows.size()) - 1;
  // V* of the thesis' resonator, 0.22391; V* = 1 is L_3 sqrt(G / eps) = 31.003
  // kV here. The ramp is 9300 V/s.
  const double voltage = records.get(std::size_t(last), "voltage");
  EXPECT_NEAR(voltage / (1e-3 * std::sqrt(40e3 / permittivity)), 0.22391, 5e-6);
  EXPECT_NEAR(records.events[0].time, voltage / 9300, 1e-12);
}

TEST(RunResonator, PreStretchThatHasNoTensionFailsAtTheStart)
{
  Case loose = make_resonator_case();
  loose.procedure.analysis = structure::Analysis::equilibrium;
  loose.lumped_resonator.pre_stretch = {1, 1};
  Records records;
  EXPECT_EQ(run_resonator(loose, records).status, Status::event);
  ASSERT_EQ(records.events.size(), 1u);
  EXPECT_TRUE(records.events[0].at_start);
  EXPECT_EQ(records.rows.size(), 1u);
}

TEST(RunResonator, FindsTheVoltageThatCanBeHeld)
{
  // V_p* = 0.22026 of the thesis' resonator at a rate of 10, reached with a
  // hold of many relaxation times; its ramp alone fails later.
  Case fast = make_resonator_case();
  fast.lumped_resonator.length_passive = 0.02;
  fast.lumped_resonator.pre_stretch = {2, 4};
  const double unit = 1e-3 * std::sqrt(40e3 / permittivity);
  fast.lumped_resonator.voltage =
      Signal::ramp(10 * unit, 0, std::numeric_limits<double>::infinity());
  fast.lumped_resonator.hold_time = 3000;
  fast.procedure.start = structure::Start::relaxed;
  Records records;
  const auto summary = run_resonator(fast, records);
  const double limit = summary.findings.at("hold limit");
  EXPECT_NEAR(limit / unit, 0.22026, 5e-6);
  EXPECT_GT(records.get(records.rows.size() - 1, "voltage"), 1.01 * limit);
  Case still = fast;
  still.lumped_resonator.voltage = Signal::constant(limit);
  still.lumped_resonator.hold_time = 0;
  still.procedure.analysis = structure::Analysis::equilibrium;
  Records relaxed;
  EXPECT_TRUE(run_resonator(still, relaxed).findings.empty());
  EXPECT_NEAR(summary.findings.at("natural frequency at hold limit"),
              relaxed.get(0, "natural frequency"), 1e-9);
}

TEST(RunResonator, RefusesWhatItCannotDoBeforeAnythingIsWritten)
{
  Case path = make_resonator_case();
  path.procedure.analysis = structure::Analysis::continuation;
  Records records;
  EXPECT_THROW(run_resonator(path, records), BadInput);
  EXPECT_TRUE(records.columns.empty());
  Case level = make_resonator_case();
  level.lumped_resonator.voltage = Signal::constant(1000);
  level.lumped_resonator.hold_time = 10;
  EXPECT_THROW(run_resonator(level, records), BadInput);
  EXPECT_TRUE(records.columns.empty());
}

TEST(RunResonator, ReadsSharesAndRates)
{
  Case uneven = make_resonator_case();
  uneven.lumped_resonator.network_shares = {0.1, 0.15, 0.25};
  uneven.lumped_resonator.relaxation_is_rate = true;
  const auto resonator =
      lumped::make_resonator(make_resonator_si(uneven.lumped_resonator));
  ASSERT_EQ(resonator.networks.size(), 3u);
  EXPECT_NEAR(resonator.networks[1].weight, 0.15, 1e-15);
  EXPECT_NEAR(resonator.networks[2].relaxation_time, 0.01, 1e-15);
}
} // namespace
} // namespace taut::study
