// Laws of temperature and humidity, and the options that hold the width of a
// film.
#include <taut/io/formats.h>

#include <cmath>

#include "io/refusal.h"

namespace taut::io
{
namespace
{
using testing::CaseOnDisk;
using testing::edit;
using testing::Refusal;
using testing::small_case;

const char* const laws = R"(  subsection Temperature laws
    set Modulus = polynomial(299, 280, 340; -0.005, 1e-5)
    set Relaxation time = arrhenius(299, 30e3)
    set Heat capacity = 1900
    set Reference temperature = 299
  end
  subsection Dielectric)";

std::string make_thermal_case()
{
  return edit(small_case, "  subsection Dielectric", laws);
}

TEST(TemperatureCase, LawsReachTheirFilms)
{
  const CaseOnDisk disk(make_thermal_case());
  const study::Case read = read_case(disk.file());
  for (const structure::Film& film : read.device.films)
  {
    const auto& law = std::get<material::PolynomialLaw>(film.thermal.modulus);
    EXPECT_EQ(law.reference, 299);
    EXPECT_EQ(law.lowest, 280);
    EXPECT_EQ(law.highest, 340);
    EXPECT_EQ(law.coefficients, (std::vector<double>{-.005, 1e-5}));
    EXPECT_EQ(std::get<material::ArrheniusLaw>(film.thermal.relaxation_time)
                  .activation_energy,
              30e3);
    EXPECT_EQ(film.thermal.heat_capacity, 1900);
    EXPECT_EQ(film.thermal.reference, 299);
  }
}

TEST(TemperatureCase, WithoutLawsNothingDependsOnTheTemperature)
{
  const CaseOnDisk disk(small_case);
  const auto thermal = read_case(disk.file()).device.films[0].thermal;
  EXPECT_TRUE(std::holds_alternative<material::ConstantLaw>(thermal.modulus));
  EXPECT_TRUE(
      std::holds_alternative<material::ConstantLaw>(thermal.relaxation_time));
  EXPECT_EQ(thermal.heat_capacity, 0);
}

TEST(TemperatureCase, WidthIsHeldByFibresAndFlow)
{
  const CaseOnDisk disk(small_case);
  const auto plain = read_case(disk.file()).device.films[0];
  EXPECT_EQ(plain.fibre_modulus, 0);
  EXPECT_EQ(plain.material.networks[0].flow, material::FlowLaw::isotropic);
  const auto held =
      read_case(disk.file(), {"Film left/Fibre modulus = 2e6",
                              "Film left/Tension field = false",
                              "Material rubber/Network slow/Flow = held width"})
          .device.films[0];
  EXPECT_EQ(held.fibre_modulus, 2e6);
  EXPECT_EQ(held.material.networks[0].flow, material::FlowLaw::held_width);
}

TEST(TemperatureLawText, ReadsWhatItWrites)
{
  const Format<material::TemperatureLaw> format = temperature_law();
  for (const std::string text :
       {"constant", "polynomial(299, 280, 340; -0.005, 1e-05)",
        "table(280: 1.1, 300: 1, 350: 0.6)", "arrhenius(299, 30000)"})
    EXPECT_EQ(format.write(format.read(text)), text);
  const auto table =
      std::get<material::TableLaw>(format.read(" table( 280:1.1 ,300 : 1 )"));
  EXPECT_EQ(table.arguments, (std::vector<double>{280, 300}));
  EXPECT_EQ(table.factors, (std::vector<double>{1.1, 1}));
}

TEST(TemperatureLawText, NamedLawsAreThoseOfTheDocumentation)
{
  const Format<material::TemperatureLaw> format = temperature_law();
  const auto compute = [&](const char* name, const double temperature)
  { return material::compute_factor(format.read(name), temperature); };
  EXPECT_DOUBLE_EQ(compute("wang_2024_modulus", 320), 1 - .005 * 21);
  EXPECT_DOUBLE_EQ(compute("wang_2024_frame_modulus", 320), 1 - .006 * 21);
  // Relaxation numbers .03 and .0136 at 299 and 320 K.
  EXPECT_NEAR(.03 * compute("wang_2024_relaxation", 320), .0136, 5e-5);
}

class BadTemperatureCase : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(BadTemperatureCase, IsRefusedWithFileLineAndKey)
{
  testing::expect_refused(make_thermal_case(), GetParam());
}

const char* const modulus = "Material rubber/Temperature laws/Modulus";
const char* const polynomial = "polynomial(299, 280, 340; -0.005, 1e-5)";

const Refusal refusals[] = {
    {"temperature outside", "  set Pre-stretch = 2, 4",
     "  set Pre-stretch = 2, 4\n  set Temperature = 350", "set Temperature",
     "Film left/Temperature", "from 280 K to 340 K"},
    {"temperature that leaves the range", "  set Pre-stretch = 2, 4",
     "  set Pre-stretch = 2, 4\n  set Temperature = table(0: 300, 1: 270)",
     "set Temperature", "Film left/Temperature", "reaches"},
    {"default temperature outside", polynomial,
     "polynomial(350, 340, 360; -0.005)", "subsection Film left",
     "Film left/Temperature", "293.15 K"},
    {"temperature outside of the other law", "arrhenius(299, 30e3)",
     "table(295: 1, 340: 0.5)", "subsection Film left", "Film left/Temperature",
     "Relaxation time"},
    {"unknown law", polynomial, "polinomial(299, 280, 340; 1)", "polinomial",
     modulus, "did you mean 'polynomial'"},
    {"number", polynomial, "0.9", "set Modulus = 0.9", modulus, "allowed are"},
    {"no brackets", polynomial, "polynomial", "set Modulus", modulus,
     "brackets"},
    {"no coefficients", polynomial, "polynomial(299, 280, 340)", "set Modulus",
     modulus, "';'"},
    {"two temperatures", polynomial, "polynomial(299, 280; 1)", "set Modulus",
     modulus, "three values of the temperature"},
    {"range downwards", polynomial, "polynomial(299, 340, 280; -0.005)",
     "set Modulus", modulus, "upwards"},
    {"no number", polynomial, "polynomial(299, 280, 340; warm)", "set Modulus",
     modulus, "'warm' is not a finite number"},
    {"factor that vanishes", polynomial, "polynomial(299, 280, 340; -0.03)",
     "set Modulus", modulus, "must be positive"},
    {"table of one row", polynomial, "table(280: 1)", "set Modulus", modulus,
     "two rows"},
    {"table without a colon", polynomial, "table(280, 1)", "set Modulus",
     modulus, "'temperature: factor'"},
    {"table downwards", polynomial, "table(300: 1, 280: 1.1)", "set Modulus",
     modulus, "must increase"},
    {"negative factor", polynomial, "table(280: 1, 300: -1)", "set Modulus",
     modulus, "positive"},
    {"arrhenius without energy", polynomial, "arrhenius(299)", "set Modulus",
     modulus, "activation"},
    {"negative heat capacity", "Heat capacity = 1900", "Heat capacity = -1",
     "Heat capacity", "Material rubber/Temperature laws/Heat capacity",
     "0 or more"},
    {"reference at zero", "Reference temperature = 299",
     "Reference temperature = 0", "Reference temperature",
     "Material rubber/Temperature laws/Reference temperature", "above 0"},
    {"negative fibres", "  set Pre-stretch = 2, 4",
     "  set Pre-stretch = 2, 4\n  set Fibre modulus = -1", "Fibre modulus",
     "Film left/Fibre modulus", "0 or more"},
    {"unknown flow", "    set Relaxation time = 100",
     "    set Relaxation time = 100\n    set Flow = held", "set Flow",
     "Material rubber/Network slow/Flow", "held width"}};
INSTANTIATE_TEST_SUITE_P(Temperature, BadTemperatureCase,
                         ::testing::ValuesIn(refusals));

const char* const humidity_laws = R"(  subsection Humidity laws
    set Modulus = polynomial(0.5, 0.2, 0.9; -0.3)
    set Relaxation time = exponential(0.5, -2)
    set Permittivity = table(0: 1, 1: 1.6)
  end
  subsection Dielectric)";

