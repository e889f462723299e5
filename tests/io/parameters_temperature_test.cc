// Laws of temperature, and the options that hold the width of a film.
#include <taut/io/formats.h>

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
  EXPECT_EQ(table.temperatures, (std::vector<double>{280, 300}));
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
     modulus, "three temperatures"},
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
} // namespace
} // namespace taut::io
