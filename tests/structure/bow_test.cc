#include <gtest/gtest.h>

#include <cmath>

#include "structure/bow.h"

// The exact bow: end slope a with k = sin(a/2), chord/L_1 = 2 E(k)/K(k) - 1,
// 4 K(k)^2 EI/L_1^2 = S (l - l^-3 - e l), l = lambda_p chord/L_1.
namespace taut::testing
{
namespace
{
struct Row
{
  double pre_stretch, slope, stretch, middle;
};

TEST(Bow, RestShapesAreExact)
{
  for (const Row& row : {Row{2, .9030373789, 1.6091813971, .2636755134},
                         Row{3, 1.5264068249, 1.4507784387, .3765497001},
                         Row{4, 1.7630879393, 1.3510502791, .3968142391},
                         Row{5, 1.8894074418, 1.2845747220, .4019553347}})
  {
    Bow bow;
    bow.pre_stretch = row.pre_stretch;
    Model model(make_bow_device(bow), make_bow_mesh(bow));
    auto& structure = *model.structure;
    structure::LoadHistory history(structure.device());
    history.enter_interval(0);
    std::vector<double> u(structure.n_free(), 0.);
    const auto shape = structure::find_rest_shape(structure, history,
                                                  structure::Networks::relaxed,
                                                  nullptr, 0, {}, u.data());
    EXPECT_EQ(shape.negative_eigenvalues, 0);
    EXPECT_GT(shape.flat_negative_eigenvalues, 0);
    const auto measured = measure_bow(structure, history.at(0), u.data());
    EXPECT_NEAR(measured.slope, row.slope, 1e-5);
    EXPECT_NEAR(measured.chord / bow.film_length, row.stretch, 1e-5);
    EXPECT_NEAR(measured.middle / bow.length(), row.middle, 1e-5);
  }
}

/// A bow at its rest shape, then under voltage.
class DrivenBow
{
public:
  explicit DrivenBow(const Bow& bow, const double film_field = 0)
      : bow_(bow), model_(make_bow_device(bow), make_bow_mesh(bow)),
        statics_(*model_.structure)
  {
    set_field(film_field);
  }

