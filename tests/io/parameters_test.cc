#include <taut/base/exceptions.h>
#include <taut/io/case_sections.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "io/small_case.h"

namespace taut::io
{
namespace
{
using testing::CaseOnDisk;
using testing::small_case;

TEST(Parameters, EveryValueArrivesInItsPlace)
{
  const CaseOnDisk disk(small_case);
  const study::Case read = read_case(disk.file());
  const structure::Device& device = read.device;
  EXPECT_EQ(read.model, "film");
  EXPECT_EQ(device.title, "small");
  EXPECT_EQ(device.mesh.file, (disk.folder() / "meshes/two.geo").string());
  EXPECT_EQ(device.mesh.source_line, 3u);
  EXPECT_EQ(device.mesh.geo_parameters.at("width"), 0.02);
  EXPECT_EQ(device.mesh.geo_parameters.at("cells"), 4);
  ASSERT_EQ(device.films.size(), 2u);
  const structure::Film& film = device.films[0];
  EXPECT_EQ(film.name, "left");
  EXPECT_EQ(film.source_line, 23u);
  EXPECT_EQ(film.groups, std::vector<std::string>{"left"});
  EXPECT_EQ(film.thickness, 1e-3);
  EXPECT_EQ(film.pre_stretch, (std::array<double, 2>{{2, 4}}));
  EXPECT_EQ(device.electrodes.at(0).voltage.value(0.5), 2500);
  EXPECT_EQ(device.supports.at(0).shape[0], "0.1*sin(pi*y)");
  EXPECT_EQ(device.supports.at(0).amplitude.value(0.25), 0.25);
  EXPECT_EQ(device.bars.at(0).mass, 0.02);
  EXPECT_FALSE(device.bars.at(0).rotary_inertia);
  EXPECT_EQ(device.pressures.at(0).pressure.value(7), 10);
  EXPECT_EQ(device.edge_loads.at(0).direction[2], 1);
  EXPECT_EQ(device.edge_loads.at(0).force.value(0), 3);
  EXPECT_EQ(device.probes.at(0).kind, structure::Probe::Kind::displacement);
  EXPECT_EQ(device.probes.at(0).point[1], 0.01);
  EXPECT_EQ(device.probes.at(0).component, 2u);
  EXPECT_EQ(device.probes.at(1).of, "middle");
  EXPECT_EQ(device.events.at(1).threshold, 1e-3);
  EXPECT_FALSE(device.events.at(1).fatal);
  EXPECT_EQ(device.environment.gravity[2], -9.81);
  EXPECT_EQ(read.procedure.end_time, 2);
  EXPECT_EQ(read.procedure.integrator.first_step, 1e-5);
  EXPECT_EQ(read.output.history_times, (std::vector<double>{0.5, 1.5}));
  ASSERT_TRUE(read.comparison);
  EXPECT_EQ(read.comparison->passive_film, "right");
}

TEST(Parameters, FilmsReceiveTheMaterialTheyName)
{
  const CaseOnDisk disk(small_case);
  const material::Elastomer elastomer =
      read_case(disk.file()).device.films.at(1).material;
  EXPECT_EQ(elastomer.density, 1000);
  ASSERT_EQ(elastomer.springs.size(), 1u);
  const auto& gent = std::get<material::Gent>(elastomer.springs[0]);
  EXPECT_EQ(gent.shear_modulus, 20e3);
  EXPECT_EQ(gent.limit, 67);
  ASSERT_EQ(elastomer.networks.size(), 1u);
  EXPECT_EQ(elastomer.networks[0].relaxation_time, 100);
  EXPECT_EQ(std::get<material::NeoHookean>(elastomer.networks[0].spring)
                .shear_modulus,
            10e3);
  EXPECT_EQ(elastomer.dielectric.breakdown.reference, 1e8);
  EXPECT_EQ(std::get<material::ConstantPermittivity>(
                elastomer.dielectric.permittivity)
                .relative,
            4.7);
}

TEST(Parameters, WrinklesAndTheirEvents)
{
  const auto read = [](const std::string& from, const std::string& to)
  {
    std::string content = small_case;
    content.replace(content.find(from), from.size(), to);
    const CaseOnDisk disk(content);
    return read_case(disk.file()).device;
  };
  const std::string thickness = "  set Thickness = 1e-3\n";
  const auto films =
      read(thickness, thickness + "  set Tension field = false\n").films;
  EXPECT_FALSE(films.at(0).tension_field);
  EXPECT_TRUE(films.at(1).tension_field);
  using Kind = structure::EventDescription::Kind;
  EXPECT_EQ(read("tension loss", "wrinkling").events.at(0).kind,
            Kind::wrinkling);
  EXPECT_EQ(read("tension loss", "slackness").events.at(0).kind,
            Kind::slackness);
}

TEST(Parameters, EveryLawCanBeSelected)
{
  const auto read_spring = [](const std::string& lines)
  {
    std::string content = small_case;
    const std::string gent = "    set Law = Gent\n"
                             "    set Shear modulus = 20e3\n"
                             "    set Limit = 67\n";
    content.replace(content.find(gent), gent.size(), lines);
    const CaseOnDisk disk(content);
    return read_case(disk.file()).device.films.at(0).material.springs.at(0);
  };
  const auto mooney = std::get<material::MooneyRivlin>(
      read_spring("set Law = Mooney-Rivlin\nset First coefficient = 9e3\n"
                  "set Second coefficient = 1e3\n"));
  EXPECT_EQ(mooney.first_coefficient, 9e3);
  EXPECT_EQ(mooney.second_coefficient, 1e3);
  const auto yeoh = std::get<material::Yeoh>(
      read_spring("set Law = Yeoh\nset First coefficient = 9e3\n"
                  "set Second coefficient = -10\n"
                  "set Third coefficient = 0.5\n"));
  EXPECT_EQ(yeoh.second_coefficient, -10);
  EXPECT_EQ(yeoh.third_coefficient, 0.5);
  const auto chains = std::get<material::ArrudaBoyce>(
      read_spring("set Law = Arruda-Boyce\nset Shear modulus = 2e4\n"
                  "set Limit stretch = 6\n"));
  EXPECT_EQ(chains.limit_stretch, 6);
}

TEST(Parameters, StretchDependentPermittivityKeepsItsDefaults)
{
  std::string content = small_case;
  const std::string constant = "    set Relative permittivity = 4.7\n";
  content.replace(content.find(constant), constant.size(),
                  "    set Permittivity = stretch-dependent\n"
                  "    set Linear coefficient = -0.2\n");
  const CaseOnDisk disk(content);
  const auto law = std::get<material::StretchPermittivity>(
      read_case(disk.file())
          .device.films.at(0)
          .material.dielectric.permittivity);
  EXPECT_EQ(law.linear, -0.2);
  EXPECT_EQ(law.dipole, material::StretchPermittivity().dipole);
}

/// What a case says, as one text: its effective parameters.
std::string effective(const std::string& file)
{
  return read_case_file(file).effective_parameters;
}

TEST(Parameters, EffectiveParametersReadBackAsTheSameCase)
{
  for (const std::string name : {"ideal", "clamped", "lumped"})
  {
    const std::string file =
        std::string(TAUT_CASES) + "/resonator/" + name + ".prm";
    const std::string first = effective(file);
    const CaseOnDisk copy(first);
    EXPECT_EQ(effective(copy.file()), first) << name;
  }
  const CaseOnDisk original(small_case);
  const CaseOnDisk copy(effective(original.file()));
  const study::Case first = read_case(original.file());
  const study::Case second = read_case(copy.file());
  EXPECT_EQ(second.device.mesh.file, first.device.mesh.file);
  EXPECT_EQ(second.device.probes[0].point, first.device.probes[0].point);
  EXPECT_EQ(second.device.supports[0].amplitude.to_text(),
            first.device.supports[0].amplitude.to_text());
  EXPECT_EQ(second.procedure.integrator.position_tolerance,
            first.procedure.integrator.position_tolerance);
}

TEST(Parameters, ResonatorCasesDescribeTheSameDevice)
{
  const std::string folder = std::string(TAUT_CASES) + "/resonator/";
  const study::Case film = read_case(folder + "ideal.prm");
  const study::LumpedResonatorDescription lumped =
      read_case(folder + "lumped.prm").lumped_resonator;
  const structure::Device& device = film.device;
  ASSERT_TRUE(film.comparison);
  const material::Elastomer& elastomer = device.films.at(0).material;
  EXPECT_EQ(lumped.density, elastomer.density);
  EXPECT_EQ(lumped.thickness, device.films[0].thickness);
  EXPECT_EQ(lumped.pre_stretch, device.films[0].pre_stretch);
  EXPECT_EQ(lumped.bar_mass, device.bars.at(0).mass);
  EXPECT_EQ(lumped.voltage.value(0.7),
            device.electrodes.at(0).voltage.value(0.7));
  double modulus = 0;
  for (const material::Spring& spring : elastomer.springs)
    modulus += std::get<material::Gent>(spring).shear_modulus;
  EXPECT_DOUBLE_EQ(modulus, lumped.equilibrium_share * lumped.shear_modulus);
  for (const material::Network& network : elastomer.networks)
    modulus += std::get<material::Gent>(network.spring).shear_modulus;
  EXPECT_DOUBLE_EQ(modulus, lumped.shear_modulus);
  // The ramp is 0.3/s in units of H sqrt(G/(eps0 eps_r)), to the digits given.
  const double unit =
      lumped.thickness *
      std::sqrt(lumped.shear_modulus /
                (material::vacuum_permittivity * lumped.relative_permittivity));
  EXPECT_NEAR(lumped.voltage.value(1) / unit, 0.3, 1e-9);
}

TEST(Parameters, ChangedParametersAreThoseThatDifferFromTheirDefaults)
{
  const CaseOnDisk disk(small_case);
  const CaseFile file =
      read_case_file(disk.file(), {"Procedure/Newton tolerance = 0.1e-9",
                                   "Output/Field intervals = 5"});
  const auto find = [&file](const std::string& path)
  {
    for (const ChangedParameter& changed : file.changed_parameters)
      if (changed.path == path)
        return changed.default_value + " -> " + changed.value;
    return std::string("unchanged");
  };
  EXPECT_EQ(find("Procedure/End time"), "1 -> 2");
  EXPECT_EQ(find("Output/Field intervals"), "20 -> 5");
  EXPECT_EQ(find("Film left/Thickness"), " -> 1e-3");
  EXPECT_EQ(find("Procedure/Load steps"), "unchanged");
  // The default in another spelling.
  EXPECT_EQ(find("Procedure/Newton tolerance"), "unchanged");
}

TEST(Parameters, OverridesReplaceAndAdd)
{
  const CaseOnDisk disk(small_case);
  const study::Case read =
      read_case(disk.file(),
                {"Film left/Thickness = 2e-3", "Film right/Temperature = 350",
                 "Mesh/Parameters = width: 0.5", "Title = another",
                 "Procedure/Integrator/Method = bdf",
                 "Material rubber/Spring ground/Limit = 80"});
  EXPECT_EQ(read.device.films[0].thickness, 2e-3);
  EXPECT_EQ(read.device.films[1].temperature.value(0), 350);
  EXPECT_EQ(read.device.mesh.geo_parameters.size(), 1u);
  EXPECT_EQ(read.device.mesh.geo_parameters.at("width"), 0.5);
  EXPECT_EQ(read.device.title, "another");
  EXPECT_EQ(read.procedure.integrator.method, time::Method::bdf);
  EXPECT_EQ(
      std::get<material::Gent>(read.device.films[0].material.springs[0]).limit,
      80);
}

TEST(Parameters, QuasiStaticRunsUseTheMethodThatTheyNeed)
{
  const CaseOnDisk disk(small_case);
  EXPECT_EQ(read_case(disk.file()).procedure.integrator.method,
            time::Method::esdirk4);
  EXPECT_EQ(read_case(disk.file(), {"Procedure/Analysis = quasi-static"})
                .procedure.integrator.method,
            time::Method::bdf);
}

TEST(Parameters, JsonSaysTheSameAsPrm)
{
  const CaseOnDisk disk(R"json({
  "Model": "resonator",
  "Lumped resonator": {
    "Length active": 0.02, "Length passive": 2e-2, "Width": "0.02",
    "Thickness": 1e-3, "Pre-stretch": [2, 4], "Bar mass": 0.02,
    "Density": 960, "Shear modulus": 40e3, "Equilibrium share": 0.5,
    "Relaxation times": [0.01, 1, 100], "Breakdown strength": 155.016e6,
    "Relaxation is rate": true, "Voltage": "ramp(rate = 9300)"
}
})json",
                        "case.json");
  const study::LumpedResonatorDescription resonator =
      read_case(disk.file()).lumped_resonator;
  EXPECT_EQ(resonator.length_passive, 0.02);
  EXPECT_EQ(resonator.pre_stretch, (std::array<double, 2>{{2, 4}}));
  EXPECT_EQ(resonator.relaxation_times, (std::vector<double>{0.01, 1, 100}));
  EXPECT_TRUE(resonator.relaxation_is_rate);
  EXPECT_EQ(resonator.voltage.value(0.5), 4650);
}