std::string make_humid_case()
{
  const std::string with_laws =
      edit(small_case, "  subsection Dielectric", humidity_laws);
  const std::string with_left =
      edit(with_laws, "  set Pre-stretch = 2, 4",
           "  set Pre-stretch = 2, 4\n  set Humidity = table(0: 0.2, 1: 0.8)");
  return edit(with_left, "  set Surfaces = right",
              "  set Surfaces = right\n  set Humidity = 0.5");
}

TEST(HumidityCase, LawsReachTheirFilms)
{
  const CaseOnDisk disk(make_humid_case());
  const structure::Film film = read_case(disk.file()).device.films[0];
  EXPECT_EQ(film.humidity.value(.5), .5);
  const auto& laws = film.humidity_laws;
  EXPECT_DOUBLE_EQ(material::compute_factor(laws.modulus, .7), 1 - .3 * .2);
  EXPECT_DOUBLE_EQ(material::compute_factor(laws.relaxation_time, .7),
                   std::exp(-2 * (.7 - .5)));
  EXPECT_DOUBLE_EQ(material::compute_factor(laws.permittivity, .5), 1.3);
}

TEST(HumidityLawText, ReadsWhatItWrites)
{
  const Format<material::HumidityLaw> format = humidity_law();
  for (const std::string text :
       {"constant", "polynomial(0.5, 0, 1; -0.3, 0.1)", "table(0: 1, 0.5: 0.8)",
        "exponential(0.5, -2)"})
    EXPECT_EQ(format.write(format.read(text)), text);
}

