#include "automatic_differentiation.h"
#include "rheometer.h"
#include "states.h"

namespace
{
using namespace taut::material;

const Field no_field = {0., 299.};

Elastomer make_reinforced(const double modulus, const double rest_stretch)
{
  Elastomer elastomer = {{NeoHookean{2.}}, {}, {}, 0.};
  elastomer.fibres = Fibres{modulus, rest_stretch};
  return elastomer;
}

TEST(Fibres, CarryNothingInTheFramedFilm)
{
  const Elastomer with = make_reinforced(100., 3.);
  Elastomer without = with;
  without.fibres.reset();
  const Tensor C = {4., 9., .5};
  EXPECT_DOUBLE_EQ(stored_energy(with, C, nullptr),
                   stored_energy(without, C, nullptr));
  expect_near(stress(with, C, nullptr, no_field),
              stress(without, C, nullptr, no_field), 1e-14);
}

TEST(Fibres, HaveTheirModulusAcross)
{
  // One of the framed film's width more: S = (E/2)(C_yy/p^2 - 1)/p^2.
  const Elastomer with = make_reinforced(100., 3.);
  Elastomer without = with;
  without.fibres.reset();
  const double p2 = 9., C_yy = 10.;
  const Tensor C = {4., C_yy, .5};
  const Tensor S = stress(with, C, nullptr, no_field);
  const Tensor S_without = stress(without, C, nullptr, no_field);
  EXPECT_NEAR(S.yy - S_without.yy, 50. * (C_yy / p2 - 1.) / p2, 1e-13);
  EXPECT_EQ(S.xx, S_without.xx);
  EXPECT_EQ(S.xy, S_without.xy);
  // Stretched by 1 + e they answer with E e to first order.
  const double e = 1e-4;
  const Tensor stretched = {4., p2 * (1. + 2. * e), 0.};
  EXPECT_NEAR(stored_energy(with, stretched, nullptr) -
                  stored_energy(without, stretched, nullptr),
              .5 * 100. * e * e, 1e-3 * .5 * 100. * e * e);
}

TEST(Fibres, StressAndStiffnessDeriveFromTheEnergy)
{
  const Elastomer elastomer = make_reinforced(50., 1.4);
  const double weights[] = {2., 2., 1.};
  for (const State& state : make_states(0))
  {
    const Second W =
        energy(elastomer, make_second(state.C, 0), nullptr, no_field);
    Tensor S;
    Matrix3<double> D, expected;
    stress_and_stiffness(elastomer, state.C, nullptr, no_field, frozen, S, D);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        expected[i][j] = weights[i] * weights[j] * W.dx(i).dx(j);
    expect_near(D, expected, 1e-12 * norm(D));
    expect_near(S, {2. * W.dx(0).val(), 2. * W.dx(1).val(), W.dx(2).val()},
                1e-12 * norm(D));
    expect_near(S, stress(elastomer, state.C, nullptr, no_field),
                1e-13 * norm(D));
  }
}

// Without force across, stiff fibres hold the width up to its force over their
// modulus: the error falls as 1/E.
TEST(Fibres, StiffOnesHoldTheWidth)
{
  const double stretch = 2., modulus = 2.;
  const double held = modulus * (stretch - std::pow(stretch, -3));
  const auto compute_error = [&](const double fibre_modulus)
  {
    const Specimen specimen = {make_reinforced(fibre_modulus, 1.),
                               Shape::uniaxial};
    return compute_answer(specimen, {}, stretch, no_field).stress - held;
  };
  for (const double ratio : {1e2, 1e3, 1e4})
    EXPECT_LT(std::abs(compute_error(ratio * modulus)), held / ratio);
  EXPECT_NEAR(compute_error(1e3 * modulus) / compute_error(1e4 * modulus), 10.,
              .1);
}
} // namespace
