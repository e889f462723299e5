#include <taut/study/comparison.h>

#include <gtest/gtest.h>
#include <study/lumped_records.h>
#include <study/resonator_case.h>
#include <study/silence.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace taut::study
{
namespace
{
using testing::make_case;
using testing::make_mesh;
using testing::shear_modulus;

Comparison compare(const Case& film_case, const fe::MeshData& mesh)
{
  const auto equivalent = make_resonator_equivalent(film_case, mesh);
  testing::Model model(make_observed_case(film_case, equivalent).device, mesh);
  testing::Silence silence;
  return compare_models(film_case, equivalent, *model.structure, silence);
}

const ComparedQuantity& get(const Comparison& comparison,
                            const std::string& name)
{
  for (const auto& quantity : comparison.quantities)
    if (quantity.name == name)
      return quantity;
  throw std::out_of_range(name);
}

/// R0: one affine field per strip. Both models then solve the same equations;
/// what is left is the error of the film's BDF at an internal tolerance of
/// 1e-9 (a few hundred steps).
void expect_same_history(const Comparison& comparison)
{
  EXPECT_GE(comparison.quantities.size(), 9u);
  for (const auto& quantity : comparison.quantities)
    EXPECT_LT(quantity.max_relative_difference, 1e-6) << quantity.name;
}

TEST(Limits, QuasiStaticHistoryAndFailureAgreeWithLoss1)
{
  const auto comparison = compare(make_case(), make_mesh());
  expect_same_history(comparison);
  ASSERT_TRUE(comparison.film_failure && comparison.lumped_failure);
  EXPECT_EQ(comparison.film_failure->kind, "loss of tension along 1");
  EXPECT_EQ(comparison.film_failure->place, "active + passive");
  ASSERT_TRUE(comparison.failure_difference);
  EXPECT_LT(std::abs(comparison.failure_difference->time), 1e-6);
  EXPECT_LT(std::abs(comparison.failure_difference->voltage), 1e-6);
  EXPECT_TRUE(comparison.failure_difference->same_kind);
  EXPECT_TRUE(comparison.failure_difference->same_place);
  // V* = 0.2627 of the reference run with these networks (R-F3, chi = 0.5).
  const double unit =
      1e-3 * std::sqrt(shear_modulus / (4.7 * 8.8541878128e-12));
  EXPECT_NEAR(comparison.film_failure->voltage / unit, 0.2627, 5e-5);
}

TEST(Limits, AFinerMeshChangesNothing)
{
  // The field stays affine whatever the mesh.
  expect_same_history(compare(make_case(), make_mesh(6)));
}

TEST(Limits, UnequalStripsTurnedAroundAgree)
{
  Case turned = make_case();
  turned.device.electrodes.front().groups = {"right"};
  turned.comparison->active_film = "right";
  turned.comparison->passive_film = "left";
  const auto comparison = compare(turned, make_mesh(2, 1.5));
  expect_same_history(comparison);
  ASSERT_TRUE(comparison.failure_difference);
  EXPECT_LT(std::abs(comparison.failure_difference->voltage), 1e-6);
  EXPECT_TRUE(comparison.failure_difference->same_place);
}

TEST(Limits, BreakdownAgrees)
{
  Case weak = make_case();
  for (auto& film : weak.device.films)
    film.material.dielectric.breakdown.reference = 40e6;
  const auto comparison = compare(weak, make_mesh());
  ASSERT_TRUE(comparison.film_failure);
  EXPECT_EQ(comparison.film_failure->kind, "breakdown");
  EXPECT_EQ(comparison.film_failure->place, "active");
  ASSERT_TRUE(comparison.failure_difference);
  EXPECT_LT(std::abs(comparison.failure_difference->voltage), 1e-6);
  EXPECT_TRUE(comparison.failure_difference->same_kind);
  EXPECT_TRUE(comparison.failure_difference->same_place);
}

TEST(Limits, LossOfTensionAcrossAgrees)
{
  // Little stretched across and stiff at once: s_2 of A vanishes first.
  Case narrow = make_case();
  for (auto& film : narrow.device.films)
    film.pre_stretch = {4, 1.2};
  const auto mesh = testing::make_rectangle(2, 1, 1, 0.16, 0.024);
  const auto comparison = compare(narrow, mesh);
  ASSERT_TRUE(comparison.film_failure);
  EXPECT_EQ(comparison.film_failure->kind, "loss of tension along 2");
  EXPECT_EQ(comparison.film_failure->place, "active");
  ASSERT_TRUE(comparison.failure_difference);
  EXPECT_LT(std::abs(comparison.failure_difference->voltage), 1e-6);
  EXPECT_TRUE(comparison.failure_difference->same_place);
}

/// Films that may wrinkle, and stop as they do.
Case make_wrinkling()
{
  Case result = make_case();
  for (auto& film : result.device.films)
    film.tension_field = true;
  result.device.events = {testing::make_event(
      "wrinkles", structure::EventDescription::Kind::wrinkling)};
  return result;
}

TEST(Limits, FilmsWrinkleWhereTheLumpedModelLosesTension)
{
  // Along 1 in both films, and along 2 in the active one.
  Case narrow = make_wrinkling();
  for (auto& film : narrow.device.films)
    film.pre_stretch = {4, 1.2};
  for (const auto& comparison :
       {compare(make_wrinkling(), make_mesh()),
        compare(narrow, testing::make_rectangle(2, 1, 1, 0.16, 0.024))})
  {
    ASSERT_TRUE(comparison.failure_difference);
    EXPECT_LT(std::abs(comparison.failure_difference->voltage), 1e-6);
    EXPECT_LT(std::abs(comparison.failure_difference->time), 1e-6);
    EXPECT_TRUE(comparison.failure_difference->same_kind);
    EXPECT_TRUE(comparison.failure_difference->same_place);
  }
}

TEST(Margins, StandInTheHistoryAndEndAtZero)
{
  Case film_case = make_case();
  film_case.output.write_fields = false;
  film_case.procedure.start = structure::Start::relaxed;
  structure::Probe probe;
  probe.name = "field";
  probe.kind = structure::Probe::Kind::max_true_field;
  probe.of = "left";
  film_case.device.probes = {probe};
  structure::EventDescription passage;
  passage.name = "high field";
  passage.kind = structure::EventDescription::Kind::probe_above;
  passage.of = "field";
  passage.threshold = 10e6;
  film_case.device.events.push_back(passage);
  testing::Model model(film_case.device, make_mesh());
  lumped_records::Records records;
  const auto summary = run_film(film_case, *model.structure, records);
  EXPECT_EQ(summary.status, Status::event);
  EXPECT_EQ(records.columns.back().name, "margin spark");
  EXPECT_EQ(records.columns.back().unit, "1");
  ASSERT_GT(records.rows.size(), 20u);
  EXPECT_EQ(records.get(0, "margin spark"), 1);
  EXPECT_GT(records.get(0, "margin slack"), 0.1);
  for (std::size_t row = 0; row < records.rows.size(); ++row)
    EXPECT_NEAR(records.get(row, "margin spark"),
                1 - records.get(row, "field") / 155e6, 1e-12);
  EXPECT_NEAR(records.get(records.rows.size() - 1, "margin slack"), 0, 1e-9);
  ASSERT_EQ(records.events.size(), 2u);
  EXPECT_EQ(records.events[0].name, "high field");
  EXPECT_NEAR(records.events[0].margin, 0, 1e-12);
  EXPECT_EQ(records.events[1].kind, "tension_loss");
  EXPECT_NEAR(records.events[1].margin, 0, 1e-9);
  EXPECT_NEAR(records.events[1].value, 0, 1e-9 * shear_modulus);
}

Case make_motion(const double bar_mass, const double tolerance)
{
  Case motion = make_case();
  motion.device.bars[0].mass = bar_mass;
  motion.device.electrodes[0].voltage = Signal::steps({0, 0.0125}, {0, 4500});
  motion.procedure.analysis = structure::Analysis::transient;
  motion.procedure.start = structure::Start::relaxed;
  motion.procedure.end_time = 0.25;
  motion.procedure.integrator.method = time::Method::esdirk4;
  motion.procedure.integrator.position_tolerance = tolerance;
  return motion;
}

/// R1: one Q1 cell per strip with consistent mass is the lumped model's linear
/// field of velocity.
TEST(Limits, MotionOfOneCellPerStripAgreesToTheIntegratorsTolerance)
{
  // The local error 1e-11 m adds up over some hundred steps; relative to the
  // amplitude of 5 mm that stays below 1e-6, for velocities (not controlled)
  // below 1e-5.
  const auto fine = compare(make_motion(0.02, 1e-11), make_mesh());
  EXPECT_EQ(fine.film_summary.status, Status::completed);
  for (const auto& quantity : fine.quantities)
    EXPECT_LT(quantity.max_relative_difference,
              quantity.name == "bar velocity" ? 1e-5 : 1e-6)
        << quantity.name;
  // The difference is an error of the integrator: it follows the tolerance.
  const auto coarse = compare(make_motion(0.02, 1e-8), make_mesh());
  EXPECT_LT(get(fine, "bar displacement").max_relative_difference,
            0.1 * get(coarse, "bar displacement").max_relative_difference);
}

TEST(Limits, AHeavyBarHidesTheWavesOfTheStripsALightOneDoesNot)
{
  // The strips weigh 0.384 g each. R2: the lumped frequency is too high by
  // 1.7 % at equal masses and by 0.002 % at fifty times that. Within a quarter
  // of a second the light bar swings some fifteen times, a phase of 1.6 in a
  // motion that its networks damp; the heavy one three times, a phase of
  // 0.0004.
  const auto light = compare(make_motion(0.384e-3, 1e-8), make_mesh(8));
  const auto heavy = compare(make_motion(50 * 0.384e-3, 1e-8), make_mesh(8));
  EXPECT_GT(get(light, "bar displacement").max_relative_difference, 0.05);
  EXPECT_LT(get(heavy, "bar displacement").max_relative_difference, 1e-3);
}
} // namespace
} // namespace taut::study
