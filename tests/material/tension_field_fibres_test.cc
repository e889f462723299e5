// The relaxed energy of films with fibres: they are part of the energy that
// wrinkles make smallest, so that all of it holds as for isotropic films.
#include "rheometer.h"
#include "tension_points.h"

namespace
{
using namespace taut::material;

FibreFamily make_family(const FibreLaw& law, const double angle,
                        const double dispersion = 0.)
{
  return {law, {{std::cos(angle), std::sin(angle)}}, true, dispersion};
}

Point make_reinforced(const FibreFamily& family)
{
  Point point = make_neo_hookean();
  point.elastomer.fibres = {family};
  return point;
}

/// Fibres softer and stiffer than the springs beside them, 9e4 Pa, and
/// networks out of equilibrium.
std::vector<Point> make_points()
{
  std::vector<Point> points;
  for (const FibreFamily& family :
       {make_family(QuadraticFibres{2e4}, .5),
        make_family(QuadraticFibres{1e6}, 1.1),
        make_family(ExponentialFibres{5e4, .8}, -.4),
        make_family(ExponentialFibres{2e5, .3}, 2., .15)})
  {
    points.push_back(make_viscous(2e6));
    points.back().elastomer.fibres = {family};
  }
  return points;
}

std::vector<Tensor> make_metrics()
{
  return {make_turned(1.5, 1.4, .3), make_turned(1.5, .5, .3),
          make_turned(1.05, .8, 1.2), make_turned(.7, .6, .3),
          make_turned(1.6, .4, .5)};
}

// Wrinkles along the fibres: these leave the natural width 1/sqrt(l) as it is
// and add 2 k1 l (l^2 - 1) to the nominal stress. The cost of wrinkles changes
// all by its share, 2e-6 of the modulus 1.
TEST(WrinkledFibres, UniaxialTensionAlongThem)
{
  const Point point = make_reinforced(make_family(QuadraticFibres{3.}, 0.));
  const double l = 1.2;
  const Tensor C = {l * l, .25, 0.};
  const auto wrinkles = point.find(C);
  EXPECT_EQ(get_kind(wrinkles), Kind::wrinkled);
  EXPECT_NEAR(std::sqrt(wrinkles.metric.yy), 1. / std::sqrt(l), 1e-5);
  EXPECT_NEAR(l * point.get_stress(C).xx,
              l - 1. / (l * l) + 6. * l * (l * l - 1.), 1e-5);
}

// Across, fibres that buckle do nothing; those that do not widen the film to
// where 1 - 1/(w^4 l^2) + 2 k1 (w^2 - 1) = 0.
TEST(WrinkledFibres, UniaxialTensionAcrossThem)
{
  FibreFamily family = make_family(QuadraticFibres{3.}, 0.);
  const double l = 1.2;
  const Tensor C = {.25, l * l, 0.};
  const auto slender = make_reinforced(family).find(C);
  EXPECT_NEAR(std::sqrt(slender.metric.xx), 1. / std::sqrt(l), 1e-5);
  family.tension_only = false;
  const auto stiff = make_reinforced(family).find(C);
  const double width =
      find_root([=](const double w)
                { return 1. - std::pow(w, -4) / (l * l) + 6. * (w * w - 1.); },
                .5, 1.5);
  EXPECT_EQ(get_kind(stiff), Kind::wrinkled);
  EXPECT_NEAR(std::sqrt(stiff.metric.xx), width, 1e-5);
}

TEST(WrinkledFibres, StressIsTheDerivativeOfTheEnergy)
{
  for (const Point& point : make_points())
    for (const Tensor& C : make_metrics())
    {
      ASSERT_TRUE(point.find(C).admissible);
      // Differences of fourth order with steps of 1e-3.
      expect_near(point.get_stress(C), differentiate_energy(point, C),
                  1e-8 * norm(point.get_stiffness(C)) + 1e-3);
    }
}

TEST(WrinkledFibres, StiffnessIsTheDerivativeOfTheStress)
{
  for (const Point& point : make_points())
    for (const Tensor& C : make_metrics())
    {
      const auto D = point.get_stiffness(C);
      expect_near(D, differentiate_stress(point, C, 1e-3),
                  1e-6 * (norm(D) + 1e3));
      EXPECT_LT(get_asymmetry(D) * norm(D), 1e-9 * norm(D) + 1e-6);
    }
}

TEST(WrinkledFibres, WithTheirFilmDoNotDependOnTheAxes)
{
  const double angle = .8;
  for (const Point& point : make_points())
  {
    Point turned = point;
    for (Tensor& A : turned.A)
      A = rotate(A, angle);
    auto& [x, y] = turned.elastomer.fibres[0].direction;
    const double c = std::cos(angle), s = std::sin(angle);
    turned.elastomer.fibres[0].direction = {{c * x - s * y, s * x + c * y}};
    // Rounding of stiffnesses up to 1e7 Pa.
    for (const Tensor& C : make_metrics())
    {
      EXPECT_NEAR(turned.get_energy(rotate(C, angle)), point.get_energy(C),
                  1e-6);
      expect_near(turned.get_stress(rotate(C, angle)),
                  rotate(point.get_stress(C), angle), 1e-5);
    }
  }
}

TEST(WrinkledFibres, CarryNoCompression)
{
  for (const Point& point : make_points())
    for (const State& state : make_states(0))
    {
      const Tensor C = {.3 * state.C.xx, .3 * state.C.yy, .3 * state.C.xy};
      const auto wrinkles = point.find(C);
      ASSERT_TRUE(wrinkles.admissible);
      const Tensor T = compute_wrinkle_tension(
          wrinkles.metric, C, point.get_flat_stress(wrinkles.metric),
          wrinkles.stiffness);
      const Tensor E = compute_wrinkle_strain(wrinkles, C);
      const double scale = shear_modulus(point.elastomer) + 1e6;
      EXPECT_GT(T.xx + T.yy, -1e-9 * scale);
      EXPECT_GT(compute_determinant(T), -1e-9 * scale * scale);
      EXPECT_NEAR(contract(T, E), 0., 1e-8 * scale);
      EXPECT_GT(E.xx + E.yy, -1e-12);
    }
}
} // namespace
