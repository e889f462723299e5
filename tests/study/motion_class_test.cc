#include <taut/base/exceptions.h>
#include <taut/study/motion.h>

#include <gtest/gtest.h>

#include "known_motions.h"

namespace taut::study
{
namespace
{
using taut::testing::duffing_period;
using taut::testing::make_duffing;
using taut::testing::pi;

MotionDescription make_description(const double period, const double from)
{
  MotionDescription description;
  description.of = "x";
  description.period = period;
  description.from = from;
  return description;
}

/// exp(-decay t) cos(t).
MotionTrack make_decaying(const double decay, const double end)
{
  return taut::testing::sample(
      end, int(20 * end),
      [=](const double t) { return std::exp(-decay * t) * std::cos(t); },
      [=](const double t)
      { return -std::exp(-decay * t) * (decay * std::cos(t) + std::sin(t)); });
}

/// An undamped oscillator of the frequency 1 that is driven with another.
MotionTrack make_torus(const double frequency, const int periods)
{
  return taut::testing::sample(
      periods * 2 * pi / frequency, 40 * periods,
      [=](const double t) { return std::cos(t) + std::sin(frequency * t); },
      [=](const double t)
      { return -std::sin(t) + frequency * std::cos(frequency * t); });
}

MotionVerdict classify(const MotionTrack& track, const double period,
                       const double from)
{
  return analyse_motion(track, make_description(period, from)).verdict;
}
} // namespace

TEST(MotionClass, DampedOscillatorComesToRest)
{
  // Driven or free: after 100 units e^-10 of the motion is left.
  for (const double period : {0., 2.})
    EXPECT_EQ(classify(make_decaying(0.1, 150), period, 0).motion_class,
              MotionClass::equilibrium);
}

TEST(MotionClass, DecayThatIsStillSeenIsATransient)
{
  EXPECT_EQ(classify(make_decaying(0.005, 400), 0, 0).motion_class,
            MotionClass::transient);
  EXPECT_EQ(classify(make_decaying(0.005, 400), 2, 0).motion_class,
            MotionClass::transient);
}

TEST(MotionClass, SpiralIntoAPointHasNoPeriodOfItsOwn)
{
  // What is left of the transient, 2e-3, turns by a fifth of a circle a period:
  // in the second half of the section every fifth point repeats within 1e-3,
  // the others do not; but all of them approach each other.
  constexpr double decay = 0.01, turn = 0.2;
  const auto track = taut::testing::sample(
      200, 8000,
      [=](const double t)
      {
        return std::cos(2 * pi * t) +
               2e-3 * std::exp(-decay * t) * std::cos(2 * pi * turn * t);
      },
      [=](const double t)
      {
        return -2 * pi * std::sin(2 * pi * t) -
               2e-3 * std::exp(-decay * t) *
                   (decay * std::cos(2 * pi * turn * t) +
                    2 * pi * turn * std::sin(2 * pi * turn * t));
      });
  EXPECT_EQ(classify(track, 1, 0).motion_class, MotionClass::transient);
}

TEST(MotionClass, DuffingOscillatorHasItsKnownPeriods)
{
  const std::pair<double, unsigned int> known[] = {
      {0.20, 1}, {0.28, 2}, {0.29, 4}, {0.37, 5}, {0.65, 2}};
  for (const auto& [force, n] : known)
  {
    const auto verdict = classify(make_duffing(force, 400), duffing_period,
                                  200 * duffing_period);
    EXPECT_EQ(verdict.motion_class, MotionClass::periodic) << force;
    EXPECT_EQ(verdict.period_number, n) << force;
    EXPECT_NEAR(verdict.period, n * duffing_period, 1e-6) << force;
    EXPECT_LT(verdict.spread, 1e-3) << force;
    EXPECT_LT(verdict.drift, 1e-4) << force;
  }
}

TEST(MotionClass, DuffingOscillatorIsIrregularAtItsKnownForce)
{
  const auto verdict =
      classify(make_duffing(0.5, 600), duffing_period, 100 * duffing_period);
  EXPECT_EQ(verdict.motion_class, MotionClass::irregular);
  EXPECT_GT(verdict.irregularity, 0.9);
  EXPECT_GT(verdict.spread, 0.5);
}

TEST(MotionClass, TorusIsQuasiPeriodic)
{
  const double frequency = std::sqrt(2.);
  const auto verdict =
      classify(make_torus(frequency, 400), 2 * pi / frequency, 0);
  EXPECT_EQ(verdict.motion_class, MotionClass::quasi_periodic);
  EXPECT_LT(verdict.irregularity, 0.1);
  // Of frequencies 3 : 4 it repeats after 4 periods of the drive.
  EXPECT_EQ(classify(make_torus(4. / 3, 400), 2 * pi * 3 / 4, 0).period_number,
            4u);
}

TEST(MotionClass, VanDerPolOscillatorRepeatsOnItsOwn)
{
  const auto track =
      taut::testing::integrate(150, 6000,
                               [](double, const double x, const double v)
                               { return (1 - x * x) * v - x; },
                               {0.1, 0});
  const auto motion = analyse_motion(track, make_description(0, 60));
  EXPECT_EQ(motion.verdict.motion_class, MotionClass::periodic);
  EXPECT_EQ(motion.verdict.period_number, 1u);
  // Its period for mu = 1 (Buonomo, SIAM J. Appl. Math. 59 (1998)).
  EXPECT_NEAR(motion.verdict.period, 6.6632868593, 1e-5);
  // 90 units of time have steps of 1/90 in the spectrum.
  EXPECT_NEAR(motion.highest_line.frequency, 1 / 6.6632868593, 1e-4);
}

TEST(MotionClass, ExponentDecidesWhereItIsKnown)
{
  const double frequency = std::sqrt(2.);
  const auto track = make_torus(frequency, 100);
  const auto description = make_description(2 * pi / frequency, 0);
  const auto classify_with = [&](const double exponent)
  {
    return analyse_motion(track, description,
                          lumped::LyapunovExponent{exponent, 0.01})
        .verdict.motion_class;
  };
  EXPECT_EQ(classify_with(0.1), MotionClass::irregular);
  EXPECT_EQ(classify_with(0.02), MotionClass::quasi_periodic);
  EXPECT_EQ(classify_with(-0.1), MotionClass::transient);
}

TEST(MotionClass, TooLittleIsCalledTransient)
{
  const double frequency = std::sqrt(2.);
  const auto few = classify(make_torus(frequency, 10), 2 * pi / frequency, 0);
  EXPECT_EQ(few.motion_class, MotionClass::transient);
  EXPECT_NE(few.reason.find("too few"), std::string::npos);
  const auto some = classify(make_torus(frequency, 60), 2 * pi / frequency, 0);
  EXPECT_EQ(some.motion_class, MotionClass::transient);
  EXPECT_EQ(classify(make_decaying(1, 1), 0, 0.9).motion_class,
            MotionClass::transient);
  EXPECT_THROW(classify(make_decaying(1, 1), 0, 2), BadInput);
}

TEST(ZeroOneTest, TellsMapsApart)
{
  const auto follow = [](const double growth)
  {
    std::vector<double> series{0.3};
    for (int i = 0; i < 3000; ++i)
      series.push_back(growth * series.back() * (1 - series.back()));
    return series;
  };
  // The logistic map: irregular at 4 and 3.97, of period 8 at 3.55.
  EXPECT_GT(test_irregularity(follow(4)), 0.95);
  EXPECT_GT(test_irregularity(follow(3.97)), 0.9);
  EXPECT_LT(test_irregularity(follow(3.55)), 0.1);
}

TEST(Reproducibility, EndsWhereTwinsPart)
{
  const auto track = taut::testing::sample(
      10, 1000, [](const double t) { return std::sin(t); },
      [](const double t) { return std::cos(t); });
  auto twin = track;
  EXPECT_EQ(find_reproducible_end(track, twin), 10);
  for (std::size_t i = 0; i < twin.size(); ++i)
    twin.values[i] += 1e-10 * std::exp(4 * twin.times[i]);
  // A hundredth of the amplitude is reached after ln(1e8) / 4 = 4.605.
  EXPECT_NEAR(find_reproducible_end(track, twin), 4.605, 0.01);
}
} // namespace taut::study
