#include <taut/base/exceptions.h>
#include <taut/study/comparison.h>

#include <gtest/gtest.h>
#include <structure/devices.h>

#include <cmath>
#include <functional>
#include <string>

namespace taut::study
{
namespace
{
using material::Gent;

const double shear_modulus = 40e3;
const double length = 0.02; ///< undeformed, of each strip (m)
const double stretch_1 = 2, stretch_2 = 4;

material::Elastomer make_elastomer()
{
  material::Elastomer elastomer;
  elastomer.springs = {Gent{0.5 * shear_modulus, 67}};
  for (const double relaxation_time : {0.01, 1., 100.})
    elastomer.networks.push_back(
        {Gent{shear_modulus / 6, 67}, relaxation_time});
  elastomer.dielectric.permittivity = material::ConstantPermittivity{4.7};
  elastomer.dielectric.breakdown_strength = 155e6;
  elastomer.density = 960;
  return elastomer;
}

structure::Film make_strip(const std::string& group)
{
  structure::Film film;
  film.name = film.groups.emplace_back(group);
  film.material = make_elastomer();
  film.thickness = 1e-3;
  film.pre_stretch = {stretch_1, stretch_2};
  return film;
}

structure::EventDescription make_event(const std::string& name,
                                       structure::EventDescription::Kind kind)
{
  structure::EventDescription event;
  event.name = name;
  event.kind = kind;
  event.fatal = true;
  return event;
}

/// The limit R0 of the resonator: rollers at the sides, a guided bar.
Case make_case()
{
  Case result;
  result.file = "resonator.prm";
  auto& device = result.device;
  device.mesh.degree = 1;
  device.films = {make_strip("left"), make_strip("right")};
  device.electrodes = {testing::make_electrode(
      "left", Signal::ramp(9300, 0, std::numeric_limits<double>::infinity()))};
  device.electrodes.back().name = "high voltage";
  device.supports = {testing::make_support("west", {true, true, true}),
                     testing::make_support("east", {true, true, true}),
                     testing::make_support("south", {false, true, false}),
                     testing::make_support("north", {false, true, false}),
                     testing::make_support("film", {false, false, true})};
  structure::RigidBar bar;
  bar.name = "rod";
  bar.groups = {"middle"};
  bar.mass = 0.02;
  bar.free = {true, false, false};
  bar.rotates = false;
  device.bars = {bar};
  device.events = {
      make_event("slack", structure::EventDescription::Kind::tension_loss),
      make_event("spark", structure::EventDescription::Kind::breakdown)};
  result.comparison =
      ComparisonDescription{"left", "right", "high voltage", "rod"};
  result.procedure.analysis = structure::Analysis::quasi_static;
  result.procedure.start = structure::Start::unrelaxed;
  result.procedure.end_time = 2;
  result.procedure.integrator.method = time::Method::bdf;
  result.procedure.integrator.internal_tolerance = 1e-9;
  result.output.history_intervals = 100;
  return result;
}

/// The strips behind one another along x, framed, the left one `ratio` times as
/// long as the right.
fe::MeshData make_mesh(const unsigned int n = 2, const double ratio = 1)
{
  const double right = stretch_1 * length, left = ratio * right;
  return testing::make_grid(
      n, n / 2, 1,
      [=](const double xi, const double eta)
      {
        const double x = xi < 0.5 ? 2 * xi * left : left + (2 * xi - 1) * right;
        return fe::Coordinates{x, eta * stretch_2 * length, 0.};
      });
}

/// A run that nobody watches.
class Silence : public RunOutput
{
public:
  void begin(const std::vector<Column>&) override {}
  void write_row(const std::vector<double>&) override {}
  void write_event(const EventRecord&) override {}
  void write_fields(double, structure::StructureSystem&, const double*) override
  {
  }
  void write_checkpoint(const RunProgress&, structure::StructureSystem&,
                        const double*) override
  {
  }
  void report_step(const time::Step&, const time::IntegratorStatistics&,
                   double) override
  {
  }
  bool wants_checkpoint() override
  {
    return false;
  }
  bool interrupted() override
  {
    return false;
  }
};

Comparison compare(const Case& film_case, const fe::MeshData& mesh)
{
  const auto equivalent = make_resonator_equivalent(film_case, mesh);
  testing::Model model(make_observed_case(film_case, equivalent).device, mesh);
  Silence silence;
  return compare_models(film_case, equivalent, *model.structure, silence);
}

const ComparedQuantity& get(const Comparison& comparison,
                            const std::string& name)
{
  for (const auto& quantity : comparison.quantities)
    if (quantity.name == name)
      return quantity;
  throw std::out_of_range(name);
}

// ------------------------------------------------------------------- reading

TEST(Equivalent, MeasuresLengthsAndReadsTheMaterial)
{
  const auto same = make_resonator_equivalent(make_case(), make_mesh(4, 1.5));
  const auto& resonator = same.resonator;
  EXPECT_NEAR(resonator.length_active, 1.5 * length, 1e-15);
  EXPECT_NEAR(resonator.length_passive, length, 1e-15);
  EXPECT_NEAR(resonator.width, length, 1e-15);
  EXPECT_EQ(resonator.thickness, 1e-3);
  EXPECT_EQ(resonator.pre_stretch, (std::array<double, 2>{2, 4}));
  EXPECT_NEAR(resonator.shear_modulus, shear_modulus, 1e-9);
  EXPECT_NEAR(resonator.equilibrium_share, 0.5, 1e-15);
  ASSERT_EQ(resonator.network_shares.size(), 3u);
  for (const double share : resonator.network_shares)
    EXPECT_NEAR(share, 1. / 6, 1e-15);
  EXPECT_EQ(resonator.relaxation_times, (std::vector<double>{0.01, 1., 100.}));
  EXPECT_EQ(resonator.limit, 67);
  EXPECT_EQ(resonator.density, 960);
  EXPECT_EQ(resonator.bar_mass, 0.02);
  EXPECT_EQ(resonator.relative_permittivity, 4.7);
  EXPECT_EQ(resonator.breakdown_strength, 155e6);
  EXPECT_EQ(resonator.voltage.value(0.5), 4650);
  EXPECT_EQ(same.component, 0u);
  EXPECT_EQ(same.sign, 1);
  EXPECT_EQ(same.end_support, "support of west");
  EXPECT_TRUE(same.ignored.empty());
}

TEST(Equivalent, TurnsTheDirectionWithTheActiveFilm)
{
  Case turned = make_case();
  turned.device.electrodes.front().groups = {"right"};
  turned.comparison->active_film = "right";
  turned.comparison->passive_film = "left";
  const auto same = make_resonator_equivalent(turned, make_mesh());
  EXPECT_EQ(same.sign, -1);
  EXPECT_EQ(same.end_support, "support of east");
}

TEST(Equivalent, TellsWhatTheLumpedModelIgnores)
{
  Case clamped = make_case();
  clamped.device.supports[2].held[0] = true;
  clamped.device.bars[0].rotates = true;
  clamped.device.environment.air_drag = 10;
  EXPECT_EQ(make_resonator_equivalent(clamped, make_mesh()).ignored.size(), 3u);
}

// ------------------------------------------------------------------ refusals

struct Refusal
{
  std::string name;
  std::function<void(Case&)> spoil;
  /// Of the message or the key.
  std::string part;
};

class Refused : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(Refused, NamesWhatTheLumpedModelCannotRepresent)
{
  Case spoiled = make_case();
  GetParam().spoil(spoiled);
  try
  {
    make_resonator_equivalent(spoiled, make_mesh());
    FAIL() << "not refused";
  }
  catch (const BadInput& refusal)
  {
    EXPECT_NE((refusal.key() + ": " + refusal.message()).find(GetParam().part),
              std::string::npos)
        << refusal.what();
  }
}

structure::Film& left(Case& spoiled)
{
  return spoiled.device.films[0];
}

structure::Film& right(Case& spoiled)
{
  return spoiled.device.films[1];
}

const std::vector<Refusal> refusals = {
    {"NoSection", [](Case& c) { c.comparison.reset(); }, "'Comparison'"},
    {"Equilibrium",
     [](Case& c) { c.procedure.analysis = structure::Analysis::equilibrium; },
     "'equilibrium'"},
    {"UnknownFilm", [](Case& c) { c.comparison->active_film = "lefd"; },
     "Film left"},
    {"OneFilmTwice", [](Case& c) { c.comparison->passive_film = "left"; },
     "both 'left'"},
    {"UnknownBar",
     [](Case& c)
     {
       c.comparison->bar = "rid";
       c.device.bars.clear();
     },
     "no bar 'rid'"},
    {"ThirdFilm",
     [](Case& c)
     {
       c.device.films.push_back(make_strip("left"));
       c.device.films.back().name = "third";
     },
     "Film third"},
    {"SecondElectrode",
     [](Case& c)
     { c.device.electrodes.push_back(testing::make_electrode("right", {})); },
     "Electrode electrode of right"},
    {"SecondBar",
     [](Case& c)
     {
       c.device.bars.push_back(c.device.bars[0]);
       c.device.bars.back().name = "second";
     },
     "Bar second"},
    {"OtherSpring",
     [](Case& c)
     { left(c).material.springs = {material::NeoHookean{shear_modulus}}; },
     "only Gent springs"},
    {"OtherNetworkSpring",
     [](Case& c) {
       left(c).material.networks[0].spring =
           material::NeoHookean{shear_modulus};
     },
     "only Gent springs"},
    {"OtherLimit",
     [](Case& c) {
       left(c).material.networks[0].spring = Gent{1e3, 80};
     },
     "67 and 80"},
    {"NoSpring", [](Case& c) { left(c).material.springs.clear(); },
     "always carries"},
    {"StretchPermittivity",
     [](Case& c) {
       left(c).material.dielectric.permittivity =
           material::StretchPermittivity();
     },
     "constant permittivity"},
    {"NoStrength",
     [](Case& c)
     {
       left(c).material.dielectric.breakdown_strength =
           std::numeric_limits<double>::infinity();
     },
     "Breakdown strength"},
    {"OtherThickness", [](Case& c) { right(c).thickness = 2e-3; },
     "one thickness"},
    {"OtherPreStretch",
     [](Case& c) {
       right(c).pre_stretch = {3, 4};
     },
     "one pre-stretch"},
    {"OtherDensity", [](Case& c) { right(c).material.density = 1000; },
     "one density"},
    {"OtherModulus",
     [](Case& c) {
       right(c).material.springs = {Gent{1e3, 67}};
     },
     "one set of springs"},
    {"OtherNetworks",
     [](Case& c) { right(c).material.networks[0].relaxation_time = 3; },
     "one set of networks"},
    {"OtherDielectric",
     [](Case& c)
     {
       right(c).material.dielectric.permittivity =
           material::ConstantPermittivity{3};
     },
     "one dielectric"},
    {"ObliqueAxis",
     [](Case& c) {
       left(c).axis = {1, 1, 0};
     },
     "along x, y or z"},
    {"OtherAxis",
     [](Case& c) {
       right(c).axis = {0, 1, 0};
     },
     "side by side"},
    {"AxisAlongTheBar",
     [](Case& c) {
       left(c).axis = right(c).axis = {0, 1, 0};
     },
     "side by side"},
    {"ElectrodeOnBoth",
     [](Case& c) { c.device.electrodes[0].groups = {"film"}; },
     "covers the whole film 'left'"},
    {"BarElsewhere", [](Case& c) { c.device.bars[0].groups = {"east"}; },
     "line between the films"},
    {"HeldBar",
     [](Case& c) {
       c.device.bars[0].free = {false, true, true};
     },
     "moves along x"},
    {"FreeEnd",
     [](Case& c) { c.device.supports.erase(c.device.supports.begin() + 1); },
     "Film right"},
    {"MovingFrame", [](Case& c) { c.device.supports[0].shape[0] = "0.1*x"; },
     "does not move"},
    {"Pressure",
     [](Case& c)
     {
       c.device.pressures.emplace_back();
       c.device.pressures.back().name = "below";
     },
     "Pressure below"},
    {"EdgeLoad",
     [](Case& c)
     {
       c.device.edge_loads.emplace_back();
       c.device.edge_loads.back().name = "pull";
     },
     "Edge load pull"},
    {"Gravity", [](Case& c) { c.device.environment.gravity[2] = -9.81; },
     "gravity"}};

INSTANTIATE_TEST_SUITE_P(Comparison, Refused, ::testing::ValuesIn(refusals),
                         [](const auto& info) { return info.param.name; });

TEST(Equivalent, RefusesFilmsThatAreNoFlatRectangles)
{
  const auto skewed = testing::make_grid(
      2, 1, 1,
      [](const double xi, const double eta) {
        return fe::Coordinates{0.08 * xi + 0.01 * eta, 0.08 * eta, 0};
      });
  EXPECT_THROW(make_resonator_equivalent(make_case(), skewed), BadInput);
  const auto sloping = testing::make_grid(
      2, 1, 1,
      [](const double xi, const double eta) {
        return fe::Coordinates{0.08 * xi, 0.08 * eta, 0.01 * eta};
      });
  EXPECT_THROW(make_resonator_equivalent(make_case(), sloping), BadInput);
}

// ------------------------------------------------------- limits of the models

/// R0: one affine field per strip. Both models then solve the same equations;
/// what is left is the error of the film's BDF at an internal tolerance of
/// 1e-9 (a few hundred steps).
void expect_same_history(const Comparison& comparison)
{
  EXPECT_GE(comparison.quantities.size(), 9u);
  for (const auto& quantity : comparison.quantities)
    EXPECT_LT(quantity.max_relative_difference, 1e-6) << quantity.name;
}

TEST(Limits, QuasiStaticHistoryAndFailureAgreeWithLoss1)
{
  const auto comparison = compare(make_case(), make_mesh());
  expect_same_history(comparison);
  ASSERT_TRUE(comparison.film_failure && comparison.lumped_failure);
  EXPECT_EQ(comparison.film_failure->kind, "loss of tension along 1");
  EXPECT_EQ(comparison.film_failure->place, "active + passive");
  ASSERT_TRUE(comparison.failure_difference);
  EXPECT_LT(std::abs(comparison.failure_difference->time), 1e-6);
  EXPECT_LT(std::abs(comparison.failure_difference->voltage), 1e-6);
  EXPECT_TRUE(comparison.failure_difference->same_kind);
  EXPECT_TRUE(comparison.failure_difference->same_place);
  // V* = 0.2627 of the reference run with these networks (R-F3, chi = 0.5).
  const double unit =
      1e-3 * std::sqrt(shear_modulus / (4.7 * 8.8541878128e-12));
  EXPECT_NEAR(comparison.film_failure->voltage / unit, 0.2627, 5e-5);
}

TEST(Limits, AFinerMeshChangesNothing)
{
  // The field stays affine whatever the mesh.
  expect_same_history(compare(make_case(), make_mesh(6)));
}

TEST(Limits, UnequalStripsTurnedAroundAgree)
{
  Case turned = make_case();
  turned.device.electrodes.front().groups = {"right"};
  turned.comparison->active_film = "right";
  turned.comparison->passive_film = "left";
  const auto comparison = compare(turned, make_mesh(2, 1.5));
  expect_same_history(comparison);
  ASSERT_TRUE(comparison.failure_difference);
  EXPECT_LT(std::abs(comparison.failure_difference->voltage), 1e-6);
  EXPECT_TRUE(comparison.failure_difference->same_place);
}

TEST(Limits, BreakdownAgrees)
{
  Case weak = make_case();
  for (auto& film : weak.device.films)
    film.material.dielectric.breakdown_strength = 40e6;
  const auto comparison = compare(weak, make_mesh());
  ASSERT_TRUE(comparison.film_failure);
  EXPECT_EQ(comparison.film_failure->kind, "breakdown");
  EXPECT_EQ(comparison.film_failure->place, "active");
  ASSERT_TRUE(comparison.failure_difference);
  EXPECT_LT(std::abs(comparison.failure_difference->voltage), 1e-6);
  EXPECT_TRUE(comparison.failure_difference->same_kind);
  EXPECT_TRUE(comparison.failure_difference->same_place);
}

TEST(Limits, LossOfTensionAcrossAgrees)
{
  // Little stretched across and stiff at once: s_2 of A vanishes first.
  Case narrow = make_case();
  for (auto& film : narrow.device.films)
    film.pre_stretch = {4, 1.2};
  const auto mesh = testing::make_rectangle(2, 1, 1, 0.16, 0.024);
  const auto comparison = compare(narrow, mesh);
  ASSERT_TRUE(comparison.film_failure);
  EXPECT_EQ(comparison.film_failure->kind, "loss of tension along 2");
  EXPECT_EQ(comparison.film_failure->place, "active");
  ASSERT_TRUE(comparison.failure_difference);
  EXPECT_LT(std::abs(comparison.failure_difference->voltage), 1e-6);
  EXPECT_TRUE(comparison.failure_difference->same_place);
}

Case make_motion(const double bar_mass, const double tolerance)
{
  Case motion = make_case();
  motion.device.bars[0].mass = bar_mass;
  motion.device.electrodes[0].voltage = Signal::steps({0, 0.0125}, {0, 4500});
  motion.procedure.analysis = structure::Analysis::transient;
  motion.procedure.start = structure::Start::relaxed;
  motion.procedure.end_time = 0.25;
  motion.procedure.integrator.method = time::Method::esdirk4;
  motion.procedure.integrator.position_tolerance = tolerance;
  return motion;
}

/// R1: one Q1 cell per strip with consistent mass is the lumped model's linear
/// field of velocity.
TEST(Limits, MotionOfOneCellPerStripAgreesToTheIntegratorsTolerance)
{
  // The local error 1e-11 m adds up over some hundred steps; relative to the
  // amplitude of 5 mm that stays below 1e-6, for velocities (not controlled)
  // below 1e-5.
  const auto fine = compare(make_motion(0.02, 1e-11), make_mesh());
  EXPECT_EQ(fine.film_summary.status, Status::completed);
  for (const auto& quantity : fine.quantities)
    EXPECT_LT(quantity.max_relative_difference,
              quantity.name == "bar velocity" ? 1e-5 : 1e-6)
        << quantity.name;
  // The difference is an error of the integrator: it follows the tolerance.
  const auto coarse = compare(make_motion(0.02, 1e-8), make_mesh());
  EXPECT_LT(get(fine, "bar displacement").max_relative_difference,
            0.1 * get(coarse, "bar displacement").max_relative_difference);
}

TEST(Limits, AHeavyBarHidesTheWavesOfTheStripsALightOneDoesNot)
{
  // The strips weigh 0.384 g each. R2: the lumped frequency is too high by
  // 1.7 % at equal masses and by 0.002 % at fifty times that, which after three
  // periods is a phase of 0.32 or 0.0004.
  const auto light = compare(make_motion(0.384e-3, 1e-8), make_mesh(8));
  const auto heavy = compare(make_motion(50 * 0.384e-3, 1e-8), make_mesh(8));
  EXPECT_GT(get(light, "bar displacement").max_relative_difference, 0.05);
  EXPECT_LT(get(heavy, "bar displacement").max_relative_difference, 1e-3);
}
} // namespace
} // namespace taut::study
