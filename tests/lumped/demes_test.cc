#include <taut/base/exceptions.h>
#include <taut/lumped/demes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace taut;
using namespace taut::lumped;

namespace
{
/// Central difference of order 4: error about 1e-12 for values of order 1.
double differentiate(const std::function<double(double)>& f, const double x)
{
  constexpr double h = 1e-3;
  return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h);
}
constexpr double difference_error = 1e-9;

Demes make_bent_demes(const DemesControl control)
{
  Demes demes;
  demes.pre_stretch = 3;
  demes.frame_stiffness = 0.9;
  demes.modulus_factor = 0.8;
  demes.permittivity_factor = 0.95;
  demes.eccentricity = 0.02;
  demes.rest_angle = 0.1;
  demes.control = control;
  return demes;
}

constexpr DemesControl controls[] = {DemesControl::voltage,
                                     DemesControl::charge};
} // namespace

TEST(DemesChord, EqualsTheQuotientsFarFromZero)
{
  for (const double eccentricity : {0., 0.02, -0.3, 2.})
    for (const double x : {-3.1, -1.3, 0.4, 1., 2.5, 3.14159})
    {
      const auto chord = compute_chord(x, eccentricity);
      const double sine = std::sin(x), cosine = std::cos(x);
      EXPECT_NEAR(chord.value, sine / x - eccentricity * sine, 4e-15);
      EXPECT_NEAR(chord.slope,
                  (x * cosine - sine) / (x * x) - eccentricity * cosine, 1e-14);
      EXPECT_NEAR(chord.curvature,
                  -sine / x - 2 * cosine / (x * x) + 2 * sine / (x * x * x) +
                      eccentricity * sine,
                  1e-14);
    }
}

TEST(DemesChord, IsItsSeriesNearZero)
{
  const auto straight = compute_chord(0, 0);
  EXPECT_EQ(straight.value, 1);
  EXPECT_EQ(straight.slope, 0);
  EXPECT_DOUBLE_EQ(straight.curvature, -1. / 3);
  const double x = 1e-3, y = x * x;
  const auto chord = compute_chord(x, 0);
  EXPECT_DOUBLE_EQ(chord.value, 1 - y / 6 + y * y / 120);
  EXPECT_DOUBLE_EQ(chord.slope, -x / 3 * (1 - y / 10 * (1 - y / 28)));
  EXPECT_DOUBLE_EQ(compute_chord(x, 0.1).slope, chord.slope - 0.1 * cos(x));
}

TEST(DemesChord, IsContinuousWhereTheEndsMeet)
{
  const double pi = std::acos(-1.);
  for (const double eccentricity : {0., 0.1})
  {
    const auto below = compute_chord(pi - 1e-9, eccentricity);
    const auto above = compute_chord(pi + 1e-9, eccentricity);
    EXPECT_NEAR(below.value, above.value, 2e-9);
    EXPECT_NEAR(below.slope, above.slope, 2e-9);
    EXPECT_NEAR(below.curvature, above.curvature, 2e-9);
  }
}

TEST(DemesEnergy, ItsDerivativeIsTheMoment)
{
  for (const auto control : controls)
  {
    const Demes demes = make_bent_demes(control);
    for (const double angle : {-1.2, 0.3, 1.7})
    {
      const auto energy = [&](const double x)
      { return compute_free_energy(demes, x, 1.9, 0.6); };
      EXPECT_NEAR(differentiate(energy, angle),
                  -compute_acceleration(demes, angle, 1.9, 0.6),
                  difference_error);
    }
  }
}

TEST(DemesEnergy, ItsDerivativeByTheInnerStretchDrivesTheDashpot)
{
  const Demes demes = make_bent_demes(DemesControl::voltage);
  const double angle = 1.1, inner = 2.2;
  const double stretch =
      demes.pre_stretch * compute_chord(angle, demes.eccentricity).value;
  const auto energy = [&](const double x)
  { return compute_free_energy(demes, angle, x, 0.3); };
  const double rate = compute_inner_rate(demes, stretch, inner);
  EXPECT_NEAR(-differentiate(energy, inner) * rate,
              compute_dissipation(demes, stretch, inner),
              difference_error * std::abs(rate));
  EXPECT_GT(compute_dissipation(demes, stretch, inner), 0);
  EXPECT_EQ(compute_inner_rate(demes, 1.7, 1.7), 0);
}

