#include <taut/base/exceptions.h>
#include <taut/study/section.h>
#include <taut/study/spectrum.h>

#include <gtest/gtest.h>

#include "known_motions.h"

namespace taut::study
{
namespace
{
using taut::testing::pi;

MotionTrack make_sine(const double end, const int n)
{
  return taut::testing::sample(
      end, n, [](const double t) { return std::sin(t); },
      [](const double t) { return std::cos(t); });
}

double find_largest_error(const std::vector<double>& rates,
                          const std::vector<double>& exact)
{
  double largest = 0;
  for (std::size_t i = 0; i < rates.size(); ++i)
    largest = std::max(largest, std::abs(rates[i] - exact[i]));
  return largest;
}

double find_derivative_error(const int n)
{
  const auto track = make_sine(2, n);
  return find_largest_error(differentiate(track.times, track.values),
                            track.velocities);
}

} // namespace

TEST(MotionTrack, DerivativeIsOfFourthOrder)
{
  const double order =
      std::log2(find_derivative_error(20) / find_derivative_error(40));
  EXPECT_NEAR(order, 4, 0.3);
}

TEST(MotionTrack, DerivativeOfAQuarticIsExactAtUnevenTimes)
{
  const std::vector<double> times{0, 0.1, 0.15, 0.4, 0.9, 1.0, 1.7};
  std::vector<double> values, exact;
  for (const double t : times)
  {
    values.push_back(std::pow(t, 4) - t);
    exact.push_back(4 * t * t * t - 1);
  }
  EXPECT_LT(find_largest_error(differentiate(times, values), exact), 1e-11);
  EXPECT_EQ(differentiate({1}, {5}), std::vector<double>{0});
}

TEST(MotionTrack, ExtremesLieBetweenRows)
{
  // 7 rows per turn: the largest row is 0.975; a cubic misses the top by
  // h^4 / 384 at most.
  const auto extremes = find_extremes(make_sine(2 * pi, 7));
  const double bound = std::pow(2 * pi / 7, 4) / 384;
  EXPECT_NEAR(extremes[1], 1, bound);
  EXPECT_NEAR(extremes[0], -1, bound);
}

TEST(Section, StrobesAreTheRowsAtMultiplesOfThePeriod)
{
  MotionTrack track = make_sine(10, 100);
  const auto section = make_strobe(track, 0.5);
  ASSERT_EQ(section.size(), 21u);
  EXPECT_EQ(section.values[7], track.values[35]);
  EXPECT_EQ(section.velocities[7], track.velocities[35]);
  // From later on the phase stays: multiples of the period are counted from 0.
  EXPECT_NEAR(make_strobe(cut_before(track, 3.3), 0.5).times[0], 3.5, 1e-12);
  EXPECT_THROW(make_strobe(track, 0), BadInput);
}

TEST(Section, CrossingsAreThoseOfTheCubics)
{
  const auto crossings = make_crossings(make_sine(20, 400), 0.5);
  // Upwards only; the cubics' error h^4 / 384 over the slope.
  ASSERT_EQ(crossings.size(), 4u);
  const double slope = std::sqrt(0.75), bound = std::pow(0.05, 4) / 384 / slope;
  for (std::size_t k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(crossings.times[k], pi / 6 + 2 * pi * double(k), bound);
    EXPECT_EQ(crossings.values[k], 0.5);
    // That of their slopes is of third order.
    EXPECT_NEAR(crossings.velocities[k], slope, std::pow(0.05, 3) / 100);
  }
  // A crossing may be a row.
  EXPECT_EQ(make_crossings(make_sine(2, 4), std::sin(1)).times.at(0), 1);
}

TEST(Section, TimeMeanIsThatOfTheCubics)
{
  // Integral of sin from 0 to pi is 2; Hermite's rule is of fourth order,
  // h^4 / 720 times the length.
  EXPECT_NEAR(compute_time_mean(make_sine(pi, 10)), 2 / pi,
              std::pow(pi / 10, 4) / 720);
}

TEST(Spectrum, LinesHaveTheirHeights)
{
  const auto track = taut::testing::sample(
      32, 4096,
      [](const double t)
      { return 5 + 2 * std::sin(2 * pi * 3 * t) + 0.1 * std::cos(2 * pi * t); },
      [](const double t)
      {
        return 12 * pi * std::cos(2 * pi * 3 * t) -
               0.2 * pi * std::sin(2 * pi * t);
      });
  const auto spectrum = compute_spectrum(track);
  // 4097 rows: up to half the rate of the samples.
  ASSERT_EQ(spectrum.frequencies.size(), 2049u);
  EXPECT_NEAR(spectrum.frequencies[96], 3, 1e-12);
  // The cubics' error, (2 pi 3 h)^4 / 384.
  EXPECT_NEAR(spectrum.amplitudes[96], 2, 2 * 1.3e-6);
  EXPECT_NEAR(spectrum.amplitudes[32], 0.1, 2 * 1.3e-6);
  EXPECT_NEAR(spectrum.amplitudes[0], 0, 1e-9);
  EXPECT_NEAR(compute_line(track, 1), 0.1, 2 * 1.3e-6);
}

TEST(Spectrum, HighestLineIsFoundBetweenFrequencies)
{
  constexpr double frequency = 3.1234;
  const auto track = taut::testing::sample(
      40, 8000,
      [](const double t) { return 2 * std::sin(2 * pi * frequency * t); },
      [](const double t)
      { return 4 * pi * frequency * std::cos(2 * pi * frequency * t); });
  const auto line = find_highest_line(compute_spectrum(track));
  // The line's image at the negative frequency, 250 steps of the spectrum away,
  // leaks 250^-3 of its height.
  EXPECT_NEAR(line.frequency, frequency, 1e-6);
  EXPECT_NEAR(line.amplitude, 2, 1e-5);
  EXPECT_EQ(find_highest_line(compute_spectrum({})).amplitude, 0);
}
} // namespace taut::study
