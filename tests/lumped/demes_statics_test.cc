#include <taut/base/exceptions.h>
#include <taut/lumped/demes_run.h>
#include <taut/lumped/demes_statics.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace taut;
using namespace taut::lumped;

namespace
{
/// lambda_p, K, m, g, e, epsilon; theta, lambda, omega relaxed and
/// instantaneous: equilibria of another program, 14 digits (every 17th row of
/// its table).
const std::vector<std::vector<double>>& get_reference()
{
  static const std::vector<std::vector<double>> rows = {
      // clang-format off
      {2, 1, 1, 1, 0, 0,
       0.82167533136689, 1.7824260307186, 0.69090477864096, 1.1408067084512},
      {3.5, 1, 1, 1, 0.15, 0,
       2.0004673600692, 1.5905582832306, 2.0713472960055, 3.6701706811287},
      {5, 1, 1, 1, 0.3, 0,
       2.3535999648336, 1.506073708852, 2.8847849193407, 5.3364424871768},
      {3, 1, 1, 1, 0.45, 0.02,
       1.6245971091514, 1.7840266100916, 1.5574565949893, 2.680955377423},
      {4.5, 1, 1, 1, 0.6, 0.02,
       2.0951493534517, 1.7813463108659, 2.2484515446411, 4.0797762488833},
      {2.5, 0.874, 0.895, 0.96032495749103, 0.15, 0,
       1.4630845474971, 1.6988162001059, 1.2448939039394, 2.124272225684},
      {4, 0.874, 0.895, 0.96032495749103, 0.3, 0,
       2.1381893512037, 1.5776056872792, 2.1918811749984, 3.9663789997641},
      {2, 0.874, 0.895, 0.96032495749103, 0.45, 0.02,
       0.5835295200941, 1.8663756739942, 0.56636328889878, 0.86673713908225},
      {3.5, 0.874, 0.895, 0.96032495749103, 0.6, 0.02,
       1.7561188814879, 1.8901030361377, 1.6087283802633, 2.82847595577},
      {5, 0.754, 0.795, 0.9270957202076, 0, 0.02,
       2.3577149622851, 1.4266746615516, 2.6338461382008, 4.8590088836634},
      {3, 0.754, 0.795, 0.9270957202076, 0.3, 0,
       1.7628437033737, 1.6705091496303, 1.4887788331295, 2.6132465871591},
      {4.5, 0.754, 0.795, 0.9270957202076, 0.45, 0,
       2.2159369004127, 1.6225952138653, 2.1854125629919, 4.0370082502235},
      {2.5, 0.754, 0.795, 0.9270957202076, 0.6, 0.02,
       1.0566939833273, 2.0165074138271, 0.84500130109968, 1.4138327859575},
      {4, 0.634, 0.695, 0.89755862040011, 0, 0.02,
       2.159825865329, 1.4733839018219, 2.0059391403916, 3.6397848097919},
      {2, 0.634, 0.695, 0.89755862040011, 0.3, 0,
       0.79315970600287, 1.7967974459723, 0.53791983417187, 0.90525519468951},
      {3.5, 0.634, 0.695, 0.89755862040011, 0.45, 0,
       1.9189890033532, 1.7144278386823, 1.5552718956622, 2.8019794428375},
      {5, 0.634, 0.695, 0.89755862040011, 0.6, 0,
       2.2285131644829, 1.7756009458156, 2.014925856473, 3.7979430549148},
      // clang-format on
  };
  return rows;
}

const std::vector<double> pre_stretches = {2, 2.5, 3, 3.5, 4, 4.5, 5};

Demes make_demes(const double pre_stretch)
{
  Demes demes;
  demes.pre_stretch = pre_stretch;
  return demes;
}
} // namespace

