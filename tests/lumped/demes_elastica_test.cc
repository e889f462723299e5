#include <taut/base/exceptions.h>
#include <taut/lumped/demes_elastica.h>
#include <taut/lumped/demes_statics.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

using namespace taut;
using namespace taut::lumped;

namespace
{
using Rows = std::vector<std::vector<double>>;

// All tables come from another program (boundary-value problem and elliptic
// integrals), 12 to 13 digits.

/// lambda_p, h / C, K; p, C kappa in the middle, end angle, chord, lambda, sag,
/// frequencies relaxed and instantaneous.
const Rows& get_equilibria()
{
  static const Rows rows = {
      // clang-format off
      {2, 0, 1, 10.9535672309, 2.88818746327,
       0.9030373789251, 0.804590698571, 1.609181397142, 0.2636755134092,
       0.9999945103668, 1.469122784043},
      {4, 0, 1, 15.12888503331, 6.003357002302,
       1.763087939337, 0.3377625697736, 1.351050279094, 0.3968142390589,
       1.828432923577, 2.01817531065},
      {2.5, 0.005, 1, 12.24155357251, 4.230166699256,
       1.298309725974, 0.6051693685561, 1.51292342139, 0.3442123586537,
       1.430325531176, 1.840553264265},
      {4.5, 0.005, 1, 15.67337136701, 6.246418622349,
       1.818009469385, 0.2917249932977, 1.31276246984, 0.3997605278059,
       1.886701833083, 2.035616140202},
      {3, 0.01, 1, 13.28335599749, 4.966689384133,
       1.499262482197, 0.4803623429601, 1.44108702888, 0.3731884767378,
       1.644954956462, 1.963314999512},
      {5, 0.01, 1, 16.12185556962, 6.42659953384,
       1.85546866861, 0.2562770399662, 1.281385199831, 0.401434971797,
       1.926966660133, 2.0452714506},
      {3.5, 0.02, 1, 14.02031409806, 5.389085336038,
       1.606520395036, 0.3945921119472, 1.381072391815, 0.3850912626407,
       1.782582420492, 2.026781493504},
      {2, 0, 1.215854203708, 10.47228498979, 2.171603472351,
       0.6843330330815, 0.88573997271, 1.77147994542, 0.2073667279366,
       0.8089633238434, 1.242381007671},
      {4, 0, 1.215854203708, 14.81128393265, 5.840791207318,
       1.723034091138, 0.3630277296023, 1.452110918409, 0.3943473931008,
       1.934885745647, 2.193074054349},
      {2.5, 0.005, 1.215854203708, 11.78217284633, 3.856094848694,
       1.192858570172, 0.6614689669, 1.65367241725, 0.3254371262231,
       1.408428489545, 1.889435558988},
      {4.5, 0.005, 1.215854203708, 15.39453041514, 6.115034938563,
       1.786978384415, 0.3116475780203, 1.402414101091, 0.3982937816467,
       2.015778084169, 2.222947347027},
      {3, 0.01, 1.215854203708, 12.86799749432, 4.702900770165,
       1.429706709818, 0.5215978914151, 1.564793674245, 0.3640664010366,
       1.687492394843, 2.090463826095},
      {5, 0.01, 1.215854203708, 15.87736065891, 6.31834408401,
       1.830847248606, 0.2722954641153, 1.361477320576, 0.4005180483254,
       2.073211280891, 2.240297650006},
      {3.5, 0.02, 1.215854203708, 13.65151493341, 5.189827714656,
       1.557290757382, 0.4253400511334, 1.488690178967, 0.3798948631268,
       1.867801719944, 2.192020654815},
      // clang-format on
  };
  return rows;
}

/// lambda_p, h / C, K, theta of the arc; theta and lambda of the elastica,
/// relative errors of the arc's theta and lambda.
const Rows& get_standoffs()
{
  static const Rows rows = {
      // clang-format off
      {2, 0.25, 4.371782361252, 0.3640948408993,
       0.3652668548781, 1.594699762943, 0.003218979911674, -0.003312648160388},
      {2, 1, 55.22782021495, 0.09934132842147,
       0.09934344583796, 1.599969774567, 2.131455790466e-05, -1.889089565932e-05},
      {2, 5, 1356.853637538, 0.01999466926071,
       0.01999466996796, 1.59999995033, 3.53715763346e-08, -3.104383428099e-08},
      {3, 0.25, 11.25783988823, 0.3640948408993,
       0.3658700821848, 2.390958404292, 0.004875766108521, -0.003767331544987},
      {3, 1, 142.2179573409, 0.09934132842147,
       0.09934432248598, 2.399949340033, 3.01391631834e-05, -2.110831938462e-05},
      {3, 5, 3494.053395374, 0.01999466926071,
       0.01999467025675, 2.399999916827, 4.981520729253e-08, -3.465546516424e-08},
      {5, 0.25, 32.11767508266, 0.3640948408993,
       0.3659984444055, 3.984543608187, 0.005228317713877, -0.0038640979533},
      {5, 1, 405.7359307062, 0.09934132842147,
       0.09934450493465, 3.999913720755, 3.197574699176e-05, -2.15698113748e-05},
      {5, 5, 9968.24193524, 0.01999466926071,
       0.01999467031679, 3.999999858375, 5.28178332182e-08, -3.540627158127e-08},
      {5, 10, 39851.0546243, 0.009999333414462,
       0.009999333447498, 3.999999991139, 3.303827877943e-09, -2.215268413153e-09},
      // clang-format on
  };
  return rows;
}

/// tau, theta, theta', xi; lambda, p, sag of a free run with lambda_p = 3,
/// S = 0.3, h / C = 0.01 from the straight frame.
const Rows& get_motion()
{
  static const Rows rows = {
      // clang-format off
      {0.5, 0.03174477281262, 0.1675090303286, 2.993132429331,
       2.975302096431, 35.00703517062, 0.05663973203487},
      {1, 0.2384766789925, 0.7297589288676, 2.858763829268,
       2.731104349388, 30.17414597624, 0.1874284573475},
      {1.5, 0.7908749761066, 1.449967140131, 2.416786633048,
       2.207491877449, 20.42332706031, 0.3013670968278},
      {2, 1.590529255084, 1.598004249983, 1.650972311029,
       1.523294193101, 8.51652018136, 0.3594977330263},
      {2.5, 2.23124460599, 0.8271754208207, 1.056260049554,
       1.03633915035, -0.5505511611213, 0.3599474918538},
      {3, 2.329703483681, -0.4521895555468, 0.9564750515148,
       0.9593129594977, -1.710175499835, 0.3577598414047},
      {3.5, 1.842170870995, -1.360096707438, 1.138837613208,
       1.163848944039, 8.594947625433, 0.3776580586684},
      {4, 1.143314805814, -1.265600554387, 1.565856233452,
       1.639703888107, 20.33177018505, 0.3688502298283},
      {4.5, 0.6957310019014, -0.4649122364034, 2.006227420276,
       2.089781494667, 26.1081494956, 0.3236559807371},
      {5, 0.692599518516, 0.4346689045276, 2.175500359112,
       2.169677771046, 24.71302096661, 0.3108773576039},
      {5.5, 1.087285202152, 1.071291178302, 1.95818502676,
       1.868855773586, 17.58535918626, 0.3431673140167},
      {7, 2.070688811079, -0.4629226585689, 1.066671747974,
       1.071709266916, 3.639292287008, 0.3692784740194},
      {9, 0.9883202138363, 0.4719568487672, 1.91707095707,
       1.895989564066, 20.2913155645, 0.3433275372521},
      {11, 1.850300767712, -0.5095265456129, 1.17711760118,
       1.186449762986, 7.85101459955, 0.3753226340005},
      {13, 1.210874383346, 0.4823942789123, 1.730169603592,
       1.704377025718, 16.97113848078, 0.358769753503},
      {15, 1.675391880087, -0.4800345077067, 1.280867754569,
       1.293820066239, 10.91844440395, 0.3770110818111},
      {17, 1.372651625189, 0.4291055258101, 1.591017585061,
       1.56842769631, 14.61668639303, 0.366590292295},
      {19, 1.552033854667, -0.3917553876464, 1.366524000743,
       1.380635694485, 12.90086883553, 0.3761255183957},
      // clang-format on
  };
  return rows;
}

DemesElastica make_elastica(const double pre_stretch, const double standoff = 0,
                            const double stiffness = 1)
{
  DemesElastica elastica;
  elastica.demes.pre_stretch = pre_stretch;
  elastica.demes.frame_stiffness = stiffness;
  elastica.standoff = standoff;
  return elastica;
}

/// A film of constant permittivity, as in the closed forms.
DemesElastica make_bow(const double pre_stretch)
{
  auto elastica = make_elastica(pre_stretch);
  elastica.demes.permittivity = {};
  return elastica;
}

void expect_close(const double value, const double expected,
                  const double tolerance)
{
  EXPECT_NEAR(value, expected, tolerance * std::max(1., std::abs(expected)));
}
} // namespace

