// Homogeneous problems with known answers, run on the virtual rheometer. The
// numbers were derived with independent programs from the equations written in
// each test; unless said otherwise they are given to 1e-10.
#include <gtest/gtest.h>

#include "rheometer.h"

namespace
{
using namespace taut::material;

constexpr double permittivity = 4.7;

Specimen make_specimen(const Spring& spring, Shape shape, double width = 1.)
{
  const Dielectric dielectric = {ConstantPermittivity{permittivity}};
  return {{{spring}, {}, dielectric, 960.}, shape, width};
}

/// (V/H)^2 from its dimensionless form e = eps (V/H)^2/mu.
Field make_dimensionless_field(double e, double modulus)
{
  return make_field(e * modulus / (vacuum_permittivity * permittivity));
}

/// e at which an elastic specimen of modulus 1 carries `stress` at `stretch`
/// (the stress is affine in e).
double find_field(const Specimen& specimen, double stretch, double stress)
{
  const auto at = [&](double e)
  {
    return compute_answer(specimen, {}, stretch,
                          make_dimensionless_field(e, 1.))
        .stress;
  };
  return (at(0.) - stress) / (at(0.) - at(1.));
}

/// Where the tangent vanishes on the path of constant stress.
double find_extremum(const Specimen& specimen, double stress, double low,
                     double high)
{
  const auto tangent = [&](double stretch)
  {
    const double e = find_field(specimen, stretch, stress);
    return compute_answer(specimen, {}, stretch,
                          make_dimensionless_field(e, 1.))
        .tangent;
  };
  return find_root(tangent, low, high);
}

double find_square_root_field(const Specimen& specimen, double stretch,
                              double stress)
{
  return std::sqrt(find_field(specimen, stretch, stress));
}

TEST(Equibiaxial, NeoHookeanPullsInAtTheMaximumOfTheField)
{
  const Specimen specimen = make_specimen(NeoHookean{1.}, Shape::equibiaxial);
  const double stretch = find_extremum(specimen, 0., 1.05, 1.6);
  EXPECT_NEAR(stretch, std::pow(4., 1. / 6.), 1e-10);
  EXPECT_NEAR(find_square_root_field(specimen, stretch, 0.), .6873648185,
              1e-10);
}

TEST(Equibiaxial, NeoHookeanUnderDeadLoad)
{
  const Specimen specimen = make_specimen(NeoHookean{1.}, Shape::equibiaxial);
  EXPECT_NEAR(find_stretch(specimen, {}, 1., make_field(0.), 1., 2.),
              1.2851990332, 1e-10);
  const double stretch = find_extremum(specimen, 1., 1.3, 2.5);
  // The root of d(l^-2 - l^-8 - l^-3)/dl = 0.
  EXPECT_NEAR(3. * std::pow(stretch, 5) - 2. * std::pow(stretch, 6) + 8., 0.,
              1e-10);
  EXPECT_NEAR(stretch, 1.7463004355, 1e-10);
  EXPECT_NEAR(find_square_root_field(specimen, stretch, 1.), .3585747898,
              1e-10);
}

// e = (l^-2 - l^-8)/(1 - (2 l^2 + l^-4 - 3)/J), J = 100; numbers to 1e-8.
TEST(Equibiaxial, GentSnapsFromItsPeakToAStretchBeyondItsValley)
{
  const Specimen specimen = make_specimen(Gent{1., 100.}, Shape::equibiaxial);
  const double peak = find_extremum(specimen, 0., 1.05, 1.6);
  EXPECT_NEAR(peak, 1.26380444, 1e-8);
  const double peak_field = find_field(specimen, peak, 0.);
  EXPECT_NEAR(std::sqrt(peak_field), .68936322, 1e-8);
  const double valley = find_extremum(specimen, 0., 2., 7.);
  EXPECT_NEAR(valley, 5.07425996, 1e-8);
  EXPECT_NEAR(find_square_root_field(specimen, valley, 0.), .27460055, 1e-8);
  const Field held = make_dimensionless_field(peak_field, 1.);
  EXPECT_NEAR(find_stretch(specimen, {}, 0., held, valley, 7.1), 7.02628063,
              1e-8);
}

// e = w^-2 - w^-4 l^-4 - s/(l w^2).
TEST(PureShear, FieldFollowsTheClosedForm)
{
  for (const double width : {1., 1.7, 3.})
    for (const double stretch : {1.1, 2., 4.})
      for (const double stress : {0., .7})
      {
        const Specimen specimen =
            make_specimen(NeoHookean{1.}, Shape::pure_shear, width);
        const double expected = std::pow(width, -2) -
                                std::pow(width * stretch, -4) -
                                stress / (stretch * width * width);
        EXPECT_NEAR(find_field(specimen, stretch, stress), expected, 1e-12);
      }
}

TEST(PureShear, TensionAcrossIsLostWhereTheStretchReachesTheWidth)
{
  for (const auto& [width, field] :
       {std::pair<double, double>{2., .49607837}, {3., .33310463}})
  {
    const Specimen specimen =
        make_specimen(NeoHookean{1.}, Shape::pure_shear, width);
    const auto across = [&specimen](double stretch)
    {
      const double e = find_field(specimen, stretch, 0.);
      return compute_answer(specimen, {}, stretch,
                            make_dimensionless_field(e, 1.))
          .stress_across;
    };
    const double lost = find_root(across, .6 * width, 1.5 * width);
    EXPECT_NEAR(lost, width, 1e-10);
    EXPECT_NEAR(find_square_root_field(specimen, lost, 0.), field, 1e-8);
  }
}

TEST(PureShear, WithoutLoadThereIsNoPullIn)
{
  const Specimen specimen =
      make_specimen(NeoHookean{1.}, Shape::pure_shear, 2.);
  for (double stretch = 1. / std::sqrt(2.); stretch < 8.; stretch *= 1.2)
  {
    const double e = find_field(specimen, stretch, 0.);
    EXPECT_GT(
        compute_answer(specimen, {}, stretch, make_dimensionless_field(e, 1.))
            .tangent,
        0.);
  }
}

// One branch alone, G = T = 1, stretched to 2 at once: t, l_i, nominal stress
// of l_i'/l_i = dev(l_e^2)/2.
TEST(StepRelaxation, SingleBranchFollowsTheReference)
{
  const Specimen specimen = {{{}, {{NeoHookean{1.}, 1.}}, Dielectric{}, 0.},
                             Shape::uniaxial};
  const Rheometer rheometer(specimen, {[](double) { return 2.; }, {}, {}});
  const std::vector<Reading> readings = rheometer.run({.1, 1., 5.});
  const double inelastic[] = {1.1078746401, 1.6514959692, 1.9936532174};
  const double stress[] = {1.3525102852, .3204146520, .0047752567};
  for (unsigned int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(1. / std::sqrt(readings[i].internal[0].xx), inelastic[i],
                2e-10);
    EXPECT_NEAR(readings[i].stress, stress[i], 2e-10);
  }
}

// Neo-Hookean Zener solid, T = 1, total modulus 1 of which `share` is elastic.
Specimen make_zener(double share)
{
  const Dielectric dielectric = {ConstantPermittivity{permittivity}};
  return {{{NeoHookean{share}}, {{NeoHookean{1. - share}, 1.}}, dielectric, 0.},
          Shape::equibiaxial};
}

TEST(Creep, EndsInPullInAtTheReferenceTimes)
{
  const Specimen zener = make_zener(.5);
  for (const auto& [square_root, time] :
       {std::pair<double, double>{.5, 16.03808464},
        {.6, 1.48996387},
        {.65, .42371682}})
  {
    const Field field = make_dimensionless_field(square_root * square_root, 1.);
    EXPECT_NEAR(find_pull_in_time(zener, 0., field, 1.2599), time, 1e-8)
        << "Et = " << square_root;
  }
}

TEST(Creep, OfAStifferSolidReachesItsRelaxedState)
{
  const double held = make_dimensionless_field(.25, 1.).nominal_squared;
  const Rheometer rheometer(
      make_zener(.8),
      {{}, [](double) { return 0.; }, [=](double) { return held; }});
  const double last = rheometer.run({400.}).back().stretch;
  Specimen at_rest = make_zener(.8);
  at_rest.elastomer = relaxed(at_rest.elastomer);
  const double limit = find_stretch(at_rest, {}, 0., make_field(held), 1., 1.2);
  EXPECT_NEAR(limit, 1.07812829, 1e-8);
  EXPECT_NEAR(last, limit, 1e-9);
}

// VHB 4910 of Wang, Decker, Henann, Chester (2016). The modulus of the
// Arruda-Boyce spring is that of long chains; taken as the small-strain modulus
// (1.7 percent apart) it misses these numbers by more than 0.1 kPa. They are
// given to 1e-6 kPa.
TEST(Vhb4910, LoadAndUnloadAtOnePercentPerSecond)
{
  const Elastomer vhb = {{ArrudaBoyce{15.36e3, 5.99}},
                         {{NeoHookean{26.06e3}, .6074},
                          {NeoHookean{26.53e3}, 6.56},
                          {NeoHookean{10.83e3}, 61.25}},
                         {ConstantPermittivity{4.8}},
                         960.};
  const Program program = {
      [](double t) { return t < 150. ? 1. + .01 * t : 2.5 - .01 * (t - 150.); },
      {},
      {}};
  const Rheometer rheometer({vhb, Shape::uniaxial}, program);
  const std::vector<Reading> readings =
      rheometer.run({56.25, 150., 150. + 93.75});
  EXPECT_NEAR(readings[0].stress, 27.016852e3, 1e-3);
  EXPECT_NEAR(readings[1].stress, 42.121060e3, 1e-3);
  EXPECT_NEAR(readings[2].stress, 11.890059e3, 1e-3);
}
} // namespace
