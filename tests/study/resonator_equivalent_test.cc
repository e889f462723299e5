#include <taut/base/exceptions.h>
#include <taut/study/resonator_equivalent.h>

#include <gtest/gtest.h>
#include <study/resonator_case.h>

#include <functional>
#include <limits>
#include <string>

namespace taut::study
{
namespace
{
using material::Gent;
using testing::length;
using testing::make_case;
using testing::make_mesh;
using testing::make_strip;
using testing::shear_modulus;

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
    {"Circuit",
     [](Case& c)
     {
       auto& electrode = c.device.electrodes[0];
       electrode.control = structure::Electrode::Control::circuit;
     },
     "Control = voltage"},
    {"NoSection", [](Case& c) { c.comparison.reset(); }, "'Comparison'"},
    {"Equilibrium",
     [](Case& c) { c.procedure.analysis = structure::Analysis::equilibrium; },
     "no static analysis"},
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
    {"RelaxationLaw",
     [](Case& c)
     {
       left(c).material.networks[0].relaxation =
           material::StretchActivatedRelaxation{.5};
     },
     "constant relaxation times"},
    {"FibreFamily",
     [](Case& c)
     { left(c).material.fibres = {{material::QuadraticFibres{1e3}}}; },
     "no fibres"},
    {"HumidityLaws",
     [](Case& c) {
       left(c).humidity_laws.modulus = material::ExponentialLaw{.5, -1};
     },
     "no humidity"},
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
       left(c).material.dielectric.breakdown.reference =
           std::numeric_limits<double>::infinity();
     },
     "Breakdown strength"},
    {"StrengthThatFollowsALaw",
     [](Case& c)
     {
       left(c).material.dielectric.breakdown.factors = {
           material::StretchStrength{.6, {1, 6}}};
     },
     "constant breakdown strength"},
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
} // namespace
} // namespace taut::study