/// Whether some number is allowed and a word is not.
bool is_number(const Parameter& parameter)
{
  const auto allows = [&parameter](const std::string& text)
  {
    try
    {
      parameter.check(text);
      return true;
    }
    catch (const BadInput&)
    {
      return false;
    }
  };
  bool allows_number = false;
  for (const char* text : {"0.5", "1.5", "0.5, 0.5", "0.5, 0.5, 0.5", "a: 0.5"})
    allows_number = allows_number || allows(text);
  return allows_number && !allows("abc");
}

TEST(Parameters, EveryNumberIsDocumentedWithItsUnit)
{
  Declarations all;
  CaseDraft draft;
  declare_everything(all, draft);
  unsigned int n_numbers = 0;
  for (const Parameter& parameter : all.parameters())
    if (is_number(parameter))
    {
      ++n_numbers;
      const std::string ending = "(" + parameter.unit + ")";
      const std::string& text = parameter.documentation;
      EXPECT_FALSE(parameter.unit.empty()) << parameter.key;
      EXPECT_EQ(text.substr(text.size() - ending.size()), ending)
          << parameter.key;
    }
  EXPECT_GT(n_numbers, 50u);
}

TEST(Parameters, DescribeListsEveryKeyOfTheSectionAskedFor)
{
  std::ostringstream film, everything;
  describe(film, "Film");
  EXPECT_NE(film.str().find("Thickness"), std::string::npos);
  EXPECT_EQ(film.str().find("Voltage"), std::string::npos);
  describe(everything);
  Declarations all;
  CaseDraft draft;
  declare_everything(all, draft);
  for (const Parameter& parameter : all.parameters())
    EXPECT_NE(everything.str().find(parameter.documentation), std::string::npos)
        << parameter.key;
}

TEST(Parameters, DescribeProposesTheNearestSection)
{
  std::ostringstream stream;
  try
  {
    describe(stream, "Flim");
    FAIL() << "an unknown section was described";
  }
  catch (const BadInput& problem)
  {
    EXPECT_NE(problem.message().find("did you mean 'Film'"), std::string::npos);
  }
}
} // namespace
} // namespace taut::io
