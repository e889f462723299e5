#include "automatic_differentiation.h"
#include "states.h"

namespace
{
using namespace taut::material;

const Field no_field = {0., 299.};

/// The rates of a single network with their derivatives by C (0..2) and A
/// (3..5).
SymmetricTensor2<First> compute_differentiable_rate(const Elastomer& elastomer,
                                                    const Tensor& C,
                                                    const Tensor& A)
{
  const SymmetricTensor2<First> internal = make_first(A, 3);
  SymmetricTensor2<First> rate;
  rates(elastomer, make_first(C, 0), &internal, &rate);
  return rate;
}

TEST(Network, ResponseSolvesTheLinearisedEvolution)
{
  const double alpha = 3.;
  const Tensor dE = {.3, -.2, .5};
  const Tensor r = {.1, .4, -.6};
  for (const Elastomer& elastomer : make_single_networks())
    for (const State& state : make_states(1))
    {
      Tensor dA;
      network_response(elastomer, state.C, state.A.data(), alpha, dE, &r, &dA);
      const SymmetricTensor2<First> rate =
          compute_differentiable_rate(elastomer, state.C, state.A[0]);
      const Tensor by_strain = multiply(to_strain(get_jacobian(rate, 0)), dE);
      const Tensor by_internal = multiply(get_jacobian(rate, 3), dA);
      const Tensor change = add_scaled(by_strain, 1., by_internal);
      expect_near({alpha * dA.xx, alpha * dA.yy, alpha * dA.xy},
                  add_scaled(change, 1., r), 1e-10);
    }
}

TEST(Network, ResponseWithoutRightHandSideIsThatOfZero)
{
  const Elastomer elastomer = make_elastomer();
  const std::size_t networks = elastomer.networks.size();
  const std::vector<Tensor> zero(networks, {0., 0., 0.});
  const State state = make_states(networks)[0];
  std::vector<Tensor> a(networks), b(networks);
  network_response(elastomer, state.C, state.A.data(), 2., {.1, .2, .3},
                   nullptr, a.data());
  network_response(elastomer, state.C, state.A.data(), 2., {.1, .2, .3},
                   zero.data(), b.data());
  for (std::size_t m = 0; m < networks; ++m)
    expect_near(a[m], b[m], 0.);
}

TEST(Network, StressChangeIsTheDerivativeByTheInternalVariable)
{
  const Tensor dA = {.3, -.2, .5};
  for (const Spring& spring : make_springs())
  {
    const Elastomer elastomer = make_single_network(spring);
    for (const State& state : make_states(1))
    {
      const SymmetricTensor2<First> A = make_first(state.A[0], 3);
      const SymmetricTensor2<First> S =
          stress(elastomer, make_first(state.C, 0), &A, no_field);
      const Matrix3<double> by_internal = get_jacobian(S, 3);
      expect_near(stress_change(elastomer, state.C, state.A.data(), &dA),
                  multiply(by_internal, dA), 1e-11 * norm(by_internal));
    }
  }
}

TEST(Network, CondensedStiffnessIsStressByStrainAndResponse)
{
  const Field field = make_strong_field();
  const Elastomer elastomer = make_elastomer();
  const std::size_t networks = elastomer.networks.size();
  const std::array<Tensor, 3> units = {
      {{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
  for (const State& state : make_states(networks))
  {
    Tensor S;
    Matrix3<double> D, fixed;
    const Tensor* A = state.A.data();
    stress_and_stiffness(elastomer, state.C, A, field, frozen, S, fixed);
    stress_and_stiffness(elastomer, state.C, A, field, 5., S, D);
    std::vector<Tensor> dA(networks);
    for (const Tensor& dE : units)
    {
      network_response(elastomer, state.C, A, 5., dE, nullptr, dA.data());
      const Tensor by_internal =
          stress_change(elastomer, state.C, A, dA.data());
      expect_near(multiply(D, dE),
                  add_scaled(multiply(fixed, dE), 1., by_internal),
                  1e-12 * norm(fixed));
    }
  }
}

/// The internal variables after an implicit Euler step to the metric C, by
/// Newton with the response of the network as its linear solver.
std::vector<Tensor> step_implicitly(const Elastomer& elastomer, const Tensor& C,
                                    const std::vector<Tensor>& start,
                                    double alpha)
{
  std::vector<Tensor> A = start, rate(A.size()), residual(A.size()),
                      dA(A.size());
  for (unsigned int iteration = 0; iteration < 12; ++iteration)
  {
    rates(elastomer, C, A.data(), rate.data());
    for (std::size_t m = 0; m < A.size(); ++m)
      residual[m] =
          add_scaled(rate[m], -alpha, add_scaled(A[m], -1., start[m]));
    network_response(elastomer, C, A.data(), alpha, {0., 0., 0.},
                     residual.data(), dA.data());
    for (std::size_t m = 0; m < A.size(); ++m)
      A[m] = add_scaled(A[m], 1., dA[m]);
  }
  return A;
}

// The whole algorithm, differenced: the stress after an implicit step as a
// function of the strain reached. Central differences with a step of 1e-5 have
// errors near 1e-9 of the stiffness.
TEST(Network, CondensedStiffnessIsTheDifferenceOfAnImplicitStep)
{
  const Field field = make_strong_field();
  const Elastomer elastomer = make_elastomer();
  const double alpha = 8., h = 1e-5;
  for (const State& state : make_states(elastomer.networks.size()))
  {
    const auto stress_after = [&](const Tensor& C)
    {
      const std::vector<Tensor> A =
          step_implicitly(elastomer, C, state.A, alpha);
      return stress(elastomer, C, A.data(), field);
    };
    const auto difference = [&](const Tensor& dC)
    {
      const Tensor forth = stress_after(add_scaled(state.C, h, dC));
      const Tensor back = stress_after(add_scaled(state.C, -h, dC));
      return combine(.5 / h, forth, -.5 / h, back);
    };
    Tensor S;
    Matrix3<double> D;
    const std::vector<Tensor> end =
        step_implicitly(elastomer, state.C, state.A, alpha);
    stress_and_stiffness(elastomer, state.C, end.data(), field, alpha, S, D);
    const double tolerance = 1e-7 * norm(D);
    expect_near(multiply(D, {1., 0., 0.}), difference({2., 0., 0.}), tolerance);
    expect_near(multiply(D, {0., 1., 0.}), difference({0., 2., 0.}), tolerance);
    expect_near(multiply(D, {0., 0., 1.}), difference({0., 0., 1.}), tolerance);
  }
}

TEST(Network, CondensedStiffnessIsSymmetricAtRestOnly)
{
  const Field field = make_strong_field();
  const Elastomer elastomer = make_elastomer();
  for (State state : make_states(elastomer.networks.size()))
  {
    Tensor S;
    Matrix3<double> D;
    stress_and_stiffness(elastomer, state.C, state.A.data(), field, 5., S, D);
    EXPECT_GT(get_asymmetry(D), 1e-5);
    for (Tensor& A : state.A)
      A = relaxed_internal(state.C);
    stress_and_stiffness(elastomer, state.C, state.A.data(), field, 5., S, D);
    EXPECT_LT(get_asymmetry(D), 1e-12);
  }
}

// alpha = 0 is an infinitely slow strain, a large alpha a sudden one.
TEST(Network, CondensedStiffnessRunsFromRelaxedToFrozen)
{
  const Field field = make_strong_field();
  const Elastomer elastomer = make_elastomer();
  for (State state : make_states(elastomer.networks.size()))
  {
    for (Tensor& A : state.A)
      A = relaxed_internal(state.C);
    Tensor S;
    Matrix3<double> slow, at_rest, sudden, fixed;
    const Tensor* A = state.A.data();
    stress_and_stiffness(elastomer, state.C, A, field, 0., S, slow);
    stress_and_stiffness(relaxed(elastomer), state.C, nullptr, field, frozen, S,
                         at_rest);
    expect_near(slow, at_rest, 1e-11 * norm(at_rest));
    // The difference falls as 1/alpha.
    stress_and_stiffness(elastomer, state.C, A, field, 1e10, S, sudden);
    stress_and_stiffness(elastomer, state.C, A, field, frozen, S, fixed);
    expect_near(sudden, fixed, 1e-8 * norm(fixed));
  }
}

// At fixed strain the energy lost is the heat of the dashpots.
TEST(Network, DissipationIsTheEnergyThatTheFlowReleases)
{
  for (const Elastomer& elastomer : make_single_networks())
    for (const State& state : make_states(1))
    {
      const SymmetricTensor2<First> A = make_first(state.A[0], 3);
      const First W = stored_energy(elastomer, make_first(state.C, 0), &A);
      Tensor rate;
      rates(elastomer, state.C, state.A.data(), &rate);
      const double released =
          -(W.dx(3) * rate.xx + W.dx(4) * rate.yy + W.dx(5) * rate.xy);
      const double heat = dissipation(elastomer, state.C, state.A.data());
      EXPECT_GT(heat, 0.);
      EXPECT_NEAR(heat / released, 1., 1e-10);
    }
}

struct GradientOfInvariants
{
  double by_1, by_2;
};

/// dW/dI1 and dW/dI2 recovered from the derivatives by t and ln d.
GradientOfInvariants recover(const EnergyDerivatives<double>& W,
                             const Invariants<double>& x)
{
  // W_t = W_1 + p W_2 and W_l = -p W_1 + (d - t p) W_2.
  const double determinant = x.d - x.t * x.p + x.p * x.p;
  return {((x.d - x.t * x.p) * W.t - x.p * W.l) / determinant,
          (W.l + x.p * W.t) / determinant};
}

// For diagonal states: dev tau_i = 2 W_1 (e_i - I1/3) - 2 W_2 (1/e_i - I2/3)
// with the three elastic squares e_i, e_3 = 1/(e_1 e_2), and every inelastic
// square c_i = 1/A_i grows as dc_i/dt = c_i dev tau_i/eta.
TEST(Network, FlowIsTheThreeDimensionalOneInPrincipalAxes)
{
  for (const Spring& spring : make_springs())
  {
    const Elastomer elastomer = make_single_network(spring);
    const double viscosity =
        shear_modulus(spring) * elastomer.networks[0].relaxation_time;
    const Tensor C = {2.3, 1.1, 0.};
    const Tensor A = {.7, .6, 0.};
    const Invariants<double> x = compute_invariants(C, A);
    const GradientOfInvariants W =
        recover(compute_energy_derivatives(spring, x), x);
    const auto deviator = [&](double e)
    {
      return 2. * W.by_1 * (e - x.first() / 3.) -
             2. * W.by_2 * (1. / e - x.second() / 3.);
    };
    const double first = deviator(C.xx * A.xx);
    const double second = deviator(C.yy * A.yy);
    const double third = deviator(1. / (C.xx * A.xx * C.yy * A.yy));
    Tensor rate;
    rates(elastomer, C, &A, &rate);
    EXPECT_NEAR(rate.xx, -A.xx * first / viscosity, 1e-12);
    EXPECT_NEAR(rate.yy, -A.yy * second / viscosity, 1e-12);
    EXPECT_EQ(rate.xy, 0.);
    // The thickness follows the same law with the component 1/det A.
    EXPECT_NEAR(rate.xx / A.xx + rate.yy / A.yy, third / viscosity, 1e-12);
    const double heat =
        (first * first + second * second + third * third) / (2. * viscosity);
    EXPECT_NEAR(dissipation(elastomer, C, &A) / heat, 1., 1e-12);
  }
}

// l_i' = l_i/(6 T) J/D (2 e_1 - e_2 - e_3), D = J + 3 - e_1 - e_2 - e_3, for
// both inelastic stretches of a Gent network.
TEST(Network, InelasticStretchesOfAGentNetworkFollowTheirEquation)
{
  const double limit = 67., time = 3.;
  const Elastomer elastomer = {{}, {{Gent{5., limit}, time}}, {}, 0.};
  const double stretches[] = {2.2, 1.4}, inelastic[] = {1.3, 1.2};
  const double e_1 = std::pow(stretches[0] / inelastic[0], 2);
  const double e_2 = std::pow(stretches[1] / inelastic[1], 2);
  const double e_3 = 1. / (e_1 * e_2);
  const double factor = limit / (limit + 3. - e_1 - e_2 - e_3) / (6. * time);
  const Tensor C = make_turned(stretches[0], stretches[1], 0.);
  const Tensor A = make_turned(1. / inelastic[0], 1. / inelastic[1], 0.);
  Tensor rate;
  rates(elastomer, C, &A, &rate);
  // d(l^-2)/dt = -2 l^-3 dl/dt.
  EXPECT_NEAR(-.5 * std::pow(inelastic[0], 3) * rate.xx,
              inelastic[0] * factor * (2. * e_1 - e_2 - e_3), 1e-13);
  EXPECT_NEAR(-.5 * std::pow(inelastic[1], 3) * rate.yy,
              inelastic[1] * factor * (2. * e_2 - e_1 - e_3), 1e-13);
}

TEST(Network, SmallShearRelaxesAtItsRelaxationTime)
{
  const double shear = 1e-6;
  const Tensor C = {1., 1., shear};
  const Tensor A = make_identity<double>();
  for (const Spring& spring : make_springs())
  {
    const Elastomer elastomer = {{}, {{spring, 4.}}, {}, 0.};
    Tensor rate;
    rates(elastomer, C, &A, &rate);
    // Of second order in the shear.
    EXPECT_NEAR(rate.xy / (-shear / 4.), 1., 1e-9) << spring.index();
  }
}
} // namespace
