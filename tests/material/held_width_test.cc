#include "automatic_differentiation.h"
#include "rheometer.h"
#include "states.h"

namespace
{
using namespace taut::material;

const Field no_field = {0., 299.};

Elastomer make_held(const Spring& spring)
{
  return {{}, {{spring, .7, FlowLaw::held_width}}, {}, 0.};
}

/// States as of any film, with internal variables that only flowed along the
/// first axis.
std::vector<State> make_held_states()
{
  std::vector<State> states = make_states(1);
  for (State& state : states)
    state.A[0] = {state.A[0].xx, 1., 0.};
  return states;
}

/// The rates with their derivatives by C (0..2) and A (3..5).
SymmetricTensor2<First> compute_differentiable_rate(const Elastomer& elastomer,
                                                    const State& state)
{
  const SymmetricTensor2<First> internal = make_first(state.A[0], 3);
  SymmetricTensor2<First> rate;
  rates(elastomer, make_first(state.C, 0), &internal, &rate);
  return rate;
}

TEST(HeldWidth, OnlyTheFirstAxisFlows)
{
  const Elastomer elastomer = make_held(NeoHookean{2.});
  for (const State& state : make_held_states())
  {
    Tensor rate;
    rates(elastomer, state.C, state.A.data(), &rate);
    EXPECT_NE(rate.xx, 0.);
    EXPECT_EQ(rate.yy, 0.);
    EXPECT_EQ(rate.xy, 0.);
  }
}

TEST(HeldWidth, RateIsThatOfTheDashpotAlongTheAxis)
{
  // eta dxi/dt = G (l^2 xi^-3 - l^-2 xi), eta = G T, A = 1/xi^2.
  const double l = 1.7, xi = 1.3, time = .7;
  const Elastomer elastomer = make_held(NeoHookean{5.});
  const Tensor C = {l * l, 1., 0.}, A = {1. / (xi * xi), 1., 0.};
  Tensor rate;
  rates(elastomer, C, &A, &rate);
  const double xi_rate = (l * l / (xi * xi * xi) - xi / (l * l)) / time;
  EXPECT_NEAR(rate.xx, -2. * xi_rate / (xi * xi * xi), 1e-14);
  // The dashpot takes eta xi'^2.
  EXPECT_NEAR(dissipation(elastomer, C, &A), 5. * time * xi_rate * xi_rate,
              1e-13);
}

TEST(HeldWidth, ResponseSolvesTheLinearisedEvolution)
{
  const double alpha = 3.;
  const Tensor dE = {.3, -.2, .5};
  const Tensor r = {.1, .4, -.6};
  for (const Spring& spring : make_springs())
  {
    const Elastomer elastomer = make_held(spring);
    for (const State& state : make_held_states())
    {
      Tensor dA;
      network_response(elastomer, state.C, state.A.data(), alpha, dE, &r, &dA);
      const SymmetricTensor2<First> rate =
          compute_differentiable_rate(elastomer, state);
      const Tensor by_strain = multiply(to_strain(get_jacobian(rate, 0)), dE);
      const Tensor by_internal = multiply(get_jacobian(rate, 3), dA);
      const Tensor change = add_scaled(by_strain, 1., by_internal);
      expect_near({alpha * dA.xx, alpha * dA.yy, alpha * dA.xy},
                  add_scaled(change, 1., r), 1e-10);
    }
  }
}

/// The derivative of stress by strain with the network's answer, from AD.
Matrix3<double> compute_condensed(const Elastomer& elastomer,
                                  const State& state, const double alpha)
{
  const SymmetricTensor2<First> A = make_first(state.A[0], 3);
  const SymmetricTensor2<First> S =
      stress(elastomer, make_first(state.C, 0), &A, no_field);
  const SymmetricTensor2<First> rate =
      compute_differentiable_rate(elastomer, state);
  Matrix3<double> D = to_strain(get_jacobian(S, 0));
  const Matrix3<double> by_internal = get_jacobian(S, 3);
  const Matrix3<double> rate_by_strain = to_strain(get_jacobian(rate, 0));
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      D[i][j] +=
          by_internal[i][0] * rate_by_strain[0][j] / (alpha - rate.xx.dx(3));
  return D;
}

TEST(HeldWidth, CondensedStiffnessIsExactAndSymmetric)
{
  for (const Spring& spring : make_springs())
  {
    const Elastomer elastomer = make_held(spring);
    for (const State& state : make_held_states())
    {
      Tensor S;
      Matrix3<double> D;
      stress_and_stiffness(elastomer, state.C, state.A.data(), no_field, 5., S,
                           D);
      expect_near(D, compute_condensed(elastomer, state, 5.), 1e-11 * norm(D));
      EXPECT_LT(get_asymmetry(D), 1e-13);
      expect_near(S, stress(elastomer, state.C, state.A.data(), no_field),
                  1e-12 * norm(D));
    }
  }
}

/// A_xx after an implicit Euler step from `start`, by Newton.
Tensor step_implicitly(const Elastomer& elastomer, const Tensor& C,
                       const Tensor& start, const double alpha)
{
  Tensor A = start, rate, dA;
  for (unsigned int iteration = 0; iteration < 12; ++iteration)
  {
    rates(elastomer, C, &A, &rate);
    const Tensor residual = add_scaled(rate, -alpha, add_scaled(A, -1., start));
    network_response(elastomer, C, &A, alpha, {0., 0., 0.}, &residual, &dA);
    A = add_scaled(A, 1., dA);
  }
  return A;
}

// Central differences with a step of 1e-5: errors near 1e-9 of the stiffness.
TEST(HeldWidth, CondensedStiffnessIsTheDifferenceOfAnImplicitStep)
{
  const double alpha = 8., h = 1e-5;
  for (const Spring& spring : make_springs())
  {
    const Elastomer elastomer = make_held(spring);
    for (const State& state : make_held_states())
    {
      const auto stress_after = [&](const Tensor& C)
      {
        const Tensor A = step_implicitly(elastomer, C, state.A[0], alpha);
        return stress(elastomer, C, &A, no_field);
      };
      const auto difference = [&](const Tensor& dC)
      {
        const Tensor forth = stress_after(add_scaled(state.C, h, dC));
        const Tensor back = stress_after(add_scaled(state.C, -h, dC));
        return combine(.5 / h, forth, -.5 / h, back);
      };
      const Tensor end = step_implicitly(elastomer, state.C, state.A[0], alpha);
      Tensor S;
      Matrix3<double> D;
      stress_and_stiffness(elastomer, state.C, &end, no_field, alpha, S, D);
      const double tolerance = 1e-7 * norm(D);
      expect_near(multiply(D, {1., 0., 0.}), difference({2., 0., 0.}),
                  tolerance);
      expect_near(multiply(D, {0., 1., 0.}), difference({0., 2., 0.}),
                  tolerance);
      expect_near(multiply(D, {0., 0., 1.}), difference({0., 0., 1.}),
                  tolerance);
    }
  }
}

TEST(HeldWidth, DissipationIsTheEnergyThatTheFlowReleases)
{
  for (const Spring& spring : make_springs())
  {
    const Elastomer elastomer = make_held(spring);
    for (const State& state : make_held_states())
    {
      const SymmetricTensor2<First> A = make_first(state.A[0], 3);
      const First W = stored_energy(elastomer, make_first(state.C, 0), &A);
      Tensor rate;
      rates(elastomer, state.C, state.A.data(), &rate);
      const double heat = dissipation(elastomer, state.C, state.A.data());
      EXPECT_GT(heat, 0.);
      EXPECT_NEAR(heat / (-W.dx(3) * rate.xx), 1., 1e-10);
    }
  }
}

TEST(HeldWidth, AtRestNothingFlows)
{
  for (const Spring& spring : make_springs())
  {
    const Elastomer elastomer = make_held(spring);
    for (const State& state : make_held_states())
    {
      const Tensor A = relaxed_internal(elastomer.networks[0], state.C);
      Tensor rate;
      rates(elastomer, state.C, &A, &rate);
      // Rates scale with A/T.
      EXPECT_NEAR(rate.xx, 0., 1e-12 * A.xx);
      EXPECT_EQ(A.yy, 1.);
      EXPECT_EQ(A.xy, 0.);
    }
  }
}

TEST(HeldWidth, AtRestTheAxisCarriesNothing)
{
  for (const Spring& spring : make_springs())
  {
    const Elastomer elastomer = make_held(spring);
    const Tensor C = {4., 1.3, 0.};
    const Tensor A = relaxed_internal(elastomer.networks[0], C);
    EXPECT_NEAR(stress(elastomer, C, &A, no_field).xx, 0.,
                1e-12 * shear_modulus(spring));
  }
  const Tensor A = relaxed_internal(make_held(NeoHookean{1.}).networks[0],
                                    Tensor{4., 1., 0.});
  EXPECT_DOUBLE_EQ(A.xx, .25);
}

TEST(HeldWidth, IsotropicNetworksRestAsBefore)
{
  const Network network = {NeoHookean{1.}, 1.};
  const Tensor C = {4., 2., .5};
  expect_near(relaxed_internal(network, C), relaxed_internal(C), 0.);
}

// q = xi^4 obeys the linear equation q' = (4/T) (l^2 - q/l^2).
TEST(HeldWidth, RelaxesAsTheScalarEquation)
{
  const double time = .7, l = 2.;
  const Specimen specimen = {make_held(NeoHookean{3.}), Shape::pure_shear};
  Program program;
  program.stretch = [=](double) { return l; };
  const std::vector<double> times = {.1, .5, 1., 3.};
  const auto readings = Rheometer(specimen, program).run(times);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const double decay = std::exp(-4. * times[i] / (time * l * l));
    const double xi = std::pow(l * l * l * l * (1. - decay) + decay, .25);
    EXPECT_NEAR(1. / std::sqrt(readings[i].internal[0].xx), xi, 1e-8);
    EXPECT_NEAR(readings[i].stress,
                3. * (l / (xi * xi) - xi * xi / (l * l * l)), 1e-7);
  }
}

TEST(HeldWidth, FollowsAnOscillationAsTheScalarEquation)
{
  namespace odeint = boost::numeric::odeint;
  const double time = .7;
  const auto stretch = [](double t) { return 2. + .5 * std::sin(3. * t); };
  const Specimen specimen = {make_held(NeoHookean{3.}), Shape::pure_shear};
  Program program;
  program.stretch = stretch;
  const double end = 4.;
  const auto readings = Rheometer(specimen, program).run({end});
  std::vector<double> xi = {1.};
  auto stepper = odeint::make_controlled(
      1e-12, 1e-12, odeint::runge_kutta_dopri5<std::vector<double>>());
  odeint::integrate_adaptive(
      stepper,
      [&](const std::vector<double>& y, std::vector<double>& rate, double t)
      {
        const double l2 = stretch(t) * stretch(t);
        rate = {(l2 / (y[0] * y[0] * y[0]) - y[0] / l2) / time};
      },
      xi, 0., end, 1e-6);
  EXPECT_NEAR(1. / std::sqrt(readings[0].internal[0].xx), xi[0], 1e-8);
}
} // namespace
