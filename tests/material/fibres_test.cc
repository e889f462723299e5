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
  elastomer.fibres = {make_fibres_across(modulus, rest_stretch)};
  return elastomer;
}

TEST(Fibres, CarryNothingInTheFramedFilm)
{
  const Elastomer with = make_reinforced(100., 3.);
  Elastomer without = with;
  without.fibres.clear();
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
  without.fibres.clear();
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

/// Families of both laws, with and without dispersion and buckling.
std::vector<Elastomer> make_films()
{
  const std::array<double, 2> oblique{{.8, .6}};
  std::vector<Elastomer> films = {make_reinforced(50., 1.4)};
  for (const FibreLaw& law :
       {FibreLaw(QuadraticFibres{5.}), FibreLaw(ExponentialFibres{2., .3})})
    for (const double dispersion : {0., .1, 1. / 3.})
      for (const bool tension_only : {true, false})
        films.push_back({{NeoHookean{2.}},
                         {},
                         {},
                         0.,
                         {{law, oblique, tension_only, dispersion}}});
  return films;
}

void expect_stiffness_of_the_energy(const Elastomer& elastomer)
{
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

TEST(Fibres, StressAndStiffnessDeriveFromTheEnergy)
{
  for (const Elastomer& elastomer : make_films())
    expect_stiffness_of_the_energy(elastomer);
}

TEST(Fibres, EnergyDoesNotDependOnTheAxes)
{
  const double angle = .7, c = std::cos(angle), s = std::sin(angle);
  for (const Elastomer& elastomer : make_films())
  {
    Elastomer turned = elastomer;
    const auto [x, y] = elastomer.fibres[0].direction;
    turned.fibres[0].direction = {{c * x - s * y, s * x + c * y}};
    for (const State& state : make_states(0))
    {
      const double W = stored_energy(elastomer, state.C, nullptr);
      EXPECT_NEAR(stored_energy(turned, rotate(state.C, angle), nullptr), W,
                  1e-12 * W);
    }
  }
}

/// The film of modulus 2 with one family.
Elastomer make_film(const FibreLaw& law, const double angle)
{
  Elastomer elastomer = {{NeoHookean{2.}}, {}, {}, 0.};
  elastomer.fibres = {{law, {{std::cos(angle), std::sin(angle)}}}};
  return elastomer;
}

constexpr double pi = 3.14159265358979323846;

// Along the fibres I4 = l^2: they add 2 l W'(I4) to l G (1 - l^-3), and leave
// the natural width as it is.
TEST(FibreFamily, UniaxialTensionAlong)
{
  const auto compute = [](const FibreLaw& law, const double stretch)
  {
    return compute_answer({make_film(law, 0.), Shape::uniaxial}, {}, stretch,
                          no_field)
        .stress;
  };
  for (const double l : {.7, 1.2, 2.})
  {
    const double springs = 2. * (l - 1. / (l * l));
    const double e = l > 1. ? l * l - 1. : 0.;
    EXPECT_NEAR(compute(QuadraticFibres{5.}, l), springs + 10. * l * e, 1e-12);
    EXPECT_NEAR(compute(ExponentialFibres{5., .3}, l) /
                    (springs + 10. * l * e * std::exp(.3 * e * e)),
                1., 1e-13);
  }
}

TEST(FibreFamily, UniaxialTensionAcrossFibresThatBuckleIsThatOfTheSprings)
{
  const Specimen specimen = {make_film(QuadraticFibres{5.}, pi / 2.),
                             Shape::uniaxial};
  for (const double l : {1.2, 2.})
    EXPECT_NEAR(compute_answer(specimen, {}, l, no_field).stress,
                2. * (l - 1. / (l * l)), 1e-12);
}

// Fibres that do not buckle hold the width w off: G (1 - w^-4 l^-2) + 2 k1
// (w^2 - 1) = 0.
TEST(FibreFamily, UniaxialTensionAcrossFibresThatDoNotBuckle)
{
  Specimen specimen = {make_film(QuadraticFibres{5.}, pi / 2.),
                       Shape::uniaxial};
  specimen.elastomer.fibres[0].tension_only = false;
  const double l = 1.5;
  const double w = find_root(
      [=](const double x)
      { return 2. * (1. - std::pow(x, -4) / (l * l)) + 10. * (x * x - 1.); },
      .5, 1.);
  EXPECT_NEAR(compute_answer(specimen, {}, l, no_field).stress,
              2. * (l - std::pow(l, -3) * std::pow(w, -2)), 1e-12);
}

// Stretched to diag(l^2, 1), fibres at 45 degrees have I4 = (l^2 + 1)/2 and
// pull with S = 2 k1 (I4 - 1) a_0 (x) a_0.
TEST(FibreFamily, PureShearAtFortyFiveDegrees)
{
  const Elastomer with = make_film(QuadraticFibres{5.}, pi / 4.);
  for (const double l : {1.1, 1.8})
  {
    const Tensor C = {l * l, 1., 0.};
    const Tensor S = stress(with, C, nullptr, no_field);
    const double pull = .5 * 5. * (l * l - 1.);
    EXPECT_NEAR(S.xx, 2. * (1. - std::pow(l, -4)) + pull, 1e-13);
    EXPECT_NEAR(S.yy, 2. * (1. - std::pow(l, -2)) + pull, 1e-13);
    EXPECT_NEAR(S.xy, pull, 1e-13);
  }
}

TEST(FibreFamily, EquibiaxialTensionHasTheSameFibreStressAtAnyAngle)
{
  for (const double angle : {0., .4, 1.3})
  {
    const Elastomer film = make_film(QuadraticFibres{5.}, angle);
    const double x = 1.7;
    const Tensor S = stress(film, Tensor{x, x, 0.}, nullptr, no_field);
    EXPECT_NEAR(S.xx + S.yy, 4. * (1. - std::pow(x, -3)) + 10. * (x - 1.),
                1e-12);
  }
}

TEST(FibreFamily, SpreadInAllDirectionsAreIsotropic)
{
  // kappa = 1/3: W = k1/2 (I1/3 - 1)^2, that of a Yeoh spring with c2 = k1/18.
  Elastomer film = make_film(QuadraticFibres{18.}, .4);
  film.fibres[0].dispersion = 1. / 3.;
  const Elastomer isotropic = {{NeoHookean{2.}, Yeoh{0., 1., 0.}}, {}, {}, 0.};
  for (const State& state : make_states(0))
    expect_near(stress(film, state.C, nullptr, no_field),
                stress(isotropic, state.C, nullptr, no_field), 1e-11);
}

TEST(FibreFamily, ExponentialLawBeginsAsTheQuadraticOne)
{
  const Tensor C = {1.2, .9, .1};
  const auto compute = [&](const FibreLaw& law)
  { return stored_energy(make_film(law, .3), C, nullptr); };
  // exp(x) - 1 = x + x^2/2, x = k2 e^2 of 1e-6 at most.
  EXPECT_NEAR(compute(ExponentialFibres{5., 1e-5}) /
                  compute(QuadraticFibres{5.}),
              1., 1e-6);
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
