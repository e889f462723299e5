// Relaxation times that depend on the state of their network.
#include <taut/material/limits.h>

#include "automatic_differentiation.h"
#include "rheometer.h"
#include "states.h"
#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace
{
using namespace taut::material;

Activation<double> compute(const RelaxationLaw& law, const Spring& spring,
                           const Invariants<double>& invariants)
{
  return compute_activation(law, invariants,
                            compute_energy_derivatives(spring, invariants));
}

double round(const double x)
{
  return std::hypot(x, stress_rounding) - stress_rounding;
}

// A neo-Hookean network in uniaxial tension, e = (l^2, 1/l): tau = G (l^2 -
// 1/l) and I1 - 3 = l^2 + 2/l - 3.
TEST(RelaxationLaw, ActivationInUniaxialTension)
{
  for (const double stretch : {.6, 1.3, 2.5})
  {
    const double square = stretch * stretch;
    const Invariants<double> x =
        compute_invariants(Tensor{square, 1. / stretch, 0.});
    const NeoHookean spring = {5.};
    EXPECT_NEAR(compute(StressActivatedRelaxation{2.}, spring, x).s,
                round(5. / 2. * (square - 1. / stretch)), 1e-13);
    EXPECT_NEAR(compute(StretchActivatedRelaxation{.7}, spring, x).s,
                .7 * (square + 2. / stretch - 3.), 1e-14);
    EXPECT_EQ(compute(ConstantRelaxation{}, spring, x).s, 0.);
  }
}

// With the three principal stresses tau_i = 2 W_1 e_i - 2 W_2/e_i of a
// Mooney-Rivlin network, up to a pressure: tau_e^2 is half the sum of the
// squares of their differences.
TEST(RelaxationLaw, ActivationByThePrincipalStressesOfAPlaneState)
{
  const MooneyRivlin spring = {3., 2.};
  const double e[] = {2.2, 1.4, 1. / (2.2 * 1.4)};
  const auto tau = [&](const double square)
  { return 2. * (3. * square - 2. / square); };
  double sum = 0.;
  for (unsigned int i = 0; i < 3; ++i)
    sum += std::pow(tau(e[i]) - tau(e[(i + 1) % 3]), 2);
  const Invariants<double> x = compute_invariants(Tensor{e[0], e[1], 0.});
  EXPECT_NEAR(compute(StressActivatedRelaxation{1.}, spring, x).s,
              round(std::sqrt(sum / 2.)), 1e-12);
}

TEST(RelaxationLaw, AtRestAllAreThatOfTheConstant)
{
  const Invariants<double> x = compute_invariants(make_identity<double>());
  for (const Spring& spring : make_springs())
    for (const RelaxationLaw& law : make_relaxation_laws())
    {
      const Activation<double> activation = compute(law, spring, x);
      // The square of the stress carries the rounding of (e_1 - e_2)^2, 1e-16
      // times that of the modulus over sigma_0, 10, next to 1e-12.
      EXPECT_NEAR(activation.s, 0., 1e-8);
      EXPECT_TRUE(std::isfinite(activation.t));
      EXPECT_TRUE(std::isfinite(activation.l));
    }
}

TEST(RelaxationLaw, DerivativesAreThoseOfTheActivation)
{
  const First t = make_first(3.1, 0), l = make_first(.4, 1);
  const First d = exp(l);
  const Invariants<First> variable = {t, d, 1. / d};
  const Invariants<double> x = {3.1, std::exp(.4), std::exp(-.4)};
  for (const Spring& spring : make_springs())
    for (const RelaxationLaw& law : make_relaxation_laws())
    {
      const First s =
          compute_activation(law, variable,
                             compute_energy_derivatives(spring, variable))
              .s;
      const Activation<double> activation = compute(law, spring, x);
      EXPECT_NEAR(activation.s, s.val(), 1e-14 * (1. + s.val()));
      EXPECT_NEAR(activation.t, s.dx(0), 1e-12 * (1. + std::abs(s.dx(0))));
      EXPECT_NEAR(activation.l, s.dx(1), 1e-12 * (1. + std::abs(s.dx(1))));
    }
}

TEST(RelaxationLaw, FlowIsThatOfTheConstantTimesTheQuickness)
{
  for (const RelaxationLaw& law : make_relaxation_laws())
    for (const Spring& spring : make_springs())
      for (const State& state : make_states(1))
      {
        Elastomer elastomer = make_single_network(spring);
        Tensor slow, quick;
        rates(elastomer, state.C, state.A.data(), &slow);
        const double loss = dissipation(elastomer, state.C, state.A.data());
        elastomer.networks[0].relaxation = law;
        rates(elastomer, state.C, state.A.data(), &quick);
        const double q = std::exp(
            compute(law, spring, compute_invariants(state.C, state.A[0])).s);
        EXPECT_GE(q, 1.);
        expect_near(quick, {q * slow.xx, q * slow.yy, q * slow.xy},
                    1e-12 * q * (std::abs(slow.xx) + std::abs(slow.yy)));
        EXPECT_NEAR(dissipation(elastomer, state.C, state.A.data()) / loss, q,
                    1e-12 * q);
      }
}

// One neo-Hookean branch alone, G = T_0 = 1, stretched at once and held. With
// its elastic square e and tau = e - e^(-1/2), d(ln e)/dt = -(2/3) tau q: the
// time to come down to e is an integral over e.
TEST(RelaxationLaw, StepRelaxationFollowsTheQuadrature)
{
  const double stretch = 2.;
  const auto get_stress = [](const double e) { return e - 1. / std::sqrt(e); };
  const auto find_time = [&](const auto& compute_exponent, const double end)
  {
    const auto slowness = [&](const double e)
    { return 1.5 / (e * get_stress(e)) * std::exp(-compute_exponent(e)); };
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
        slowness, end, stretch * stretch, 15, 1e-13);
  };
  const auto expect_time =
      [&](const RelaxationLaw& law, const auto& compute_exponent)
  {
    Specimen specimen = {{{}, {{NeoHookean{1.}, 1.}}, Dielectric{}, 0.},
                         Shape::uniaxial};
    specimen.elastomer.networks[0].relaxation = law;
    const Rheometer rheometer(specimen,
                              {[=](double) { return stretch; }, {}, {}});
    for (const double e : {3.5, 2., 1.1})
    {
      const Reading reading =
          rheometer.run({find_time(compute_exponent, e)}).back();
      EXPECT_NEAR(stretch * stretch * reading.internal[0].xx, e, 1e-8);
      EXPECT_NEAR(reading.stress, get_stress(e) / stretch, 1e-8);
    }
  };
  expect_time(StressActivatedRelaxation{.9},
              [&](const double e) { return round(get_stress(e) / .9); });
  expect_time(StretchActivatedRelaxation{.6},
              [](const double e) { return .6 * (e + 2. / std::sqrt(e) - 3.); });
}