class BadHumidityCase : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(BadHumidityCase, IsRefusedWithFileLineAndKey)
{
  testing::expect_refused(make_humid_case(), GetParam());
}

const char* const wet_modulus = "Material rubber/Humidity laws/Modulus";
const char* const wet_polynomial = "polynomial(0.5, 0.2, 0.9; -0.3)";

const Refusal humidity_refusals[] = {
    {"humidity above 1", "set Humidity = 0.5", "set Humidity = 50",
     "set Humidity = 50", "Film right/Humidity", "reaches 50"},
    {"humidity below 0", "table(0: 0.2, 1: 0.8)", "table(0: 0.2, 1: -0.1)",
     "set Humidity = table", "Film left/Humidity", "from 0.2 to 0.9"},
    {"humidity outside of the law", "table(0: 0.2, 1: 0.8)",
     "table(0: 0.2, 1: 0.95)", "set Humidity = table", "Film left/Humidity",
     "the law of the Modulus"},
    {"law beyond 1", wet_polynomial, "polynomial(0.5, 0.2, 90; -0.001)",
     "set Modulus", wet_modulus, "must lie from 0 to 1"},
    {"table beyond 1", "table(0: 1, 1: 1.6)", "table(0: 1, 100: 1.6)",
     "set Permittivity = table", "Material rubber/Humidity laws/Permittivity",
     "must lie from 0 to 1"},
    {"law of temperature", wet_polynomial, "arrhenius(299, 30e3)",
     "set Modulus", wet_modulus, "no law of humidity"},
    {"exponential without coefficient", "exponential(0.5, -2)",
     "exponential(0.5)", "set Relaxation time = exp",
     "Material rubber/Humidity laws/Relaxation time",
     "a reference and a coefficient"},
    {"exponential with a reference in percent", "exponential(0.5, -2)",
     "exponential(50, -2)", "set Relaxation time = exp",
     "Material rubber/Humidity laws/Relaxation time", "must lie from 0 to 1"}};
INSTANTIATE_TEST_SUITE_P(Humidity, BadHumidityCase,
                         ::testing::ValuesIn(humidity_refusals));