  structure::RestShape find_rest_shape()
  {
    auto& structure = *model_.structure;
    structure::LoadHistory history(statics_.loads);
    history.enter_interval(0);
    return structure::find_rest_shape(structure, history,
                                      structure::Networks::relaxed, nullptr, 0,
                                      {}, statics_.u.data());
  }
  /// Et = (V/H) sqrt(eps/mu).
  void set_field(const double field)
  {
    statics_.set_voltage(
        make_voltage(model_.structure->device().films[0], field, bow_.modulus));
  }
  void raise_field(const double first, const double last,
                   const unsigned int n_steps)
  {
    for (unsigned int step = 1; step <= n_steps; ++step)
    {
      set_field(first + (last - first) * step / n_steps);
      statics_.find();
    }
  }
  BowShape measure()
  {
    return measure_bow(*model_.structure, statics_.get_loads(),
                       statics_.u.data());
  }
  /// From the voltage at which the flat film is slack, where the beam is
  /// straight whatever the film's height, down to none.
  void let_go(const unsigned int n_steps)
  {
    raise_field(std::sqrt(1 - std::pow(bow_.pre_stretch, -4)), 0, n_steps);
  }
  /// From the present shape; a flat one stays flat.
  bool is_stable()
  {
    statics_.find();
    return statics_.count_negative_eigenvalues() == 0;
  }

private:
  const Bow bow_;
  Model model_;
  Statics statics_;
};

/// Where `is_stable` changes between `stable` and `unstable`.
double find_threshold(double stable, double unstable,
                      const std::function<bool(double)>& is_stable)
{
  EXPECT_TRUE(is_stable(stable));
  EXPECT_FALSE(is_stable(unstable));
  while (std::abs(unstable - stable) > 1e-7)
  {
    const double middle = .5 * (stable + unstable);
    (is_stable(middle) ? stable : unstable) = middle;
  }
  return .5 * (stable + unstable);
}

TEST(Bow, StraightensUnderVoltageAlongTheExactBranch)
{
  Bow bow;
  bow.pre_stretch = 3;
  DrivenBow driven(bow);
  driven.find_rest_shape();
  double last = 0;
  for (const auto& [field, slope] :
       {std::pair(.2, 1.5091254270), std::pair(.4, 1.4476943834),
        std::pair(.6, 1.2942757789), std::pair(.8, .7364634942)})
  {
    driven.raise_field(last, field, 4);
    last = field;
    EXPECT_TRUE(driven.is_stable());
    EXPECT_NEAR(driven.measure().slope, slope, 1e-5) << field;
  }
}

TEST(Bow, IsFlatAboveTheThresholdOfVoltage)
{
  Bow bow;
  bow.pre_stretch = 3;
  DrivenBow flat(bow, .9);
  EXPECT_NEAR(find_threshold(.9, .8,
                             [&](const double field)
                             {
                               flat.set_field(field);
                               return flat.is_stable();
                             }),
              .8446884888, 1e-5);
  EXPECT_NEAR(flat.measure().slope, 0, 1e-12);
}

TEST(Bow, BucklesAtTheExactPreStretch)
{
  EXPECT_NEAR(find_threshold(1.6, 1.8,
                             [&](const double pre_stretch)
                             {
                               Bow bow;
                               bow.pre_stretch = pre_stretch;
                               return DrivenBow(bow).is_stable();
                             }),
              1.6798174067, 1e-5);
}

/// Film on rigid stand-offs at the beam's ends: their height over the beam's
/// length, the slope there and the stretch of the film. Solutions of the beam's
/// equation with 12 digits.
struct StandOffRow
{
  double pre_stretch, height, stiffness_number, slope, stretch;
};

TEST(Bow, StandOffsFollowTheExactBeam)
{
  for (const auto& row :
       {StandOffRow{2, .25, 4.371782361252, .3652668548781, 1.594699762943},
        StandOffRow{2, .5, 14.54956540378, .1949714750333, 1.599554149046},
        StandOffRow{2, 1, 55.22782021495, .09934344583796, 1.599969774567},
        StandOffRow{3, .25, 11.25783988823, .3658700821848, 2.390958404292},
        StandOffRow{3, .5, 37.46679597111, .1949971829932, 2.399250377459},
        StandOffRow{3, 1, 142.2179573409, .09934432248598, 2.399949340033}})
  {
    Bow bow;
    bow.pre_stretch = row.pre_stretch;
    bow.stand_off = row.height * bow.length();
    bow.stiffness_number = row.stiffness_number;
    bow.inextensibility = 1e8;
    DrivenBow driven(bow);
    driven.let_go(16);
    EXPECT_TRUE(driven.is_stable());
    const auto shape = driven.measure();
    EXPECT_NEAR(shape.slope, row.slope, 1e-6) << row.height;
    EXPECT_NEAR((shape.chord - 2 * bow.stand_off * std::sin(shape.slope)) /
                    bow.film_length,
                row.stretch, 1e-6 * row.stretch)
        << row.height;
  }
}

/// The same for K_bb = 1, with the film's length and the distance of the beam's
/// middle from its chord over the beam's length.
struct ElasticaRow
{
  double pre_stretch, height, slope, chord, stretch, middle;
};

TEST(Bow, FortyElementsAreExactToAMillionth)
{
  for (const auto& row : {ElasticaRow{2, 0, .9030373789251, .804590698571,
                                      1.609181397142, .2636755134092},
                          ElasticaRow{5, 0, 1.889407441822, .2569149443909,
                                      1.284574721955, .4019553347483},
                          ElasticaRow{2, .005, .904700481867, .7974729129437,
                                      1.594945825887, .2630772892072},
                          ElasticaRow{3, .01, 1.499262482197, .4803623429601,
                                      1.44108702888, .3731884767378},
                          ElasticaRow{4, .01, 1.731185553793, .3364722716857,
                                      1.345889086743, .3952023284654},
                          ElasticaRow{2, .02, .906006576793, .7773086320967,
                                      1.554617264193, .2605834805079},
                          ElasticaRow{5, .02, 1.822352462856, .2555176223843,
                                      1.277588111921, .4006056988743}})
  {
    Bow bow;
    bow.pre_stretch = row.pre_stretch;
    bow.stand_off = row.height * bow.length();
    bow.inextensibility = 1e9;
    DrivenBow driven(bow);
    // Low stand-offs leave a sharp bend in the path near the threshold.
    if (row.height > 0)
      driven.let_go(40);
    else
      driven.find_rest_shape();
    EXPECT_TRUE(driven.is_stable());
    const auto shape = driven.measure();
    const auto& [pre_stretch, height, slope, chord, stretch, middle] = row;
    // The ends of the film, on their stand-offs.
    const double distance =
        shape.chord - 2 * bow.stand_off * std::sin(shape.slope);
    EXPECT_NEAR(shape.slope, slope, 1e-6) << pre_stretch << " " << height;
    EXPECT_NEAR(distance / bow.length(), chord, 1e-6)
        << pre_stretch << " " << height;
    EXPECT_NEAR(shape.middle / bow.length(), middle, 1e-6)
        << pre_stretch << " " << height;
    EXPECT_NEAR(distance / bow.film_length, stretch, 1e-6 * stretch)
        << pre_stretch << " " << height;
  }
}
} // namespace
} // namespace taut::testing
