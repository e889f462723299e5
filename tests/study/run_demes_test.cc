#include <taut/base/exceptions.h>
#include <taut/lumped/demes_statics.h>
#include <taut/study/lumped_case_demes.h>
#include <taut/study/run_demes.h>

#include <gtest/gtest.h>

#include <cmath>

#include "lumped_cases.h"
#include "lumped_records.h"

namespace taut::study
{
namespace
{
using lumped_records::Records;
using taut::testing::make_lumped_demes_case;
} // namespace

TEST(RunDemes, RowsAreInSiUnits)
{
  Case run_case = make_lumped_demes_case(2);
  run_case.lumped_demes.source = Signal();
  Records records;
  const auto summary = run_demes(run_case, records);
  EXPECT_EQ(summary.status, Status::completed);
  ASSERT_EQ(records.rows.size(), 51u);
  EXPECT_EQ(records.columns.size(), get_lumped_demes_columns().size());
  EXPECT_EQ(summary.final_row, records.rows.back());
  // At rest: the force of the parameter set, 1.678 N, and nothing moves.
  EXPECT_NEAR(records.get(50, "time"), 1, 1e-12);
  EXPECT_NEAR(records.get(50, "film force"), 1.678, 1e-3);
  EXPECT_NEAR(records.get(50, "angle"), 0.8217, 1e-3);
  EXPECT_NEAR(records.get(50, "chord"), 0.02 * 1.7824, 2e-5);
  EXPECT_NEAR(records.get(50, "angular velocity"), 0, 1e-8);
}

TEST(RunDemes, ChargeIsThatOfTheDeformedCapacitor)
{
  Records records;
  run_demes(make_lumped_demes_case(2), records);
  const auto& device = make_lumped_demes_case(2).lumped_demes;
  const double stretch = records.get(0, "stretch");
  const double phi = lumped::wang_permittivity.value(stretch);
  const double capacitance = 8.8541878128e-12 * device.relative_permittivity *
                             phi * device.film_length * device.film_width *
                             stretch * stretch / device.film_thickness;
  EXPECT_EQ(records.get(0, "voltage"), 5000);
  EXPECT_NEAR(records.get(0, "charge") / (capacitance * 5000), 1, 1e-12);
}

TEST(RunDemes, HeldChargeIsTheOneGiven)
{
  Case run_case = make_lumped_demes_case(2);
  run_case.lumped_demes.charge_controlled = true;
  run_case.lumped_demes.source = Signal::constant(1e-6);
  Records records;
  run_demes(run_case, records);
  EXPECT_NEAR(records.get(20, "charge"), 1e-6, 1e-18);
  EXPECT_GT(records.get(20, "voltage"), 0);
}

TEST(RunDemes, EnergyIsBalanced)
{
  Case run_case = make_lumped_demes_case(3);
  run_case.lumped_demes.source = Signal::sine(1000, 5000, 7.5, 0);
  Records records;
  const auto summary = run_demes(run_case, records);
  EXPECT_LT(summary.balance_relative, 1e-7);
  EXPECT_GT(records.get(50, "dissipated energy"), 0);
}

TEST(RunDemes, FlatStartTellsItsSeedAndThatTheFilmPushes)
{
  Case run_case = make_lumped_demes_case(3);
  run_case.lumped_demes.start = DemesStart::flat;
  run_case.lumped_demes.source = Signal();
  Records records;
  const auto summary = run_demes(run_case, records);
  ASSERT_EQ(summary.notes.size(), 2u);
  EXPECT_NE(summary.notes[0].find("seed angle 0.01"), std::string::npos);
  ASSERT_FALSE(records.events.empty());
  EXPECT_EQ(records.events[0].kind, "tension_loss");
  EXPECT_NEAR(records.events[0].value, 0, 1e-9);
  EXPECT_FALSE(records.events[0].fatal);
  run_case.lumped_demes.seed_angle = 0;
  Records still;
  EXPECT_NE(run_demes(run_case, still).notes.at(0).find("stays flat"),
            std::string::npos);
}

TEST(RunDemes, HeatedRunStartsAtTheRestShapeOfTheColdFrame)
{
  Case run_case = make_lumped_demes_case(2);
  run_case.lumped_demes.source = Signal();
  run_case.lumped_demes.temperature = 340;
  Records records;
  run_demes(run_case, records);
  EXPECT_NEAR(records.get(0, "angle"), 0.8217, 1e-3);
  // It swings about the heated rest shape, which is bent further.
  double highest = 0;
  for (std::size_t i = 0; i < records.rows.size(); ++i)
    highest = std::max(highest, records.get(i, "angle"));
  EXPECT_GT(highest, 0.9068);
}

TEST(RunDemes, RestStatesAreThoseOfThePaper)
{
  // The seven stretches that Wang et al. (2024) list, to their two decimals.
  const std::vector<double> stretches = {1.78, 1.70, 1.63, 1.57,
                                         1.53, 1.48, 1.45};
  for (std::size_t i = 0; i < stretches.size(); ++i)
  {
    Case run_case = make_lumped_demes_case(2 + 0.5 * double(i));
    run_case.lumped_demes.source = Signal();
    run_case.procedure.analysis = structure::Analysis::equilibrium;
    Records records;
    run_demes(run_case, records);
    EXPECT_NEAR(records.get(0, "stretch"), stretches[i], 0.005);
    EXPECT_EQ(records.get(0, "stretch"), records.get(0, "inner stretch"));
  }
}

TEST(RunDemes, RestStatesGoWithTheSourceAndTheTemperature)
{
  Case run_case = make_lumped_demes_case(2);
  run_case.lumped_demes.source = Signal::table({0, 1}, {0, 10000});
  run_case.procedure.analysis = structure::Analysis::equilibrium;
  Records records;
  EXPECT_EQ(run_demes(run_case, records).status, Status::completed);
  ASSERT_EQ(records.rows.size(), 51u);
  // e = 0.491 straightens it, 8.19 kV; e is 0.06 for every kV.
  for (std::size_t i = 0; i < records.rows.size(); ++i)
    EXPECT_EQ(records.get(i, "angle") == 0,
              records.get(i, "voltage") > 0.491 / 0.06 * 1000);
  run_case.lumped_demes.temperature = 340;
  Records hot;
  run_demes(run_case, hot);
  EXPECT_NEAR(hot.get(0, "angle"), 0.9068, 1e-4);
}

TEST(RunDemes, GivingUpIsAFailedRun)
{
  Case run_case = make_lumped_demes_case(2);
  run_case.lumped_demes.source = Signal::expression("t > 0.1 ? 1e205 : 0", {});
  Records records;
  const auto summary = run_demes(run_case, records);
  EXPECT_EQ(summary.status, Status::failed);
  EXPECT_FALSE(summary.reason.empty());
  EXPECT_TRUE(records.rows.empty());
}

TEST(RunDemes, ImpossibleCasesAreRefused)
{
  Records records;
  const auto expect_refusal = [&](const auto& change)
  {
    Case run_case = make_lumped_demes_case(2);
    change(run_case);
    EXPECT_THROW(run_demes(run_case, records), BadInput);
  };
  expect_refusal([](Case& c)
                 { c.procedure.analysis = structure::Analysis::quasi_static; });
  expect_refusal([](Case& c) { c.lumped_demes.temperature_laws = "hard"; });
  expect_refusal(
      [](Case& c) {
        c.lumped_demes.permittivity_coefficients = {1, 2};
      });
  expect_refusal([](Case& c) { c.lumped_demes.temperature = 500; });
  expect_refusal([](Case& c) { c.lumped_demes.inertia = 0; });
}
} // namespace taut::study
