#include <array>

#include "automatic_differentiation.h"
#include "states.h"

namespace
{
using namespace taut::material;

Invariants<double> make_invariants(double t, double d)
{
  return {t, d, 1. / d};
}

/// The invariants as functions of the first two variables, t and l = ln d.
Invariants<Second> make_differentiable(double t, double d)
{
  const Second l = make_second(std::log(d), 1);
  return {make_second(t, 0), exp(l), exp(-l)};
}

TEST(Spring, EnergyAndStressVanishWithoutStrain)
{
  for (const Spring& spring : make_springs())
  {
    const Invariants<double> undeformed = make_invariants(2., 1.);
    // The Arruda-Boyce energy is a difference of numbers near 5e5 J/m^3.
    EXPECT_NEAR(compute_energy(spring, undeformed), 0., 1e-9);
    const EnergyDerivatives<double> W =
        compute_energy_derivatives(spring, undeformed);
    EXPECT_NEAR(W.t + W.l, 0., 1e-11) << spring.index();
  }
}

// Small simple shear c: I1 = I2 = 3 + c^2, W = G c^2/2.
TEST(Spring, ShearModulusIsTheSmallStrainStiffness)
{
  for (const Spring& spring : make_springs())
  {
    const auto stiffness = [&spring](double shear)
    {
      return 2. *
             compute_energy(spring, make_invariants(2. + shear * shear, 1.)) /
             (shear * shear);
    };
    // Of fourth order after one extrapolation.
    const double modulus = (4. * stiffness(.01) - stiffness(.02)) / 3.;
    EXPECT_NEAR(modulus / shear_modulus(spring), 1., 1e-6) << spring.index();
  }
}

TEST(Spring, DerivativesAgreeWithAutomaticOnes)
{
  for (const Spring& spring : make_springs())
    for (const auto& [t, d] :
         {std::pair<double, double>{2.1, .9}, {4., 1.4}, {9., .8}, {3., 2.}})
    {
      const EnergyDerivatives<double> W =
          compute_energy_derivatives(spring, make_invariants(t, d));
      const Second energy = compute_energy(spring, make_differentiable(t, d));
      const double tolerance = 1e-10 * shear_modulus(spring);
      EXPECT_NEAR(W.t, energy.dx(0).val(), tolerance) << spring.index();
      EXPECT_NEAR(W.l, energy.dx(1).val(), tolerance) << spring.index();
      EXPECT_NEAR(W.tt, energy.dx(0).dx(0), tolerance) << spring.index();
      EXPECT_NEAR(W.tl, energy.dx(0).dx(1), tolerance) << spring.index();
      EXPECT_NEAR(W.ll, energy.dx(1).dx(1), tolerance) << spring.index();
    }
}

// A quadratic energy of both invariants, which no spring has, exercises all
// five derivatives of the chain rule.
TEST(Spring, ChainRuleOfBothInvariantsAgreesWithAutomaticOne)
{
  const Invariants<double> x = make_invariants(4., 1.4);
  const double first = x.first(), second = x.second();
  const EnergyDerivatives<double> W = compute_energy_derivatives(
      InvariantDerivatives<double>{first * second, .5 * first * first + second,
                                   second, first, 1.},
      x);
  const Invariants<Second> y = make_differentiable(4., 1.4);
  const Second I1 = y.first(), I2 = y.second();
  const Second energy = .5 * I1 * I1 * I2 + .5 * I2 * I2;
  EXPECT_NEAR(W.t, energy.dx(0).val(), 1e-12);
  EXPECT_NEAR(W.l, energy.dx(1).val(), 1e-12);
  EXPECT_NEAR(W.tt, energy.dx(0).dx(0), 1e-12);
  EXPECT_NEAR(W.tl, energy.dx(0).dx(1), 1e-12);
  EXPECT_NEAR(W.ll, energy.dx(1).dx(1), 1e-12);
}

TEST(Spring, OnlyGentAndArrudaBoyceHaveALimit)
{
  EXPECT_EQ(first_invariant_limit(Spring(Gent{1., 60.})), 63.);
  EXPECT_EQ(first_invariant_limit(Spring(ArrudaBoyce{1., 5.})), 75.);
  EXPECT_TRUE(std::isinf(first_invariant_limit(Spring(NeoHookean{1.}))));
  EXPECT_TRUE(std::isinf(first_invariant_limit(Spring(Yeoh{1., 0., 0.}))));
  EXPECT_TRUE(std::isinf(first_invariant_limit(Spring(MooneyRivlin{1., 0.}))));
}

// Rounding of L(b) is amplified by the slope of its inverse, near 1 as b^2.
TEST(InverseLangevin, IsExactOverTheWholeRange)
{
  for (const double b : {.05, .3, 1., 2.5, 6., 20., 200.})
  {
    const double y = 1. / std::tanh(b) - 1. / b;
    EXPECT_NEAR(compute_inverse_langevin(y) / b, 1.,
                1e-16 * (5. * b + 20. / (b * b)) + 1e-15)
        << b;
  }
}

TEST(ArrudaBoyce, LongChainsAreNeoHookean)
{
  // The first correction is 3/(5 N) (I1/3 - 1) relative to the modulus.
  const Spring chains = ArrudaBoyce{2e4, 50.};
  const Spring neo_hookean = NeoHookean{2e4};
  const Invariants<double> x = make_invariants(4., 1.4);
  EXPECT_NEAR(compute_energy_derivatives(chains, x).t /
                  compute_energy_derivatives(neo_hookean, x).t,
              1. + .2 * x.first() / 2500., 1e-6);
}
} // namespace