TEST(DemesElastica, EquilibriaOfTheReferenceAreReproduced)
{
  for (const auto& row : get_equilibria())
  {
    const auto states =
        find_equilibria(make_elastica(row[0], row[1], row[2]), 0);
    ASSERT_EQ(states.size(), row[1] == 0 ? 2u : 1u);
    const auto& state = states.back();
    EXPECT_TRUE(state.stable);
    constexpr double digits = 2e-12;
    expect_close(state.shape.load, row[3], digits);
    expect_close(state.shape.mid_curvature, row[4], digits);
    expect_close(state.shape.end_angle, row[5], digits);
    expect_close(state.chord, row[6], digits);
    expect_close(state.stretch, row[7], digits);
    expect_close(state.shape.sag, row[8], digits);
    // Difference quotients of order 8 leave 1e-12 here, those of the table
    // 1e-10.
    expect_close(std::sqrt(state.frequencies.relaxed_squared), row[9], 2e-10);
    expect_close(std::sqrt(state.frequencies.instantaneous_squared), row[10],
                 2e-10);
  }
}

TEST(DemesElastica, HighStandoffsMakeItAnArc)
{
  for (const auto& row : get_standoffs())
  {
    const auto elastica = make_elastica(row[0], row[1], row[2]);
    const auto state = find_equilibria(elastica, 0).back();
    EXPECT_NEAR(state.shape.end_angle, row[4], 1e-12);
    EXPECT_NEAR(state.stretch, row[5], 5e-12);
    Demes arc = elastica.demes;
    arc.eccentricity = 2 * row[1];
    const auto rest = make_rest_start(arc);
    EXPECT_NEAR(rest.angle, row[3], 1e-12);
    EXPECT_NEAR(state.shape.end_angle / rest.angle - 1, row[6], 1e-10);
    EXPECT_NEAR(state.stretch / rest.inner_stretch - 1, row[7], 1e-10);
  }
}