TEST(DemesStatics, EquilibriaOfTheReferenceAreReproduced)
{
  for (const auto& row : get_reference())
  {
    Demes demes = make_demes(row[0]);
    demes.frame_stiffness = row[1];
    demes.modulus_factor = row[2];
    demes.permittivity_factor = row[3];
    demes.eccentricity = row[5];
    const auto state = find_equilibria(demes, row[4]).back();
    EXPECT_TRUE(state.stable);
    // Round-off of both programs, and the 14 digits of the table.
    EXPECT_NEAR(state.angle, row[6], 1e-12);
    EXPECT_NEAR(state.stretch, row[7], 1e-12);
    EXPECT_NEAR(std::sqrt(state.frequencies.relaxed_squared), row[8], 1e-12);
    EXPECT_NEAR(std::sqrt(state.frequencies.instantaneous_squared), row[9],
                1e-12);
  }
}

// Wang et al., text of figure 6.
TEST(DemesStatics, SevenInnerStretchesComeOutToThePrintedDigits)
{
  const std::vector<double> printed = {1.78, 1.70, 1.63, 1.57,
                                       1.53, 1.48, 1.45};
  for (std::size_t i = 0; i < printed.size(); ++i)
  {
    const double inner =
        make_rest_start(make_demes(pre_stretches[i])).inner_stretch;
    EXPECT_DOUBLE_EQ(std::round(100 * inner) / 100, printed[i]);
  }
}

TEST(DemesStatics, StraightStateIsReportedWithItsStability)
{
  for (const double pre_stretch : pre_stretches)
  {
    const auto states = find_equilibria(make_demes(pre_stretch), 0);
    ASSERT_EQ(states.size(), 3u);
    EXPECT_EQ(states[1].angle, 0);
    EXPECT_EQ(states[1].stretch, pre_stretch);
    EXPECT_FALSE(states[1].stable);
    EXPECT_EQ(states[0].angle, -states[2].angle);
    EXPECT_TRUE(states[0].stable && states[2].stable);
    EXPECT_LT(states[2].energy, states[1].energy);
  }
}

TEST(DemesStatics, BendingBeginsAtTheCriticalPreStretch)
{
  const double critical = compute_critical_pre_stretch(make_demes(2));
  EXPECT_NEAR(critical, 1.8174, 5e-5);
  const auto below = find_equilibria(make_demes(critical - 1e-4), 0);
  ASSERT_EQ(below.size(), 1u);
  EXPECT_TRUE(below[0].stable);
  EXPECT_EQ(below[0].angle, 0);
  EXPECT_EQ(find_equilibria(make_demes(critical + 1e-4), 0).size(), 3u);
  EXPECT_NEAR(
      find_equilibria(make_demes(critical), 0)[0].frequencies.relaxed_squared,
      0, 1e-14);
}

// Numbers of an independent derivation, three digits.
TEST(DemesStatics, GrowthRatesAndFlatteningVoltages)
{
  const std::vector<double> rates = {0.500, 1.015, 1.401, 1.748,
                                     2.077, 2.395, 2.706};
  const std::vector<double> flat = {0.491, 0.810, 0.934, 0.991,
                                    1.016, 1.024, 1.025};
  for (std::size_t i = 0; i < rates.size(); ++i)
  {
    const Demes demes = make_demes(pre_stretches[i]);
    const double square = pre_stretches[i] * pre_stretches[i];
    EXPECT_DOUBLE_EQ(compute_growth_rate(demes, 0),
                     std::sqrt((square - 1 / square) / 3 - 1));
    EXPECT_NEAR(compute_growth_rate(demes, 0), rates[i], 6e-4);
    const double drive = compute_flattening_drive(demes);
    EXPECT_NEAR(drive, flat[i], 5e-4);
    EXPECT_EQ(compute_growth_rate(demes, drive + 1e-6), 0);
    EXPECT_GT(compute_growth_rate(demes, drive - 1e-6), 0);
  }
  Demes constant = make_demes(2);
  constant.permittivity = {};
  EXPECT_NEAR(compute_flattening_drive(constant), 0.433, 5e-4);
  constant.pre_stretch = 5;
  EXPECT_NEAR(compute_flattening_drive(constant), 0.937, 5e-4);
  EXPECT_EQ(compute_flattening_drive(make_demes(1.5)), 0);
}