TEST(DemesElectric, ForceStiffnessAndConjugateAreDerivatives)
{
  for (const auto control : controls)
  {
    const Demes demes = make_bent_demes(control);
    const double stretch = 2.3, drive = 0.7;
    const auto state = compute_electric(demes, stretch, drive);
    const auto energy = [&](const double x)
    { return compute_electric(demes, x, drive).energy; };
    const auto force = [&](const double x)
    { return compute_electric(demes, x, drive).force; };
    const auto energy_of_drive = [&](const double x)
    { return compute_electric(demes, stretch, x).energy; };
    EXPECT_NEAR(differentiate(energy, stretch), state.force, difference_error);
    EXPECT_NEAR(differentiate(force, stretch), state.stiffness,
                difference_error);
    const double sign = control == DemesControl::voltage ? -1 : 1;
    EXPECT_NEAR(differentiate(energy_of_drive, drive), sign * state.conjugate,
                difference_error);
  }
}

TEST(DemesElectric, ChargeAndVoltageGiveTheSameForceButNotStiffness)
{
  Demes voltage;
  voltage.permittivity = {};
  Demes charge = voltage;
  charge.control = DemesControl::charge;
  const double stretch = 1.8, e = 0.4;
  const auto by_voltage = compute_electric(voltage, stretch, e);
  const auto by_charge =
      compute_electric(charge, stretch, by_voltage.conjugate);
  EXPECT_DOUBLE_EQ(by_charge.conjugate, e);
  EXPECT_DOUBLE_EQ(by_charge.force, by_voltage.force);
  EXPECT_DOUBLE_EQ(by_voltage.force, -e * e * stretch);
  EXPECT_DOUBLE_EQ(by_voltage.stiffness, -e * e);
  EXPECT_DOUBLE_EQ(by_charge.stiffness, 3 * e * e);
}

TEST(DemesFrequencies, AreDerivativesOfTheMoment)
{
  for (const auto control : controls)
  {
    const Demes demes = make_bent_demes(control);
    const double angle = 1.4, drive = 0.5;
    const auto stretch = [&](const double x)
    { return demes.pre_stretch * compute_chord(x, demes.eccentricity).value; };
    const auto relaxed = [&](const double x)
    { return -compute_acceleration(demes, x, stretch(x), drive); };
    const auto held = [&](const double x)
    { return -compute_acceleration(demes, x, stretch(angle), drive); };
    const auto squared = compute_frequencies(demes, angle, drive);
    EXPECT_NEAR(differentiate(relaxed, angle), squared.relaxed_squared,
                difference_error);
    EXPECT_NEAR(differentiate(held, angle), squared.instantaneous_squared,
                difference_error);
  }
}

TEST(DemesPermittivity, FollowsTheLawOfTheSource)
{
  // Wang et al.: a, b, c of the law in lambda_1 + lambda_2 - 2 = 1.
  EXPECT_DOUBLE_EQ(wang_permittivity.value(2),
                   1 - 0.1658 + 0.04086 - 0.00302754);
  EXPECT_NEAR(differentiate([](const double x)
                            { return wang_permittivity.value(x); },
                            2.5),
              wang_permittivity.derivative(2.5), difference_error);
  EXPECT_NEAR(differentiate([](const double x)
                            { return wang_permittivity.derivative(x); },
                            2.5),
              wang_permittivity.second_derivative(2.5), difference_error);
}

TEST(DemesRefusals, ImpossibleParametersAreNamed)
{
  const auto expect_refusal = [](const auto& change, const std::string& words)
  {
    Demes demes;
    change(demes);
    try
    {
      validate(demes);
      ADD_FAILURE() << "accepted: " << words;
    }
    catch (const BadInput& error)
    {
      EXPECT_NE(error.message().find(words), std::string::npos)
          << error.message();
    }
  };
  expect_refusal([](Demes& d) { d.pre_stretch = 0; }, "pre-stretch");
  expect_refusal([](Demes& d) { d.frame_stiffness = -1; }, "stiffness K");
  expect_refusal([](Demes& d) { d.relaxation = 0; }, "relaxation number");
  expect_refusal([](Demes& d) { d.modulus_factor = 0; }, "shear modulus");
  expect_refusal([](Demes& d) { d.permittivity_factor = 0; }, "permittivity");
  expect_refusal([](Demes& d) { d.viscous_ratio = -1; }, "ratio beta");
  expect_refusal([](Demes& d)
                 { d.eccentricity = std::numeric_limits<double>::infinity(); },
                 "eccentricity");
  expect_refusal([](Demes& d) { d.rest_angle = 4; }, "rest angle");
  expect_refusal([](Demes& d) { d.drive_unit = 0; }, "unit of the drive");
  expect_refusal([](Demes& d) { d.time_unit = 0; }, "unit of time");
}
