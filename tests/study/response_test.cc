#include <taut/base/exceptions.h>
#include <taut/lumped/demes_statics.h>
#include <taut/study/lumped_case_demes.h>
#include <taut/study/response.h>
#include <taut/study/run_demes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "lumped_cases.h"
#include "lumped_records.h"

namespace taut::study
{
namespace
{
using lumped_records::Records;
using taut::testing::make_lumped_demes_case;

Case make_response_case(const double pre_stretch, const double from,
                        const double to, const unsigned int points)
{
  Case result = make_lumped_demes_case(pre_stretch);
  result.procedure.analysis = structure::Analysis::frequency_response;
  auto& response = result.procedure.frequency_response;
  response.from = from;
  response.to = to;
  response.points = points;
  response.offset = 1000;
  response.amplitude = 5000;
  return result;
}

/// |theta| over a small amplitude of the voltage (rad/V) about the equilibrium
/// at a constant one, with a dashpot of the relaxation time
/// S lambda^2 / (4 beta).
double compute_linear_response(const LumpedDemesDescription& device,
                               const double voltage, const double frequency)
{
  const auto si = make_demes_si(device);
  const auto demes = lumped::make_demes(si);
  const double drive = voltage / demes.drive_unit;
  const auto rest = lumped::find_equilibria(demes, drive).back();
  const double stretch = rest.stretch;
  const double slope =
      demes.pre_stretch *
      lumped::compute_chord(rest.angle, demes.eccentricity).slope;
  const double w = 2 * std::acos(-1.) * frequency * demes.time_unit;
  const std::complex<double> lag(0, w * demes.relaxation * stretch * stretch /
                                        (4 * demes.viscous_ratio));
  const double relaxed = rest.frequencies.relaxed_squared;
  const double instantaneous = rest.frequencies.instantaneous_squared;
  const std::complex<double> stiffness =
      relaxed + (instantaneous - relaxed) * lag / (1. + lag) - w * w;
  // The electric force goes with the square of the drive.
  const double pull =
      slope * 2 * lumped::compute_electric(demes, stretch, drive).force / drive;
  return std::abs(pull / stiffness) / demes.drive_unit;
}
} // namespace

TEST(SettlingWatch, SeesHowMuchOfADecayIsStillToCome)
{
  // Amplitudes 1 + q^k: after k blocks q^k is still to come.
  const double q = 0.8, tolerance = 1e-3;
  SettlingWatch watch(tolerance);
  int first = 0;
  for (int k = 1; first == 0 && k < 200; ++k)
    if (watch.add(0.5, 1 + std::pow(q, k)))
      first = k;
  // And one more.
  EXPECT_EQ(first, 1 + int(std::ceil(std::log(tolerance) / std::log(q))));
}

TEST(SettlingWatch, NeverSeesAMotionSettleThatGoesOnChanging)
{
  SettlingWatch drifting(1e-3), beating(1e-3);
  for (int k = 0; k < 100; ++k)
  {
    EXPECT_FALSE(drifting.add(1e-4 * k, 1));
    EXPECT_FALSE(beating.add(0, 1 + 0.01 * std::cos(2.4 * k)));
  }
}

TEST(Response, OfASmallDriveIsLinear)
{
  Case run_case = make_response_case(3, 3, 13, 6);
  run_case.lumped_demes.tolerance = 1e-12;
  auto& response = run_case.procedure.frequency_response;
  response.offset = 5000;
  response.amplitude = 1;
  response.settled_within = 1e-5;
  for (const ResponsePoint& point : compute_response(run_case))
  {
    const double exact =
        compute_linear_response(run_case.lumped_demes, 5000, point.frequency);
    // Nonlinear parts are 1e-4 of the drive's; what has not settled 1e-5.
    EXPECT_NEAR(point.first_amplitude / exact, 1, 5e-4) << point.frequency;
    EXPECT_NEAR(point.amplitude / exact, 1, 1e-3) << point.frequency;
    EXPECT_NEAR(point.rms / exact, std::sqrt(0.5), 1e-3) << point.frequency;
    EXPECT_LT(point.second_amplitude, 0.01 * exact);
    EXPECT_TRUE(point.settled && point.reproducible);
    EXPECT_EQ(point.period_number, 1u);
  }
}

TEST(Response, JumpsElsewhereUpThanDown)
{
  Case run_case = make_response_case(3, 6, 9, 16);
  auto& response = run_case.procedure.frequency_response;
  response.direction = FrequencyResponseDescription::Direction::both;
  Records records;
  const auto summary = run_demes(run_case, records);
  const auto points = compute_response(run_case);
  ASSERT_EQ(points.size(), 32u);
  // A softening spring: downwards the large motion lives on to a frequency
  // where upwards the small one is still alone.
  const auto& up = points[5];
  const auto& down = points[31 - 5];
  EXPECT_EQ(up.frequency, 7);
  EXPECT_EQ(down.frequency, 7);
  EXPECT_GT(down.amplitude, 5 * up.amplitude);
  EXPECT_TRUE(up.settled && down.settled);
  ASSERT_FALSE(summary.notes.empty());
  EXPECT_NE(summary.notes[0].find("rises or falls"), std::string::npos);
  const Table& table = summary.tables.at("response");
  EXPECT_EQ(table.rows.size(), 32u);
  EXPECT_EQ(table.rows[5][0], 7);
  EXPECT_EQ(table.rows[5][1], 1);
  EXPECT_EQ(table.rows[26][1], -1);
  EXPECT_EQ(table.rows[5][5], up.amplitude);
  EXPECT_EQ(records.rows, table.rows);
}

TEST(Response, FromRestIsARunOfItsOwn)
{
  Case run_case = make_response_case(3, 5, 8, 2);
  auto& response = run_case.procedure.frequency_response;
  response.from_rest = true;
  response.observation_time = 4;
  const auto point = compute_response(run_case).at(0);
  EXPECT_EQ(point.periods, 20u);
  Case transient = make_lumped_demes_case(3);
  transient.lumped_demes.source = Signal::sine(1000, 5000, 5, 0);
  transient.procedure.end_time = 4;
  transient.output.history_intervals = 4000;
  Records records;
  run_demes(transient, records);
  double lowest = 9, highest = 0, last_lowest = 9, last_highest = 0;
  for (std::size_t i = 0; i < records.rows.size(); ++i)
  {
    const double angle = records.get(i, "angle");
    lowest = std::min(lowest, angle);
    highest = std::max(highest, angle);
    // The last block of 8 periods.
    if (records.get(i, "time") < 2.4)
      continue;
    last_lowest = std::min(last_lowest, angle);
    last_highest = std::max(last_highest, angle);
  }
  // 1000 rows a second miss an extreme by (w h)^2 / 8 of the amplitude.
  EXPECT_NEAR(point.lowest, lowest, 1e-4);
  EXPECT_NEAR(point.highest, highest, 1e-4);
  EXPECT_NEAR(point.minimum, last_lowest, 1e-4);
  EXPECT_NEAR(point.maximum, last_highest, 1e-4);
}

TEST(Response, OfAResonatorIsProportionalToASmallDrive)
{
  Case run_case = taut::testing::make_lumped_resonator_case();
  run_case.procedure.analysis = structure::Analysis::frequency_response;
  auto& response = run_case.procedure.frequency_response;
  response.from = response.to = 4;
  response.points = 1;
  response.offset = 2000;
  response.amplitude = 20;
  const auto one = compute_response(run_case).at(0);
  response.amplitude = 40;
  const auto two = compute_response(run_case).at(0);
  EXPECT_TRUE(one.settled && two.settled);
  EXPECT_GT(one.first_amplitude, 0);
  // The next part goes with the cube of 40 V over 2 kV.
  EXPECT_NEAR(two.first_amplitude / one.first_amplitude, 2, 2e-3);
}

TEST(Response, OfAFailingResonatorHasNoNumbersButANote)
{
  Case run_case = taut::testing::make_lumped_resonator_case();
  run_case.procedure.analysis = structure::Analysis::frequency_response;
  auto& response = run_case.procedure.frequency_response;
  response.from = response.to = 4;
  response.points = 1;
  // On the way, then already at the start.
  for (const double offset : {5000., 1e6})
  {
    response.offset = offset;
    response.amplitude = 30e3;
    Records records;
    const auto failed = run_response(run_case, records);
    EXPECT_TRUE(std::isnan(failed.tables.at("response").rows.at(0).at(5)));
    ASSERT_EQ(failed.notes.size(), 1u);
    EXPECT_NE(failed.notes[0].find("fails"), std::string::npos);
  }
}

TEST(Response, FrequenciesAreSpaced)
{
  FrequencyResponseDescription description;
  description.from = 1;
  description.to = 100;
  description.points = 3;
  EXPECT_EQ(make_frequencies(description), (std::vector<double>{1, 50.5, 100}));
  description.is_logarithmic = true;
  EXPECT_NEAR(make_frequencies(description)[1], 10, 1e-12);
  description.points = 1;
  EXPECT_EQ(make_frequencies(description), (std::vector<double>{1}));
}

TEST(Response, NeedsALumpedModelAndAColumn)
{
  Case run_case = make_response_case(3, 1, 2, 2);
  run_case.procedure.frequency_response.of = "angel";
  EXPECT_THROW(compute_response(run_case), BadInput);
  run_case.model = "film";
  EXPECT_THROW(compute_response(run_case), BadInput);
}
} // namespace taut::study