TEST(DemesStatics, VoltageFlattensTheFrame)
{
  const Demes demes = make_demes(2);
  double last = make_rest_start(demes).angle;
  for (const double drive : {0.1, 0.2, 0.3, 0.4, 0.48})
  {
    const double angle = make_rest_start(demes, drive).angle;
    EXPECT_LT(angle, last);
    last = angle;
  }
  EXPECT_EQ(make_rest_start(demes, 0.5).angle, 0);
}

TEST(DemesStatics, ChargeReachesTheStatesOfVoltageMoreStably)
{
  Demes charge = make_demes(2);
  charge.control = DemesControl::charge;
  const Demes voltage = make_demes(2);
  const auto state = find_equilibria(voltage, 0.4).back();
  const double held = compute_electric(voltage, state.stretch, 0.4).conjugate;
  const auto same = find_equilibria(charge, held).back();
  EXPECT_NEAR(same.angle, state.angle, 1e-12);
  EXPECT_GT(same.frequencies.relaxed_squared,
            state.frequencies.relaxed_squared);
}

// lambda at rest, four decimals.
TEST(DemesStatics, EccentricityMovesTheEquilibrium)
{
  const std::vector<std::vector<double>> expected = {
      {2, 1.7824, 1.7563, 1.7327}, {5, 1.4477, 1.4519, 1.4557}};
  for (const auto& row : expected)
    for (int i = 0; i < 3; ++i)
    {
      Demes demes = make_demes(row[0]);
      demes.eccentricity = 0.01 * i;
      EXPECT_NEAR(make_rest_start(demes).inner_stretch, row[i + 1], 5e-5);
    }
}

TEST(DemesStatics, EccentricityLeavesBothBranchesWhileItIsSmall)
{
  Demes demes = make_demes(2);
  demes.eccentricity = 0.01;
  const auto states = find_equilibria(demes, 0);
  ASSERT_EQ(states.size(), 3u);
  EXPECT_TRUE(states[0].stable);
  EXPECT_FALSE(states[1].stable);
  EXPECT_TRUE(states[2].stable);
  // The film bends the frame to its own side and holds it there more firmly.
  EXPECT_LT(states[2].energy, states[0].energy);
  EXPECT_GT(states[2].angle, -states[0].angle);
  demes.eccentricity = 0.1;
  const auto one = find_equilibria(demes, 0);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_GT(one[0].angle, 0);
}

TEST(DemesStatics, NearbyPairAtAFoldIsFound)
{
  // Just before the branch of negative angles vanishes its stable and unstable
  // states lie closer than the samples of the search.
  Demes demes = make_demes(2);
  const auto count = [&](const double eccentricity)
  {
    demes.eccentricity = eccentricity;
    return find_equilibria(demes, 0).size();
  };
  double three = 0.01, one = 0.1;
  while (one - three > 1e-9)
  {
    const double middle = (one + three) / 2;
    (count(middle) == 3 ? three : one) = middle;
  }
  demes.eccentricity = three;
  const auto states = find_equilibria(demes, 0);
  EXPECT_LT(states[1].angle - states[0].angle, 1e-3);
  EXPECT_TRUE(states[0].stable);
  EXPECT_FALSE(states[1].stable);
}

TEST(DemesStatics, RefusesStraightStateOfAFrameThatHasNone)
{
  Demes demes = make_demes(2);
  demes.eccentricity = 0.01;
  EXPECT_THROW(compute_critical_pre_stretch(demes), BadInput);
  EXPECT_THROW(compute_flattening_drive(demes), BadInput);
  EXPECT_THROW(compute_growth_rate(demes, 0), BadInput);
  demes.eccentricity = 0;
  demes.rest_angle = 0.1;
  EXPECT_THROW(compute_critical_pre_stretch(demes), BadInput);
  EXPECT_THROW(find_equilibria(make_demes(-1), 0), BadInput);
}
