#include "automatic_differentiation.h"
#include "states.h"

namespace
{
using namespace taut::material;

Elastomer make_dielectric(const PermittivityLaw& law)
{
  return {{}, {}, {law}, 0.};
}

double compute_permittivity(const PermittivityLaw& law, const Tensor& C,
                            double temperature)
{
  return compute_relative_permittivity(law, compute_invariants(C), temperature);
}

// 2.1 + 960/299.
TEST(Dielectric, UnstretchedPermittivityAtRoomTemperature)
{
  EXPECT_NEAR(compute_permittivity(StretchPermittivity{},
                                   make_identity<double>(), 299.),
              5.310702, 5e-7);
}

TEST(Dielectric, PermittivityDependsOnTheSumOfThePrincipalStretches)
{
  const double x = 1.8 + 1.3 - 2.;
  const double expected =
      (2.1 + 960. / 320.) *
      (1. - .1658 * x + .04086 * x * x - .00302754 * x * x * x);
  EXPECT_NEAR(compute_permittivity(StretchPermittivity{},
                                   make_turned(1.8, 1.3, .6), 320.),
              expected, 1e-13);
}

// S = -eps E0^2 det C C^-1: a true stress of -eps E^2 in the plane.
TEST(Dielectric, MaxwellStressOfAConstantPermittivity)
{
  const Field field = make_strong_field();
  for (const State& state : make_states(0))
  {
    const Tensor C = state.C;
    const double pressure = 4.7 * vacuum_permittivity * field.nominal_squared;
    expect_near(
        stress(make_dielectric(ConstantPermittivity{4.7}), C, nullptr, field),
        {-pressure * C.yy, -pressure * C.xx, pressure * C.xy},
        1e-12 * pressure * C.xx);
  }
}

// The additional term -(1/2) eps_0 E0^2 det C eps_r'(tr U) U^-1 in principal
// axes.
TEST(Dielectric, StretchDependenceAddsItsStress)
{
  const StretchPermittivity law;
  const Field field = make_strong_field();
  const double a = 1.8, b = 1.3, x = a + b - 2.;
  const Tensor C = {a * a, b * b, 0.};
  const double scale = 2.1 + 960. / field.temperature;
  const double slope =
      scale * (law.linear + 2. * law.quadratic * x + 3. * law.cubic * x * x);
  const double maxwell = compute_permittivity(law, C, field.temperature);
  const double factor =
      -vacuum_permittivity * field.nominal_squared * a * a * b * b;
  const Tensor S = stress(make_dielectric(law), C, nullptr, field);
  EXPECT_NEAR(S.xx / (factor * (maxwell / (a * a) + .5 * slope / a)), 1.,
              1e-13);
  EXPECT_NEAR(S.yy / (factor * (maxwell / (b * b) + .5 * slope / b)), 1.,
              1e-13);
  EXPECT_NEAR(S.xy, 0., 1e-12 * std::abs(S.xx));
}

// Central differences with a step of 1e-5 have errors near 1e-9.
TEST(Dielectric, StressIsTheDifferenceOfTheEnergy)
{
  const Elastomer dielectric = make_dielectric(StretchPermittivity{});
  const Field field = make_strong_field();
  const double h = 1e-5;
  for (const State& state : make_states(0))
  {
    const auto difference = [&](const Tensor& direction)
    {
      return (energy(dielectric, add_scaled(state.C, h, direction), nullptr,
                     field) -
              energy(dielectric, add_scaled(state.C, -h, direction), nullptr,
                     field)) /
             (2. * h);
    };
    const Tensor S = stress(dielectric, state.C, nullptr, field);
    expect_near(S,
                {2. * difference({1., 0., 0.}), 2. * difference({0., 1., 0.}),
                 difference({0., 0., 1.})},
                1e-7 * (std::abs(S.xx) + std::abs(S.yy)));
  }
}

TEST(Dielectric, DerivativesAgreeWithAutomaticOnes)
{
  const Dielectric dielectric = {StretchPermittivity{}};
  const Field field = make_strong_field();
  const double t = 4., d = 1.4;
  const EnergyDerivatives<double> W = compute_energy_derivatives(
      dielectric, Invariants<double>{t, d, 1. / d}, field);
  const Second l = make_second(std::log(d), 1);
  const Second energy = compute_energy(
      dielectric, Invariants<Second>{make_second(t, 0), exp(l), exp(-l)},
      field);
  const double tolerance = 1e-13 * std::abs(energy.val().val());
  EXPECT_NEAR(W.t, energy.dx(0).val(), tolerance);
  EXPECT_NEAR(W.l, energy.dx(1).val(), tolerance);
  EXPECT_NEAR(W.tt, energy.dx(0).dx(0), tolerance);
  EXPECT_NEAR(W.tl, energy.dx(0).dx(1), tolerance);
  EXPECT_NEAR(W.ll, energy.dx(1).dx(1), tolerance);
}

// The energy at prescribed voltage falls by Q dV: with W = -q(V/H)/2 (V/H) the
// charge per area is -dW/d(V/H) = -2 W/(V/H).
TEST(Dielectric, ChargeIsTheDerivativeOfTheEnergyByTheVoltage)
{
  const Elastomer dielectric = make_dielectric(StretchPermittivity{});
  const double nominal = 1.3e7;
  const Field field = {nominal * nominal, 310.};
  for (const State& state : make_states(0))
  {
    const double charge = charge_density(dielectric, state.C, field, nominal);
    EXPECT_NEAR(charge * nominal /
                    (-2. * energy(dielectric, state.C, nullptr, field)),
                1., 1e-13);
    EXPECT_EQ(charge_density(dielectric, state.C, field, -nominal), -charge);
  }
}
} // namespace