TEST(DemesElastica, MotionOfTheReferenceIsReproduced)
{
  auto elastica = make_elastica(3, 0.01);
  elastica.demes.relaxation = 0.3;
  ElasticaRunOptions options;
  options.end_time = get_motion().back()[0];
  for (const auto& row : get_motion())
    options.output_times.push_back(row[0]);
  options.start = {0, 0, 3};
  const auto rows = run_elastica(elastica, options);
  ASSERT_EQ(rows.size(), get_motion().size() + 1);
  // Local tolerance 1e-10; p multiplies the error by the film's stiffness.
  constexpr double error = 1e-8;
  bool pushes = false;
  for (std::size_t i = 0; i < get_motion().size(); ++i)
  {
    const auto& expected = get_motion()[i];
    const auto& row = rows[i + 1];
    expect_close(row.shape.end_angle, expected[1], error);
    expect_close(row.velocity, expected[2], error);
    expect_close(row.inner_stretch, expected[3], error);
    expect_close(row.stretch, expected[4], error);
    expect_close(row.shape.load, expected[5], 10 * error);
    expect_close(row.shape.sag, expected[6], error);
    pushes = pushes || row.membrane_force < 0;
  }
  EXPECT_TRUE(pushes);
}

// p = 4 K(k)^2, chord = 2 E(k) / K(k) - 1, sag = k / K(k), k = sin(theta / 2).
TEST(DemesElastica, WithoutStandoffItIsTheClosedForm)
{
  const auto state = find_equilibria(make_bow(2.7), 0.3).back();
  const double k = std::sin(state.shape.end_angle / 2);
  const double first = boost::math::ellint_1(k);
  const double second = boost::math::ellint_2(k);
  EXPECT_NEAR(state.shape.load, 4 * first * first, 1e-12);
  EXPECT_NEAR(state.chord, 2 * second / first - 1, 1e-14);
  EXPECT_NEAR(state.shape.sag, k / first, 1e-14);
  EXPECT_NEAR(state.shape.load, 4 * 2.7 * state.membrane_force, 1e-11);
}

// End angle, stretch and mid deflection of the bow, 10 digits.
TEST(DemesElastica, BowAtRestAndUnderVoltage)
{
  const Rows rest = {{2, .9030373789, 1.6091813971, .2636755134},
                     {3, 1.5264068249, 1.4507784387, .3765497001},
                     {4, 1.7630879393, 1.3510502791, .3968142391}};
  for (const auto& row : rest)
  {
    const auto state = find_equilibria(make_bow(row[0]), 0).back();
    EXPECT_NEAR(state.shape.end_angle, row[1], 6e-11);
    EXPECT_NEAR(state.stretch, row[2], 6e-11);
    EXPECT_NEAR(state.shape.sag, row[3], 6e-11);
  }
  const Rows driven = {{.2, 1.5091254270},
                       {.4, 1.4476943834},
                       {.6, 1.2942757789},
                       {.8, .7364634942}};
  for (const auto& row : driven)
    EXPECT_NEAR(find_equilibria(make_bow(3), row[0]).back().shape.end_angle,
                row[1], 6e-11);
}

