#include <taut/base/exceptions.h>
#include <taut/lumped/demes_run.h>
#include <taut/lumped/demes_si.h>
#include <taut/lumped/demes_statics.h>
#include <taut/lumped/resonator_si.h>
#include <taut/lumped/run_all.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

using namespace taut;
using namespace taut::lumped;

namespace
{
const double pi = std::acos(-1.);

/// A VHB film on an ABS frame, chosen so that K = 1 and e(5 kV) = 0.3.
DemesSI make_device(const double pre_stretch)
{
  DemesSI device;
  device.film_length = 0.02;
  device.film_width = 0.04;
  device.film_thickness = 5e-4;
  device.pre_stretch = pre_stretch;
  device.shear_modulus = 52246.6;
  device.viscosity = 49.9;
  device.frame_modulus = 2e9;
  device.frame_thickness = 5e-4;
  device.frame_width = 0.2508 * pre_stretch * device.film_length;
  device.inertia = 2.117476e-5;
  device.relative_permittivity = 5.310702;
  device.laws = make_temperature_laws("softening");
  device.source = Signal::constant(5000);
  return device;
}

double compute_hertz(const DemesSI& device, const double squared)
{
  return std::sqrt(squared) * make_scales(device).angular_frequency / (2 * pi);
}
} // namespace

// Numbers of the parameter set, as many digits as it gives.
TEST(DemesSI, BecomesTheDimensionlessModel)
{
  const auto device = make_device(2);
  const Demes demes = make_demes(device);
  const auto scales = make_scales(device);
  EXPECT_NEAR(demes.frame_stiffness, 1, 2e-4);
  EXPECT_NEAR(demes.relaxation, 0.03, 2e-5);
  EXPECT_EQ(demes.modulus_factor, 1);
  EXPECT_EQ(demes.permittivity_factor, 1);
  EXPECT_NEAR(demes.drive.value(0) / demes.drive_unit, 0.3, 1e-6);
  EXPECT_NEAR(scales.energy, 0.02089865, 2e-8);
  EXPECT_NEAR(scales.angular_frequency / (2 * pi), 5, 1e-5);
  EXPECT_DOUBLE_EQ(scales.time * scales.angular_frequency, 1);
  EXPECT_DOUBLE_EQ(demes.time_unit, scales.time);
}

// Force at rest (N), frequencies (Hz), four digits.
TEST(DemesSI, ForcesAndFrequenciesOfTheParameterSet)
{
  const std::vector<std::vector<double>> rows = {
      {2, 1.678, 3.455, 5.704},   {2.5, 1.564, 6.622, 11.244},
      {3, 1.465, 8.717, 15.150},  {3.5, 1.378, 10.465, 18.542},
      {4, 1.301, 12.050, 21.694}, {4.5, 1.231, 13.552, 24.721},
      {5, 1.168, 15.009, 27.678}};
  for (const auto& row : rows)
  {
    const auto device = make_device(row[0]);
    const auto state = find_equilibria(make_demes(device), 0).back();
    EXPECT_NEAR(state.membrane_force * make_scales(device).force, row[1], 1e-3);
    EXPECT_NEAR(compute_hertz(device, state.frequencies.relaxed_squared),
                row[2], 2e-3);
    EXPECT_NEAR(compute_hertz(device, state.frequencies.instantaneous_squared),
                row[3], 3e-3);
  }
}

TEST(DemesSI, UnitsOfVoltageAndChargeMakeTheUnitOfEnergy)
{
  auto device = make_device(3);
  const auto scales = make_scales(device);
  EXPECT_NEAR(scales.voltage * scales.charge / scales.energy, 1, 1e-14);
  // A flat plate of the undeformed film: Q = eps A / t V.
  const double permittivity =
      device.relative_permittivity * vacuum_permittivity;
  const double area = device.film_length * device.film_width;
  EXPECT_NEAR(scales.charge / scales.voltage,
              permittivity * area / device.film_thickness, 1e-22);
  device.control = DemesControl::charge;
  EXPECT_EQ(make_demes(device).drive_unit, scales.charge);
}

TEST(DemesSI, RunsInSecondsEqualDimensionlessRuns)
{
  auto device = make_device(3);
  device.source = Signal::sine(1000, 5000, 7.5, 0);
  const Demes demes = make_demes(device);
  Demes pure = demes;
  pure.drive = make_drive(5000 / demes.drive_unit, 5, 1, 5,
                          2 * pi * 7.5 * demes.time_unit);
  pure.drive_unit = pure.time_unit = 1;
  DemesRunOptions options;
  options.start = make_rest_start(demes);
  options.end_time = 20;
  EXPECT_NEAR(run_demes(demes, options).rows.back().angle,
              run_demes(pure, options).rows.back().angle, 1e-10);
}

