#include <taut/base/exceptions.h>
#include <taut/study/demes_equivalent.h>

#include <gtest/gtest.h>
#include <study/demes_case.h>

#include <functional>
#include <string>

namespace taut::study
{
namespace
{
using testing::Bow;
using testing::make_demes_case;
using testing::make_demes_mesh;

DemesEquivalent make(const Case& film_case, const Bow& bow = {})
{
  return make_demes_equivalent(film_case, make_demes_mesh(bow));
}

bool ignores(const DemesEquivalent& equivalent, const std::string& what)
{
  for (const std::string& ignored : equivalent.ignored)
    if (ignored.find(what) != std::string::npos)
      return true;
  return false;
}

TEST(DemesEquivalent, ParametersAreThoseOfTheDevice)
{
  Bow bow;
  bow.stand_off = 0.01;
  const auto equivalent = make(make_demes_case(bow, 1), bow);
  const lumped::DemesSI& device = equivalent.device;
  EXPECT_NEAR(device.film_length, 0.02, 1e-12);
  EXPECT_NEAR(device.film_width, 0.04, 1e-12);
  EXPECT_DOUBLE_EQ(device.film_thickness, 5e-4);
  EXPECT_DOUBLE_EQ(device.pre_stretch, 2);
  EXPECT_DOUBLE_EQ(device.shear_modulus, bow.modulus);
  EXPECT_DOUBLE_EQ(device.viscous_ratio, 2.5);
  EXPECT_DOUBLE_EQ(device.viscosity, 2.5 * bow.modulus * 3.82e-4);
  EXPECT_DOUBLE_EQ(device.relative_permittivity, 2.1 + 960. / 299);
  EXPECT_DOUBLE_EQ(device.inertia, 2 * testing::end_inertia);
  EXPECT_NEAR(device.film_offset, 0.01, 1e-12);
  EXPECT_DOUBLE_EQ(equivalent.bending_stiffness, bow.bending_stiffness());
  // K = 4 EI / (C mu V_0), epsilon = 2 h / C.
  const lumped::Demes arc = equivalent.make_arc();
  EXPECT_NEAR(arc.frame_stiffness, bow.stiffness_number, 1e-12);
  EXPECT_NEAR(arc.eccentricity, 0.5, 1e-12);
  EXPECT_NEAR(equivalent.make_elastica().standoff, 0.25, 1e-12);
}

TEST(DemesEquivalent, OffsetsOfTheFrameAreStandOffs)
{
  Case glued = make_demes_case({}, 1);
  glued.device.frames[0].offset = 2e-4;
  EXPECT_NEAR(make(glued).device.film_offset, 2e-4, 1e-12);
}

TEST(DemesEquivalent, ValuesAreThoseAtTheTemperature)
{
  Case warm = make_demes_case({}, 1);
  const material::PolynomialLaw softer{299, {-0.005}, 260, 365};
  warm.device.films[0].temperature = Signal::constant(319);
  warm.device.films[0].thermal.modulus = softer;
  warm.device.frames[0].temperature = Signal::constant(309);
  warm.device.frames[0].modulus_law = softer;
  const auto equivalent = make(warm);
  EXPECT_NEAR(equivalent.device.shear_modulus, 0.9 * Bow().modulus, 1e-8);
  EXPECT_NEAR(equivalent.device.viscosity, 0.9 * 2.5 * Bow().modulus * 3.82e-4,
              1e-10);
  EXPECT_NEAR(equivalent.bending_stiffness, 0.95 * Bow().bending_stiffness(),
              1e-12);
  EXPECT_DOUBLE_EQ(equivalent.device.relative_permittivity, 2.1 + 960. / 319);
}

TEST(DemesEquivalent, AnElasticFilmHasNoViscousBranch)
{
  Case elastic = make_demes_case({}, 1);
  elastic.device.films[0].material.networks.clear();
  EXPECT_EQ(make(elastic).device.viscous_ratio, 0);
}

TEST(DemesEquivalent, WhatTheModelsIgnoreIsNamed)
{
  Case other = make_demes_case({}, 1);
  EXPECT_FALSE(ignores(make(other), "width of the film is free"));
  EXPECT_FALSE(ignores(make(other), "wrinkles"));
  EXPECT_FALSE(ignores(make(other), "ends have mass"));
  other.device.supports.erase(other.device.supports.begin());
  other.device.films[0].tension_field = true;
  other.device.bodies[0].mass = 1e-3;
  EXPECT_TRUE(ignores(make(other), "width of the film is free"));
  EXPECT_TRUE(ignores(make(other), "wrinkles"));
  EXPECT_TRUE(ignores(make(other), "ends have mass"));
  EXPECT_TRUE(ignores(make(other), "film has mass"));
  EXPECT_TRUE(ignores(make(other), "frame has mass"));
}

struct Refusal
{
  std::string what;
  std::function<void(Case&)> spoil;
  std::string key, message;
};

class DemesRefused : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(DemesRefused, ByName)
{
  Case film_case = make_demes_case({}, 1);
  GetParam().spoil(film_case);
  try
  {
    make(film_case);
    FAIL() << "accepted";
  }
  catch (const BadInput& error)
  {
    EXPECT_EQ(error.key(), GetParam().key);
    EXPECT_NE(std::string(error.what()).find(GetParam().message),
              std::string::npos)
        << error.what();
  }
}

structure::Film& film(Case& film_case)
{
  return film_case.device.films[0];
}

structure::Frame& leg(Case& film_case)
{
  return film_case.device.frames[0];
}

template <class Entry>
Entry named(const std::string& name)
{
  Entry entry;
  entry.name = name;
  return entry;
}

const std::vector<Refusal> refusals = {
    {"Charge",
     [](Case& c)
     {
       auto& electrode = c.device.electrodes[0];
       electrode.control = structure::Electrode::Control::charge;
     },
     "Electrode electrode of film", "Control = voltage"},
    {"TwoNetworks",
     [](Case& c)
     {
       auto& networks = film(c).material.networks;
       networks.push_back(networks[0]);
     },
     "Film film", "one network at most"},
    {"GentSpring",
     [](Case& c) {
       film(c).material.springs = {material::Gent{1e5, 50}};
     },
     "Film film", "only neo-Hookean"},
    {"GentNetwork",
     [](Case& c) {
       film(c).material.networks[0].spring = material::Gent{1e5, 50};
     },
     "Film film", "only neo-Hookean"},
    {"NoSpring", [](Case& c) { film(c).material.springs.clear(); }, "Film film",
     "always carries"},
    {"StretchedAcross", [](Case& c) { film(c).pre_stretch[1] = 2; },
     "Film film", "second pre-stretch must be 1"},
    {"ChangingTemperature",
     [](Case& c) { film(c).temperature = Signal::ramp(1, 0, 400); },
     "Film film", "one temperature"},
    {"TemperatureOutsideOfALaw",
     [](Case& c) {
       film(c).thermal.modulus =
           material::PolynomialLaw{350, {-0.005}, 340, 365};
     },
     "Film film", "340"},
    {"ChangingHumidity",
     [](Case& c) { film(c).humidity = Signal::ramp(.1, 0, 1); }, "Film film",
     "one humidity"},
    {"HumidityOutsideOfALaw",
     [](Case& c)
     {
       film(c).humidity_laws.modulus =
           material::PolynomialLaw{.5, {-0.1}, .2, .9};
     },
     "Film film", "0.2"},
    {"RelaxationLaw",
     [](Case& c)
     {
       film(c).material.networks[0].relaxation =
           material::StretchActivatedRelaxation{.5};
     },
     "Film film", "constant relaxation times"},
    {"FibreFamily",
     [](Case& c)
     { film(c).material.fibres = {{material::QuadraticFibres{1e3}}}; },
     "Film film", "no fibres"},
    {"SecondFilm",
     [](Case& c) { c.device.films.push_back(named<structure::Film>("other")); },
     "Film other", "no place for it"},
    {"Hinge",
     [](Case& c)
     { c.device.hinges.push_back(named<structure::Hinge>("knee")); },
     "Hinge knee", "no place for it"},
    {"Bar",
     [](Case& c)
     { c.device.bars.push_back(named<structure::RigidBar>("rod")); },
     "Bar rod", "no place for it"},
    {"PointLoad",
     [](Case& c)
     { c.device.point_loads.push_back(named<structure::PointLoad>("push")); },
     "Point load push", "no place for it"},
    {"ThirdBody",
     [](Case& c)
     { c.device.bodies.push_back(named<structure::RigidBody>("tip")); },
     "Rigid body tip", "no place for it"},
    {"FlexibleBar",
     [](Case& c)
     {
       auto frame = named<structure::Frame>("strut");
       frame.groups = {"middle"};
       c.device.frames.push_back(frame);
     },
     "Frame strut", "neither one of the Legs"},
    {"Gravity", [](Case& c) { c.device.environment.gravity[2] = -9.81; },
     "Environment", "no gravity"},
    {"MovingSupport", [](Case& c) { c.device.supports[0].shape[1] = "x"; },
     "Support support of film", "does not move"},
    {"WeightlessEnds",
     [](Case& c) {
       c.device.bodies[0].rotary_inertia = {0, 0, 0};
     },
     "Rigid body west", "rotary inertia"},
    {"EdgewiseLegs",
     [](Case& c) {
       leg(c).normal = {0, 1, 0};
     },
     "Frame frame on beam", "Normal"},
    {"LegsAcross", [](Case& c) { leg(c).groups = {"west"}; },
     "Frame frame on beam", "straight and as long"},
    {"ShortElectrode",
     [](Case& c) { c.device.electrodes[0].groups = {"left"}; },
     "Electrode electrode of film", "whole film"},
    {"QuasiStatic",
     [](Case& c) { c.procedure.analysis = structure::Analysis::quasi_static; },
     "Procedure/Analysis", "transient"},
    {"Unrelaxed",
     [](Case& c) { c.procedure.start = structure::Start::unrelaxed; },
     "Procedure/Start", "relaxed"},
    {"FromFlat", [](Case& c) { c.procedure.shape = Shape::meshed; },
     "Procedure/Start shape", "start at rest"},
    {"AngleOfAnotherQuantity",
     [](Case& c) { c.demes_comparison->angle_probe = "chord"; }, "Probe chord",
     "as Angle probe"},
    {"ChordOfAnotherQuantity",
     [](Case& c) { c.demes_comparison->chord_probe = "angle"; }, "Probe angle",
     "as Chord probe"},
    {"StretchOfAnotherQuantity",
     [](Case& c) { c.demes_comparison->stretch_probe = "angle"; },
     "Probe angle", "as Stretch probe"},
    {"NoSuchProbe", [](Case& c) { c.demes_comparison->angle_probe = "angel"; },
     "Comparison", "did you mean 'angle'"},
    {"NoSuchLegs", [](Case& c) { c.demes_comparison->legs = {"legs"}; },
     "Frame frame on beam", "neither one of the Legs"},
    {"NoSuchBody", [](Case& c) { c.demes_comparison->left_body = "wset"; },
     "Rigid body west", "no place for it"},
    {"NoLegs",
     [](Case& c)
     {
       c.demes_comparison->legs.clear();
       c.device.frames.clear();
     },
     "Comparison", "needs Legs"}};

INSTANTIATE_TEST_SUITE_P(Cases, DemesRefused, ::testing::ValuesIn(refusals),
                         [](const auto& info) { return info.param.what; });
} // namespace
} // namespace taut::study