TEST(DemesElastica, BucklesEarlierThanTheArcAndFlattensAtItsVoltage)
{
  const auto bow = make_bow(3);
  const double critical = compute_critical_pre_stretch(bow);
  EXPECT_NEAR(critical, 1.6798174067, 6e-11);
  EXPECT_NEAR(compute_flattening_drive(bow), 0.8446884888, 6e-11);
  // 12 / pi^2 - 1 = 21.6 %.
  const auto load = [](const double x) { return x * x - 1 / (x * x); };
  EXPECT_NEAR(load(compute_critical_pre_stretch(bow.demes)) / load(critical),
              12 / (std::acos(-1.) * std::acos(-1.)), 1e-12);
  EXPECT_EQ(find_equilibria(make_bow(critical - 1e-4), 0).size(), 1u);
  EXPECT_TRUE(find_equilibria(make_bow(critical - 1e-4), 0)[0].stable);
  const auto above = find_equilibria(make_bow(critical + 1e-4), 0);
  ASSERT_EQ(above.size(), 2u);
  EXPECT_FALSE(above[0].stable);
  EXPECT_TRUE(above[1].stable);
  EXPECT_EQ(find_equilibria(bow, 0.8446).size(), 2u);
  EXPECT_EQ(find_equilibria(bow, 0.8448).size(), 1u);
}

TEST(DemesElastica, StraightFrameHasTheFrequencyOfABeamColumn)
{
  // Without load the end rotation of a beam bent by end moments: K.
  auto slack = make_bow(1);
  EXPECT_NEAR(find_equilibria(slack, 0)[0].frequencies.relaxed_squared, 1,
              1e-12);
  // (K / 2) sqrt(p) cot(sqrt(p) / 2), hyperbolic where the film pushes.
  const auto pulled = find_equilibria(make_bow(1.2), 0)[0];
  const auto pushed = find_equilibria(slack, 0.5)[0];
  EXPECT_NEAR(pushed.shape.load, -1, 1e-12);
  EXPECT_NEAR(pushed.frequencies.relaxed_squared, 0.5 / std::tanh(0.5), 1e-12);
  EXPECT_LT(pulled.frequencies.relaxed_squared, 1);
  EXPECT_TRUE(pushed.stable && pulled.stable);
}

// phi'' = -p sin(phi) integrated numerically, in all three regimes: the tangent
// swings back, turns over, and the film pushes.
TEST(ElasticaShape, EqualsNumericalIntegration)
{
  const Rows states = {{2.9, 11},  {-5, 14}, {7, 3},  {6, -1.7},
                       {0.1, -30}, {4, 0},   {2, 35}, {-3, -2}};
  for (const auto& state : states)
  {
    time::OdeProblem problem;
    problem.size = 4;
    problem.rate = [&](double, const double* y, double* rate)
    {
      rate[0] = y[1];
      rate[1] = -state[1] * std::sin(y[0]);
      rate[2] = 2 * std::cos(y[0]);
      rate[3] = std::sin(y[0]);
    };
    time::OdeOptions options;
    options.method = time::OdeMethod::explicit_runge_kutta;
    options.relative_tolerance = 1e-13;
    options.absolute_tolerance = 1e-14;
    std::vector<double> y = {0, state[0], 0, 0};
    time::integrate_ode(problem, {0, 0.5, {}}, options, {}, {}, y);
    const auto shape = compute_elastica(state[0], state[1]);
    EXPECT_NEAR(shape.end_angle, y[0], 1e-11);
    EXPECT_NEAR(shape.end_curvature, y[1], 1e-10);
    EXPECT_NEAR(shape.frame_chord, y[2], 1e-11);
    EXPECT_NEAR(shape.sag, y[3], 1e-11);
  }
}

TEST(DemesElasticaRefusals, ImpossibleFramesAndStarts)
{
  EXPECT_THROW(find_equilibria(make_elastica(2, -0.1), 0), BadInput);
  EXPECT_THROW(compute_critical_pre_stretch(make_elastica(2, 0.1)), BadInput);
  EXPECT_THROW(compute_flattening_drive(make_elastica(2, 0.1)), BadInput);
  auto eccentric = make_elastica(2);
  eccentric.demes.eccentricity = 0.01;
  EXPECT_THROW(find_equilibria(eccentric, 0), BadInput);
  ElasticaRunOptions options;
  options.end_time = 1;
  // Clamped ends hold a straight frame up to p = 4 pi^2, lambda_p = 3.158.
  options.start = {0, 0, 3.15};
  EXPECT_NO_THROW(run_elastica(make_elastica(3.15, 0.01), options));
  options.start = {0, 0, 3.17};
  EXPECT_THROW(run_elastica(make_elastica(3.17, 0.01), options), BadInput);
  options.start = {0, 0, 0};
  EXPECT_THROW(run_elastica(make_elastica(2), options), BadInput);
  options.start = {0, 0, 2};
  options.end_time = -1;
  EXPECT_THROW(run_elastica(make_elastica(2), options), BadInput);
}