// K, m, S at S(299 K) = 0.03, g and the relaxed frequency and angle for
// lambda_p = 2 and 5.
TEST(DemesTemperature, SofteningGivesTheTableOfHeatedStates)
{
  struct Row
  {
    double temperature, stiffness, modulus, relaxation, permittivity;
    double angle_2, angle_5, frequency_2, frequency_5;
  };
  const Row rows[] = {{299, 1, 1, 0.03, 1, .8217, 2.3809, .691, 3.002},
                      {320, .874, .895, .013589131, .96032495749103, .8613,
                       2.3871, .682, 2.852},
                      {340, .754, .795, .0070006544, .9270957202076, .9068,
                       2.3945, .674, 2.702},
                      {360, .634, .695, .0038823214, .89755862040011, .9629,
                       2.4039, .665, 2.544}};
  for (const Row& row : rows)
  {
    auto device = make_device(2);
    device.temperature = 299;
    const Demes cold = make_demes(device);
    device.temperature = row.temperature;
    Demes hot = make_demes(device);
    EXPECT_NEAR(hot.frame_stiffness / cold.frame_stiffness, row.stiffness,
                1e-14);
    EXPECT_NEAR(hot.modulus_factor, row.modulus, 1e-14);
    EXPECT_NEAR(0.03 * hot.relaxation / cold.relaxation, row.relaxation, 1e-9);
    EXPECT_NEAR(hot.permittivity_factor, row.permittivity, 1e-13);
    hot.frame_stiffness = row.stiffness;
    const auto check = [&](const double pre_stretch, const double angle,
                           const double frequency)
    {
      hot.pre_stretch = pre_stretch;
      const auto state = find_equilibria(hot, 0).back();
      EXPECT_NEAR(state.angle, angle, 6e-5);
      EXPECT_NEAR(std::sqrt(state.frequencies.relaxed_squared), frequency,
                  6e-4);
    };
    check(2, row.angle_2, row.frequency_2);
    check(5, row.angle_5, row.frequency_5);
  }
}

TEST(DemesTemperature, LawsByName)
{
  EXPECT_EQ(
      compute_factor(make_temperature_laws("constant").shear_modulus, 350), 1);
  const auto entropic = make_temperature_laws("entropic");
  EXPECT_NEAR(compute_factor(entropic.shear_modulus, 350), 350. / 299, 1e-14);
  EXPECT_FALSE(entropic.source.empty());
  try
  {
    make_temperature_laws("softning");
    ADD_FAILURE() << "accepted";
  }
  catch (const BadInput& error)
  {
    EXPECT_NE(error.message().find("'softening'"), std::string::npos)
        << error.message();
  }
}

TEST(DemesTemperature, PolynomialOfAnyDegree)
{
  const PolynomialFactor law{300, {0.1, -0.02}, 250, 350};
  EXPECT_DOUBLE_EQ(compute_factor(law, 310), 1 + 0.1 * 10 - 0.02 * 100);
}

TEST(DemesTemperature, OutsideItsRangeIsRefusedWithTheRange)
{
  auto device = make_device(2);
  device.temperature = 400;
  try
  {
    make_demes(device);
    ADD_FAILURE() << "accepted";
  }
  catch (const BadInput& error)
  {
    EXPECT_NE(error.message().find("between 260 K and 365 K"),
              std::string::npos)
        << error.message();
  }
  EXPECT_THROW(compute_factor(ConstantFactor{}, 0), BadInput);
}

TEST(DemesSIRefusals, ImpossibleValuesAreNamed)
{
  const auto expect_refusal = [](const auto& change, const std::string& words)
  {
    auto device = make_device(2);
    change(device);
    try
    {
      make_demes(device);
      ADD_FAILURE() << "accepted: " << words;
    }
    catch (const BadInput& error)
    {
      EXPECT_NE(error.message().find(words), std::string::npos)
          << error.message();
    }
  };
  expect_refusal([](DemesSI& d) { d.film_length = 0; }, "length of the film");
  expect_refusal([](DemesSI& d) { d.film_width = 0; }, "width of the film");
  expect_refusal([](DemesSI& d) { d.film_thickness = -1; }, "thickness of the");
  expect_refusal([](DemesSI& d) { d.pre_stretch = 0; }, "pre-stretch");
  expect_refusal([](DemesSI& d) { d.shear_modulus = 0; }, "shear modulus");
  expect_refusal([](DemesSI& d) { d.viscosity = 0; }, "viscosity");
  expect_refusal([](DemesSI& d) { d.frame_modulus = 0; },
                 "modulus of the frame");
  expect_refusal([](DemesSI& d) { d.frame_width = 0; }, "legs");
  expect_refusal([](DemesSI& d) { d.frame_thickness = 0; }, "of the frame");
  expect_refusal([](DemesSI& d) { d.inertia = 0; }, "inertia");
  expect_refusal([](DemesSI& d) { d.relative_permittivity = 0.5; },
                 "relative permittivity");
  expect_refusal([](DemesSI& d) { d.film_offset = 1; }, "distance of the film");
}

TEST(RunAll, DoesEveryTaskOnceOnAnyNumberOfThreads)
{
  for (const unsigned int threads : {0u, 1u, 3u, 50u})
  {
    std::vector<int> done(20, 0);
    run_all(
        done.size(), [&](const std::size_t i) { ++done[i]; }, threads);
    EXPECT_EQ(done, std::vector<int>(20, 1));
  }
  run_all(0, [](std::size_t) { FAIL(); });
}

TEST(RunAll, PassesOnWhatATaskThrows)
{
  for (const unsigned int threads : {1u, 4u})
    EXPECT_THROW(run_all(
                     100,
                     [](const std::size_t i)
                     {
                       if (i == 30)
                         throw BadInput("thirty");
                     },
                     threads),
                 BadInput);
}

TEST(RunAll, SweepEqualsSingleRuns)
{
  const auto compute = [](const std::size_t i)
  {
    Demes demes = make_demes(make_device(2 + 0.1 * double(i)));
    DemesRunOptions options;
    options.start = make_rest_start(demes);
    options.end_time = 20;
    return run_demes(demes, options).rows.back().angle;
  };
  std::vector<double> angles(16);
  run_all(
      angles.size(), [&](const std::size_t i) { angles[i] = compute(i); }, 4);
  for (std::size_t i = 0; i < angles.size(); ++i)
    EXPECT_EQ(angles[i], compute(i));
}
