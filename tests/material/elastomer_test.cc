#include <taut/material/limits.h>

#include "automatic_differentiation.h"
#include "states.h"

namespace
{
using namespace taut::material;

SymmetricTensor2<Second> make_constant(const Tensor& a)
{
  return {Second(a.xx), Second(a.yy), Second(a.xy)};
}

/// The energy of an elastomer as a function of C, its networks frozen.
Second compute_differentiable_energy(const Elastomer& elastomer,
                                     const State& state, const Field& field)
{
  std::vector<SymmetricTensor2<Second>> A;
  for (const Tensor& internal : state.A)
    A.push_back(make_constant(internal));
  return energy(elastomer, make_second(state.C, 0), A.data(), field);
}

TEST(Elastomer, UndeformedAndWithoutVoltageNothingActs)
{
  const Elastomer elastomer = make_elastomer();
  const State virgin = make_virgin_state(elastomer.networks.size());
  const Field off = {0., 299.};
  EXPECT_NEAR(energy(elastomer, virgin.C, virgin.A.data(), off), 0., 1e-8);
  expect_near(stress(elastomer, virgin.C, virgin.A.data(), off), {0., 0., 0.},
              1e-10);
  EXPECT_NEAR(dissipation(elastomer, virgin.C, virgin.A.data()), 0., 1e-12);
  EXPECT_DOUBLE_EQ(limit_margin(elastomer, virgin.C, virgin.A.data()), 1.);
}

// Incompressible plane stress: E = 4 G, Poisson ratio 1/2, shear modulus G.
TEST(Elastomer, UndeformedStiffnessIsThatOfTheSmallStrainModuli)
{
  const Elastomer elastomer = make_elastomer();
  double elastic = 0., viscous = 0.;
  for (const Spring& spring : elastomer.springs)
    elastic += shear_modulus(spring);
  for (const Network& network : elastomer.networks)
    viscous += shear_modulus(network.spring);
  const State virgin = make_virgin_state(elastomer.networks.size());
  for (const auto& [alpha, modulus] :
       {std::pair<double, double>{frozen, elastic + viscous}, {0., elastic}})
  {
    Tensor S;
    Matrix3<double> D;
    stress_and_stiffness(elastomer, virgin.C, virgin.A.data(), {0., 299.},
                         alpha, S, D);
    expect_near(D,
                {{{{4. * modulus, 2. * modulus, 0.}},
                  {{2. * modulus, 4. * modulus, 0.}},
                  {{0., 0., modulus}}}},
                1e-10 * modulus);
  }
}

TEST(Elastomer, TurningTheAxesTurnsTheAnswer)
{
  const Elastomer elastomer = make_elastomer();
  const std::size_t networks = elastomer.networks.size();
  const Field field = make_strong_field();
  for (const State& state : make_states(networks))
  {
    State turned = {rotate(state.C, .7), {}};
    for (const Tensor& A : state.A)
      turned.A.push_back(rotate(A, .7));
    const double W = energy(elastomer, state.C, state.A.data(), field);
    EXPECT_NEAR(energy(elastomer, turned.C, turned.A.data(), field), W,
                1e-12 * std::abs(W) + 1e-8);
    expect_near(stress(elastomer, turned.C, turned.A.data(), field),
                rotate(stress(elastomer, state.C, state.A.data(), field), .7),
                1e-8);
    std::vector<Tensor> rate(networks), turned_rate(networks);
    rates(elastomer, state.C, state.A.data(), rate.data());
    rates(elastomer, turned.C, turned.A.data(), turned_rate.data());
    for (std::size_t m = 0; m < networks; ++m)
      expect_near(turned_rate[m], rotate(rate[m], .7), 1e-12);
  }
}

TEST(Elastomer, StressIsTheDerivativeOfTheEnergy)
{
  const Elastomer elastomer = make_elastomer();
  const Field field = make_strong_field();
  for (const State& state : make_states(elastomer.networks.size()))
  {
    const Tensor S = stress(elastomer, state.C, state.A.data(), field);
    const Second W = compute_differentiable_energy(elastomer, state, field);
    expect_near(S, {2. * W.dx(0).val(), 2. * W.dx(1).val(), W.dx(2).val()},
                1e-10 * norm(Matrix3<double>{{{{S.xx, S.yy, S.xy}}, {}, {}}}) +
                    1e-7);
  }
}

// Central differences with a step of 1e-5: truncation and rounding near 1e-9 of
// energies and moduli of 1e5 Pa.
TEST(Elastomer, StressIsTheDifferenceOfTheEnergy)
{
  const Elastomer elastomer = make_elastomer();
  const Field field = make_strong_field();
  const double h = 1e-5;
  for (const State& state : make_states(elastomer.networks.size()))
  {
    const auto difference = [&](const Tensor& direction)
    {
      const Tensor forth = add_scaled(state.C, h, direction);
      const Tensor back = add_scaled(state.C, -h, direction);
      return (energy(elastomer, forth, state.A.data(), field) -
              energy(elastomer, back, state.A.data(), field)) /
             (2. * h);
    };
    expect_near(stress(elastomer, state.C, state.A.data(), field),
                {2. * difference({1., 0., 0.}), 2. * difference({0., 1., 0.}),
                 difference({0., 0., 1.})},
                1e-2);
  }
}

void expect_stiffness_of_the_energy(const Elastomer& elastomer,
                                    const Field& field)
{
  // S_xx = 2 dW/dC_xx and S_xy = dW/dC_xy, see tensors.h; likewise for strains.
  const double weights[] = {2., 2., 1.};
  for (const State& state : make_states(elastomer.networks.size()))
  {
    Tensor S;
    Matrix3<double> D, expected;
    stress_and_stiffness(elastomer, state.C, state.A.data(), field, frozen, S,
                         D);
    expect_near(S, stress(elastomer, state.C, state.A.data(), field),
                1e-12 * norm(D));
    const Second W = compute_differentiable_energy(elastomer, state, field);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        expected[i][j] = weights[i] * weights[j] * W.dx(i).dx(j);
    expect_near(D, expected, 1e-11 * norm(D));
    EXPECT_LT(get_asymmetry(D), 1e-12);
  }
}

TEST(Elastomer, FrozenStiffnessOfEverySpringIsTheSecondDerivative)
{
  for (const Spring& spring : make_springs())
  {
    SCOPED_TRACE(spring.index());
    expect_stiffness_of_the_energy({{spring}, {}, {}, 0.}, {0., 299.});
    expect_stiffness_of_the_energy(make_single_network(spring), {0., 299.});
  }
}

TEST(Elastomer, FrozenStiffnessOfTheWholeIsTheSecondDerivative)
{
  expect_stiffness_of_the_energy(make_elastomer(), make_strong_field());
}

TEST(Elastomer, RelaxedStateCarriesTheSpringsAlone)
{
  const Elastomer elastomer = make_elastomer();
  const Elastomer at_rest = relaxed(elastomer);
  const Field field = make_strong_field();
  for (State state : make_states(elastomer.networks.size()))
  {
    for (Tensor& A : state.A)
      A = relaxed_internal(state.C);
    expect_near(stress(elastomer, state.C, state.A.data(), field),
                stress(at_rest, state.C, nullptr, field), 1e-9);
    std::vector<Tensor> rate(state.A.size());
    rates(elastomer, state.C, state.A.data(), rate.data());
    for (const Tensor& A_rate : rate)
      expect_near(A_rate, {0., 0., 0.}, 1e-12);
  }
}

TEST(Elastomer, LimitMarginIsThatOfTheSpringClosestToItsLimit)
{
  const Elastomer elastomer = {
      {Gent{1., 10.}, NeoHookean{1.}}, {{ArrudaBoyce{1., 2.}, 1.}}, {}, 0.};
  // I1 = 4 + 1 + 1/4 of at most 13 for the Gent spring; for the network, of at
  // most 12, 3 at rest and 12 + 1/4 + 1/3 where it is stretched too far.
  const Tensor C = {4., 1., 0.};
  const Tensor at_rest = {.25, 1., 0.};
  EXPECT_NEAR(limit_margin(elastomer, C, &at_rest), 7.75 / 10., 1e-14);
  const Tensor stretched = {3., .25, 0.};
  EXPECT_NEAR(limit_margin(elastomer, C, &stretched), (-.25 - 1. / 3.) / 9.,
              1e-14);
  EXPECT_TRUE(
      std::isinf(limit_margin({{NeoHookean{1.}}, {}, {}, 0.}, C, nullptr)));
  const Tensor lost = {std::nan(""), .25, 0.};
  EXPECT_TRUE(std::isnan(limit_margin(elastomer, C, &lost)));
  // Numbers of automatic differentiation count by their value.
  const SymmetricTensor2<Second> differentiable = make_second(C, 0);
  EXPECT_DOUBLE_EQ(limit_margin(relaxed(elastomer), differentiable, nullptr),
                   1. - 2.25 / 10.);
}
} // namespace