const char* const activated = R"(    set Relaxation time = 100
    set Relaxation law = stress-activated
    set Activation stress = 3e4
  end
  subsection Fibre family weft
    set Law = exponential
    set Stiffness = 5e3
    set Exponent = 0.01
    set Angle = 0.5
    set Dispersion = 0.1
  end
  subsection Fibre family warp
    set Law = quadratic
    set Stiffness = 2e3
    set Tension only = false
    set Rest stretch = 4)";

std::string make_activated_case()
{
  return edit(small_case, "    set Relaxation time = 100", activated);
}

TEST(NotConstantLaws, ReachTheirFilms)
{
  const CaseOnDisk disk(make_activated_case());
  const material::Elastomer elastomer =
      read_case(disk.file()).device.films[0].material;
  EXPECT_EQ(std::get<material::StressActivatedRelaxation>(
                elastomer.networks[0].relaxation)
                .activation_stress,
            3e4);
  ASSERT_EQ(elastomer.fibres.size(), 2u);
  const material::FibreFamily& weft = elastomer.fibres[0];
  EXPECT_EQ(std::get<material::ExponentialFibres>(weft.law).stiffness, 5e3);
  EXPECT_EQ(std::get<material::ExponentialFibres>(weft.law).exponent, .01);
  EXPECT_DOUBLE_EQ(weft.direction[0], std::cos(.5));
  EXPECT_DOUBLE_EQ(weft.direction[1], std::sin(.5));
  EXPECT_EQ(weft.dispersion, .1);
  EXPECT_TRUE(weft.tension_only);
  const material::FibreFamily& warp = elastomer.fibres[1];
  EXPECT_EQ(std::get<material::QuadraticFibres>(warp.law).stiffness, 2e3);
  EXPECT_FALSE(warp.tension_only);
  EXPECT_EQ(warp.rest_stretch, 4);
  const CaseOnDisk other(
      edit(edit(make_activated_case(), "stress-activated", "stretch-activated"),
           "Activation stress = 3e4", "Activation coefficient = 0.4"));
  EXPECT_EQ(
      std::get<material::StretchActivatedRelaxation>(read_case(other.file())
                                                         .device.films[0]
                                                         .material.networks[0]
                                                         .relaxation)
          .coefficient,
      .4);
}

class BadLawCase : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(BadLawCase, IsRefusedWithFileLineAndKey)
{
  testing::expect_refused(make_activated_case(), GetParam());
}

const Refusal law_refusals[] = {
    {"unknown relaxation law", "= stress-activated", "= stress",
     "set Relaxation law", "Material rubber/Network slow/Relaxation law",
     "stress-activated"},
    {"activation stress of zero", "Activation stress = 3e4",
     "Activation stress = 0", "set Activation stress",
     "Material rubber/Network slow/Activation stress", "above 0"},
    {"activation of a held width", "    set Activation stress = 3e4",
     "    set Activation stress = 3e4\n    set Flow = held width",
     "subsection Material rubber", "Material rubber", "held width is constant"},
    {"unknown fibres", "Law = quadratic", "Law = cubic", "set Law = cubic",
     "Material rubber/Fibre family warp/Law", "quadratic"},
    {"fibres without stiffness", "Stiffness = 2e3", "Stiffness = 0",
     "set Stiffness = 0", "Material rubber/Fibre family warp/Stiffness",
     "above 0"},
    {"dispersion above a third", "Dispersion = 0.1", "Dispersion = 0.5",
     "set Dispersion", "Material rubber/Fibre family weft/Dispersion",
     "from 0 to 0.333"},
    {"dispersed fibres with a rest stretch", "    set Dispersion = 0.1",
     "    set Dispersion = 0.1\n    set Rest stretch = 2",
     "subsection Material rubber", "Material rubber", "dispersed"},
    {"pre-stretch beyond an exponent", "Exponent = 0.01", "Exponent = 3",
     "set Pre-stretch = 2, 4", "Film left/Pre-stretch", "fibre family"}};
INSTANTIATE_TEST_SUITE_P(Laws, BadLawCase, ::testing::ValuesIn(law_refusals));
} // namespace
} // namespace taut::io
