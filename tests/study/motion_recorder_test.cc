#include <taut/base/exceptions.h>
#include <taut/study/run_demes.h>
#include <taut/study/run_resonator.h>

#include <gtest/gtest.h>

#include <cmath>

#include "lumped_cases.h"
#include "lumped_records.h"

namespace taut::study
{
namespace
{
using lumped_records::Records;

Case make_driven_case(const double pre_stretch, const double voltage,
                      const double frequency, const double periods)
{
  Case result = taut::testing::make_lumped_demes_case(pre_stretch);
  result.lumped_demes.source = Signal::sine(1000, voltage, frequency, 0);
  result.procedure.end_time = periods / frequency;
  result.output.history_intervals = 1000;
  result.motion.emplace();
  result.motion->of = "angle";
  result.motion->period = 1 / frequency;
  return result;
}
} // namespace

TEST(MotionOfARun, HasRowsAtTheStrobes)
{
  // 7 Hz does not divide the rows, 0.7 Hz is no number of the machine.
  Case run_case = make_driven_case(3, 5000, 7, 30);
  Records records;
  const auto summary = run_demes(run_case, records);
  ASSERT_TRUE(summary.motion);
  const MotionTrack& section = summary.motion->section;
  ASSERT_EQ(section.size(), 31u);
  EXPECT_EQ(summary.motion->unit, "rad");
  std::size_t found = 0;
  for (std::size_t i = 0; i < records.rows.size(); ++i)
    for (std::size_t k = 0; k < section.size(); ++k)
      if (std::abs(records.get(i, "time") - section.times[k]) < 1e-12)
      {
        ++found;
        EXPECT_NEAR(records.get(i, "angle"), section.values[k], 1e-12);
        EXPECT_NEAR(records.get(i, "angular velocity"), section.velocities[k],
                    1e-9);
      }
  EXPECT_EQ(found, section.size());
}

TEST(MotionOfARun, OfADampedDemesSettlesToThePeriodOfItsSource)
{
  Case run_case = make_driven_case(3, 5000, 5, 150);
  run_case.motion->from = 10;
  run_case.motion->lyapunov_exponent = true;
  Records records;
  const auto motion = *run_demes(run_case, records).motion;
  EXPECT_EQ(motion.verdict.motion_class, MotionClass::periodic);
  EXPECT_EQ(motion.verdict.period_number, 1u);
  ASSERT_TRUE(motion.lyapunov);
  // -0.024 in units of the frequency 2 pi 5 Hz.
  EXPECT_NEAR(motion.lyapunov->value, -0.024 * 2 * std::acos(-1.) * 5, 0.03);
  EXPECT_TRUE(motion.reproducible.value());
  EXPECT_EQ(motion.reproducible_until, records.rows.back().front());
  // The film feels the square of the voltage most at twice the frequency.
  EXPECT_NEAR(motion.highest_line.frequency, 10, 1e-3);
}

TEST(MotionOfARun, OverTheHilltopIsNotReproducible)
{
  // Strong enough to throw the frame through its straight shape again and
  // again.
  Case run_case = make_driven_case(2, 9000, 2.4, 120);
  Records records;
  const auto summary = run_demes(run_case, records);
  double lowest = 0, highest = 0;
  for (std::size_t i = 0; i < records.rows.size(); ++i)
  {
    lowest = std::min(lowest, records.get(i, "angle"));
    highest = std::max(highest, records.get(i, "angle"));
  }
  ASSERT_LT(lowest, -0.3);
  ASSERT_GT(highest, 0.3);
  EXPECT_FALSE(summary.motion->reproducible.value());
  EXPECT_LT(summary.motion->reproducible_until, run_case.procedure.end_time);
  EXPECT_GT(summary.motion->reproducible_until, 0);
  bool told = false;
  for (const std::string& note : summary.notes)
    told = told || note.find("not reproducible") != std::string::npos;
  EXPECT_TRUE(told);
}

TEST(MotionOfARun, MayEndBeforeItIsLookedAt)
{
  Case run_case = taut::testing::make_lumped_resonator_case();
  // Loses its tension early.
  run_case.lumped_resonator.voltage = Signal::ramp(1e5, 0, 1e6);
  run_case.procedure.end_time = 10;
  run_case.motion.emplace();
  run_case.motion->of = "bar displacement";
  run_case.motion->from = 5;
  Records records;
  const auto summary = run_resonator(run_case, records);
  EXPECT_EQ(summary.status, Status::event);
  EXPECT_FALSE(summary.motion);
  ASSERT_EQ(summary.notes.size(), 1u);
  EXPECT_NE(summary.notes[0].find("before the motion"), std::string::npos);
}

TEST(MotionOfARun, OfAResonatorDecays)
{
  Case run_case = taut::testing::make_lumped_resonator_case();
  run_case.lumped_resonator.voltage = Signal::steps({0, 0.01}, {0, 2000});
  run_case.procedure.end_time = 20;
  run_case.output.history_intervals = 4000;
  run_case.motion.emplace();
  run_case.motion->of = "bar displacement";
  run_case.motion->lyapunov_exponent = true;
  Records records;
  const auto motion = *run_resonator(run_case, records).motion;
  EXPECT_EQ(motion.verdict.motion_class, MotionClass::equilibrium);
  EXPECT_EQ(motion.velocity, "bar velocity");
  EXPECT_LT(motion.lyapunov.value().value, 0);
  EXPECT_TRUE(motion.reproducible.value());
}

TEST(MotionOfARun, NeedsItsColumn)
{
  Case run_case = make_driven_case(3, 5000, 5, 10);
  run_case.motion->of = "angel";
  Records records;
  try
  {
    run_demes(run_case, records);
    FAIL() << "accepted";
  }
  catch (const BadInput& problem)
  {
    EXPECT_NE(problem.message().find("did you mean 'angle'"),
              std::string::npos);
  }
}
} // namespace taut::study