TEST(RelaxationLaw, BeyondTheLargestExponentTheStateIsInadmissible)
{
  Elastomer elastomer = make_single_network(NeoHookean{1.});
  elastomer.networks[0].relaxation = StretchActivatedRelaxation{10.};
  const Tensor A = make_identity<double>();
  const auto compute_margin = [&](const double first_invariant)
  {
    // Equibiaxial, 2 x + 1/x^2 = I1.
    const double x = find_root(
        [=](const double y) { return 2. * y + 1. / (y * y) - first_invariant; },
        1., 10.);
    const Tensor C = {x, x, 0.};
    const double margin = limit_margin(elastomer, C, &A);
    EXPECT_EQ(describe_limit(elastomer, C, &A, no_voltage).empty(),
              margin > 0.);
    return margin;
  };
  EXPECT_NEAR(compute_margin(5.5), .5, 1e-12);
  EXPECT_GT(compute_margin(7.999), 0.);
  EXPECT_LT(compute_margin(8.001), 0.);
  const Tensor C = {4., 4., 0.};
  // k (I1 - 3) = 10 (8 + 1/16 - 3).
  EXPECT_EQ(describe_limit(elastomer, C, &A, no_voltage),
            "ln(T_0/T) = 50.625 is beyond the limit 50 of the relaxation law "
            "of network 1");
}
} // namespace
