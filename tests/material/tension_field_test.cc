// The relaxed energy of a film that wrinkles: closed forms, derivatives, and
// what happens where it begins to wrinkle and to go slack.
#include "automatic_differentiation.h"
#include "tension_points.h"

namespace
{
using namespace taut::material;

/// One state of each kind, away from where the kind changes.
struct StateOfKind
{
  Kind kind;
  Tensor C;
};
const std::array<StateOfKind, 4> some_states = {
    {{Kind::taut, make_turned(1.5, 1.4, .3)},
     {Kind::wrinkled, make_turned(1.5, .5, .3)},
     {Kind::wrinkled, make_turned(1.05, .8, 1.2)},
     {Kind::slack, make_turned(.7, .6, .3)}}};

TEST(TensionField, UniaxialTensionOfANeoHookeanFilm)
{
  // At stretches 1.05 and .9 both nominal stresses l - 1/(l^3 l_other^2) are
  // negative, the natural width is 1.05^(-1/2) and the nominal stress
  // 1.05 - 1.05^-2. The cost of wrinkles changes all by its share, 2e-6.
  const Point point = make_neo_hookean();
  const Tensor C = {1.05 * 1.05, .9 * .9, 0.};
  const Tensor flat = point.get_flat_stress(C);
  EXPECT_NEAR(flat.xx * 1.05, -.0165, 5e-5);
  EXPECT_NEAR(flat.yy * .9, -.344, 5e-4);
  const auto wrinkles = point.find(C);
  EXPECT_EQ(get_kind(wrinkles), Kind::wrinkled);
  constexpr double share = 3e-6;
  EXPECT_NEAR(std::sqrt(wrinkles.metric.yy), std::pow(1.05, -.5), share);
  const Tensor S = point.get_stress(C);
  EXPECT_NEAR(S.xx * 1.05, 1.05 - std::pow(1.05, -2), share);
  EXPECT_NEAR(S.yy, 0., share);
  EXPECT_NEAR(S.xy, 0., share);
}

TEST(TensionField, NaturalWidthUnderVoltage)
{
  // l2^2 of l2^2 - 1/(l1 l2)^2 - e (l1 l2)^2 = 0.
  const double e = .2, l1 = 1.3;
  const Point point = make_neo_hookean(std::sqrt(e));
  const auto wrinkles = point.find({l1 * l1, .25, 0.});
  EXPECT_EQ(get_kind(wrinkles), Kind::wrinkled);
  EXPECT_NEAR(wrinkles.metric.yy, 1. / (l1 * std::sqrt(1. - e * l1 * l1)),
              1e-5);
}

TEST(TensionField, SlackFilmHasItsNaturalShape)
{
  // Without voltage undeformed, at e the free actuation l^-2 - l^-8 = e.
  const Tensor C = make_turned(.7, .5, .4);
  EXPECT_EQ(get_kind(make_neo_hookean().find(C)), Kind::slack);
  expect_near(make_neo_hookean().find(C).metric, make_identity<double>(), 3e-6);
  const double l = 1.1;
  const double e = std::pow(l, -2) - std::pow(l, -8);
  expect_near(make_neo_hookean(std::sqrt(e)).find(C).metric, {l * l, l * l, 0.},
              1e-5);
}

TEST(TensionField, TautFilmIsUntouched)
{
  const Point point = make_viscous(1e6);
  const Tensor C = some_states[0].C;
  const auto wrinkles = point.find(C);
  EXPECT_EQ(get_kind(wrinkles), Kind::taut);
  EXPECT_EQ(wrinkles.metric.xx, C.xx);
  EXPECT_EQ(wrinkles.metric.yy, C.yy);
  EXPECT_EQ(wrinkles.metric.xy, C.xy);
  EXPECT_EQ(compute_wrinkle_energy(wrinkles, C), 0.);
  Tensor S;
  Matrix3<double> D;
  stress_and_stiffness(point.elastomer, C, point.A.data(), point.field, frozen,
                       S, D);
  expect_near(point.get_stiffness(C), D, 0.);
}

TEST(TensionField, StressIsThatOfTheWrinkledMetric)
{
  // The search ends with a step below 1e-6; both are right to its square, of
  // moduli of 1e5.
  for (const Point& point : {make_viscous(), make_viscous(2e6)})
    for (const auto& [kind, C] : some_states)
      expect_near(point.get_stress(C),
                  point.get_flat_stress(point.find(C).metric), 1e-6);
}

TEST(TensionField, StressIsTheDerivativeOfTheEnergy)
{
  for (const Point& point : {make_viscous(), make_viscous(2e6)})
    for (const auto& [kind, C] : some_states)
    {
      EXPECT_EQ(get_kind(point.find(C)), kind);
      // Differences of fourth order with steps of 1e-3, energies and stresses
      // of 1e5.
      expect_near(point.get_stress(C), differentiate_energy(point, C), 1e-3);
    }
}

TEST(TensionField, StressIsTheAutomaticDerivativeOfTheEnergy)
{
  const Point point{{make_springs(), {}, {}, 0.}, {}};
  for (const auto& [kind, C] : some_states)
  {
    const SymmetricTensor2<First> variable = make_first(C, 0);
    const auto wrinkles =
        find_wrinkles(point.elastomer, variable, nullptr, point.field,
                      stress(point.elastomer, variable, nullptr, point.field),
                      get_wrinkle_stiffness(point.elastomer));
    const First energy_r =
        energy(point.elastomer, wrinkles.metric, nullptr, point.field) +
        compute_wrinkle_energy(wrinkles, variable);
    // By the envelope theorem only the explicit derivative counts, up to the
    // rounding of the condition of equilibrium.
    expect_near({2. * energy_r.dx(0), 2. * energy_r.dx(1), energy_r.dx(2)},
                point.get_stress(C), 1e-6);
  }
}

TEST(TensionField, StiffnessIsTheDerivativeOfTheStress)
{
  for (const Point& point : {make_viscous(), make_viscous(2e6)})
    for (const auto& [kind, C] : some_states)
    {
      const auto D = point.get_stiffness(C);
      const auto differences = differentiate_stress(point, C, 1e-3);
      expect_near(D, differences, 1e-6 * (norm(D) + 1e3));
      EXPECT_LT(get_asymmetry(D) * norm(D), 1e-9 * norm(differences) + 1e-6);
    }
}

/// The width between 0.3 and 2 at which `is_beyond` changes, by bisection.
template <class Predicate>
double find_width(const Predicate& is_beyond)
{
  double low = .3, high = 2.;
  for (unsigned int i = 0; i < 60; ++i)
    (is_beyond(.5 * (low + high)) ? high : low) = .5 * (low + high);
  return .5 * (low + high);
}

/// Energy and stress of the two sides of a switch, and the stiffness beside it.
template <class MakeMetric>
void expect_smooth_switch(const Point& point, const MakeMetric& make,
                          const double width, const Kind narrow,
                          const Kind wide)
{
  constexpr double step = 1e-9;
  const Tensor below = make(width - step), above = make(width + step);
  EXPECT_EQ(get_kind(point.find(below)), narrow);
  EXPECT_EQ(get_kind(point.find(above)), wide);
  // Both change by about the modulus, 1e5 Pa, times the step.
  EXPECT_NEAR(point.get_energy(below), point.get_energy(above), 1e-3);
  expect_near(point.get_stress(below), point.get_stress(above), 5e-3);
  // Beside the switch, so near that the differences just do not reach it.
  for (const double distance : {-1e-5, 1e-5})
  {
    const Tensor C = make(width + distance);
    const auto D = point.get_stiffness(C);
    expect_near(D, differentiate_stress(point, C, 1e-6),
                1e-4 * (norm(D) + 1e3));
  }
}

TEST(TensionField, BeginsSmoothly)
{
  for (const Point& point : {make_viscous(), make_viscous(2e6)})
  {
    const auto make = [](const double width)
    { return make_turned(1.6, width, .7); };
    const double width =
        find_width([&](const double w)
                   { return get_kind(point.find(make(w))) == Kind::taut; });
    expect_smooth_switch(point, make, width, Kind::wrinkled, Kind::taut);
  }
}

TEST(TensionField, GoesSlackSmoothly)
{
  for (const Point& point : {make_viscous(), make_viscous(2e6)})
  {
    const auto make = [](const double width)
    { return make_turned(.5, width, .7); };
    const double width =
        find_width([&](const double w)
                   { return get_kind(point.find(make(w))) == Kind::wrinkled; });
    expect_smooth_switch(point, make, width, Kind::slack, Kind::wrinkled);
  }
}

TEST(TensionField, DoesNotDependOnTheAxes)
{
  Point point = make_viscous(2e6), turned = point;
  for (Tensor& A : turned.A)
    A = rotate(A, .8);
  for (const auto& [kind, C] : some_states)
  {
    EXPECT_NEAR(turned.get_energy(rotate(C, .8)), point.get_energy(C), 1e-6);
    expect_near(turned.get_stress(rotate(C, .8)),
                rotate(point.get_stress(C), .8), 1e-6);
  }
}

TEST(TensionField, CarriesNoCompression)
{
  // T = S* + 2 delta G (1 + E) has no negative eigenvalue, and none in the
  // wrinkles.
  const Point point = make_viscous(2e6);
  for (const State& state : make_states(0))
  {
    const Tensor C = {.3 * state.C.xx, .3 * state.C.yy, .3 * state.C.xy};
    const auto wrinkles = point.find(C);
    ASSERT_TRUE(wrinkles.admissible);
    const Tensor T = compute_wrinkle_tension(
        wrinkles.metric, C, point.get_flat_stress(wrinkles.metric),
        wrinkles.stiffness);
    const Tensor E = compute_wrinkle_strain(wrinkles, C);
    const double scale = shear_modulus(point.elastomer);
    EXPECT_GT(T.xx + T.yy, -1e-9 * scale);
    EXPECT_GT(compute_determinant(T), -1e-9 * scale * scale);
    EXPECT_NEAR(contract(T, E), 0., 1e-8 * scale);
    EXPECT_GT(E.xx + E.yy, -1e-12);
    EXPECT_GT(compute_determinant(E), -1e-9);
  }
}

TEST(TensionField, CollapsedFilmWithALimitStillHasAState)
{
  // The metric itself is far beyond the limit, that of the wrinkled film not.
  Point point{{{Gent{1., 20.}}, {}, {ConstantPermittivity{1.}}, 0.}, {}};
  const Tensor C = make_turned(1.5, .01, .4);
  EXPECT_LT(limit_margin(point.elastomer, C, nullptr), 0.);
  const auto wrinkles = point.find(C);
  ASSERT_TRUE(wrinkles.admissible);
  EXPECT_NEAR(compute_determinant(wrinkles.metric), 1.5, 1e-4);
}

TEST(TensionField, WidthThatGrowsWithoutEndIsRefused)
{
  // Neo-Hookean wrinkles have a width only while Et^2 l1^2 < 1.
  const double l1 = 3.;
  const auto is_admissible = [&](const double number) {
    return make_neo_hookean(number).find({l1 * l1, .1, 0.}).admissible;
  };
  EXPECT_TRUE(is_admissible(.99 / l1));
  EXPECT_FALSE(is_admissible(1.01 / l1));
}

TEST(TensionField, FreeFilmBeyondPullInIsRefused)
{
  // Free actuation ends at Et = .6873648185 (l = 4^(1/6)).
  const Tensor C = make_turned(.7, .5, .4);
  EXPECT_TRUE(make_neo_hookean(.68).find(C).admissible);
  EXPECT_FALSE(make_neo_hookean(.69).find(C).admissible);
}

TEST(TensionField, RegularisationDoesNotMatter)
{
  Point point = make_viscous(2e6), half = point, tenfold = point;
  half.delta = .5 * point.delta;
  tenfold.delta = 10. * point.delta;
  for (const auto& [kind, C] : some_states)
    for (const Point& other : {half, tenfold})
    {
      const double modulus = shear_modulus(point.elastomer);
      EXPECT_NEAR(other.get_energy(C), point.get_energy(C), 1e-4 * modulus);
      expect_near(other.get_stress(C), point.get_stress(C), 1e-4 * modulus);
    }
}

TEST(TensionField, NetworksAndWrinklesAnswerTogether)
{
  // One implicit step of the networks at the metric of the wrinkled film,
  // alpha (A - A_0) = Adot(C*(C, A), A), solved to the end: its derivative by C
  // is the condensed one.
  const double alpha = 300.;
  for (const auto& [kind, C] : some_states)
  {
    const Point point = make_viscous(2e6);
    const std::size_t n = point.A.size();
    std::vector<Tensor> rate(n);
    rates(point.elastomer, point.find(C).metric, point.A.data(), rate.data());
    const auto step = [&](const Tensor& moved)
    {
      Point other = point;
      for (unsigned int i = 0; i < 200; ++i)
      {
        std::vector<Tensor> r(n);
        const Tensor metric = other.find(moved).metric;
        rates(point.elastomer, metric, other.A.data(), r.data());
        for (std::size_t m = 0; m < n; ++m)
        {
          const Tensor old = add_scaled(point.A[m], -1. / alpha, rate[m]);
          const Tensor next = add_scaled(old, 1. / alpha, r[m]);
          other.A[m] = combine(.7, other.A[m], .3, next);
        }
      }
      return other.get_stress(moved);
    };
    Matrix3<double> D;
    const auto N = point.get_response(C, alpha, D);
    const auto condensed = condense_wrinkles(N, D);
    for (unsigned int j = 0; j < 3; ++j)
    {
      const double h = 1e-5;
      const Tensor plus = step(move(C, j, h)), minus = step(move(C, j, -h));
      const double factor = (j < 2 ? 2. : 1.) / (2. * h);
      const double tolerance = 1e-4 * (norm(condensed) + 1e3);
      EXPECT_NEAR((plus.xx - minus.xx) * factor, condensed[0][j], tolerance);
      EXPECT_NEAR((plus.yy - minus.yy) * factor, condensed[1][j], tolerance);
      EXPECT_NEAR((plus.xy - minus.xy) * factor, condensed[2][j], tolerance);
    }
  }
}
} // namespace
