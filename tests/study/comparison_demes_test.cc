#include <taut/study/comparison_demes.h>

#include <gtest/gtest.h>
#include <study/demes_case.h>
#include <study/silence.h>

#include <cmath>

namespace taut::study
{
namespace
{
using testing::Bow;
using testing::make_demes_case;
using testing::make_demes_mesh;

DemesComparison compare(const Case& film_case, const fe::MeshData& mesh)
{
  const auto equivalent = make_demes_equivalent(film_case, mesh);
  testing::Model model(make_observed_demes_case(film_case).device, mesh);
  testing::Silence silence;
  return compare_demes_models(film_case, equivalent, *model.structure, silence);
}

DemesComparison compare(const Bow& bow, const double end_time)
{
  return compare(make_demes_case(bow, end_time), make_demes_mesh(bow));
}

void expect_same_rest(const DemesModel& film, const DemesModel& lumped,
                      const double tolerance)
{
  const DemesShape &a = film.rest.shape, &b = lumped.rest.shape;
  EXPECT_NEAR(a.angle, b.angle, tolerance * b.angle) << lumped.name;
  EXPECT_NEAR(a.chord, b.chord, tolerance * b.chord) << lumped.name;
  EXPECT_NEAR(a.stretch, b.stretch, tolerance * b.stretch) << lumped.name;
}

double get_rms(const DemesComparison& comparison, const std::string& name)
{
  for (const auto& quantity : comparison.quantities)
    if (quantity.name == name)
      return quantity.rms_relative_difference;
  return std::nan("");
}

/// Limit D2: 20 quadratic elements are within 1e-4 of the elastica.
TEST(ComparisonDemes, AFrameLoadedAtItsEndsIsAnElastica)
{
  Bow bow;
  bow.n_elements = 20;
  const auto comparison = compare(bow, 0.42);
  ASSERT_EQ(comparison.film_summary.status, Status::completed);
  expect_same_rest(comparison.film, comparison.elastica, 1e-4);
  // Arc and elastica of pre-stretch 2: lambda = 1.78243 and 1.60918, theta =
  // 0.8217 and 0.9030 (closed forms).
  EXPECT_NEAR(comparison.elastica.rest.shape.stretch, 1.60918, 1e-5);
  EXPECT_NEAR(comparison.arc.rest.shape.stretch, 1.78243, 1e-5);
  EXPECT_NEAR(comparison.arc.rest.shape.angle, 0.8217, 1e-4);
  // In time: the rotary inertia is all there is but for 1 % of light film and
  // frame, which the lumped model leaves out.
  const double frequency = comparison.elastica.oscillation.frequency;
  EXPECT_NEAR(comparison.film.oscillation.frequency, frequency,
              0.01 * frequency);
  EXPECT_LT(get_rms(comparison, "angle (elastica)"), 0.01);
  EXPECT_GT(get_rms(comparison, "angle"), 0.05);
}

/// Limit D1: with stand-offs the pull bends the frame by moments alone, into an
/// arc; at h/C = 1 and a fifth less stretch arc and elastica differ by 3e-5 in
/// the angle.
TEST(ComparisonDemes, AFrameWithHighStandOffsIsAnArc)
{
  Bow bow;
  bow.stand_off = bow.length();
  bow.stiffness_number = 55;
  const auto comparison = compare(bow, 0.01);
  expect_same_rest(comparison.film, comparison.elastica, 1e-4);
  expect_same_rest(comparison.film, comparison.arc, 1e-4);
  EXPECT_NEAR(comparison.equivalent.device.film_offset, bow.stand_off, 1e-12);
  EXPECT_NEAR(comparison.arc.rest.shape.stretch, 1.6, 0.02);
}

TEST(ComparisonDemes, WithoutADriveNothingSwings)
{
  Case still = make_demes_case({}, 0.1);
  still.device.electrodes[0].voltage = Signal::constant(0);
  const auto comparison = compare(still, make_demes_mesh({}));
  EXPECT_TRUE(std::isnan(comparison.film.oscillation.frequency));
  EXPECT_TRUE(std::isnan(comparison.arc.oscillation.frequency));
  EXPECT_FALSE(comparison.arc.driven);
  // A rest that rests: the lumped models to their tolerance of 1e-9.
  for (const double angle : comparison.arc.angle)
    EXPECT_NEAR(angle, comparison.arc.rest.shape.angle, 1e-8);
}
} // namespace
} // namespace taut::study
