#include <taut/base/exceptions.h>
#include <taut/io/parameters.h>
#include <taut/lumped/demes_run.h>
#include <taut/study/lumped_case_demes.h>

#include <gtest/gtest.h>

#include <string>

namespace taut::io
{
namespace
{
const std::string file = std::string(TAUT_CASES) + "/demes/lumped.prm";

study::LumpedDemesDescription
read_demes(const std::vector<std::string>& overrides = {})
{
  return read_case(file, overrides).lumped_demes;
}
} // namespace

TEST(LumpedDemesCase, HasTheDimensionlessNumbersItTells)
{
  const auto demes = lumped::make_demes(study::make_demes_si(read_demes()));
  EXPECT_EQ(read_case(file).model, "demes");
  EXPECT_NEAR(demes.frame_stiffness, 1, 2e-4);
  EXPECT_NEAR(demes.relaxation, 0.03, 2e-5);
  EXPECT_NEAR(demes.drive.value(0) / demes.drive_unit, 0.3, 1e-5);
  EXPECT_EQ(demes.permittivity.b, lumped::wang_permittivity.b);
}

TEST(LumpedDemesCase, EveryKeyIsRead)
{
  const auto demes = read_demes(
      {"Lumped DEMES/Film offset = 1e-3", "Lumped DEMES/Rest angle = 0.1",
       "Lumped DEMES/Permittivity coefficients = none",
       "Lumped DEMES/Temperature laws = entropic",
       "Lumped DEMES/Temperature = 320",
       "Lumped DEMES/Charge controlled = true", "Lumped DEMES/Source = 1e-6",
       "Lumped DEMES/Begin = flat", "Lumped DEMES/Seed angle = 0.02",
       "Lumped DEMES/Tolerance = 1e-7"});
  EXPECT_EQ(demes.film_offset, 1e-3);
  EXPECT_EQ(demes.rest_angle, 0.1);
  EXPECT_TRUE(demes.permittivity_coefficients.empty());
  EXPECT_EQ(demes.temperature_laws, "entropic");
  EXPECT_EQ(demes.temperature, 320);
  EXPECT_TRUE(demes.charge_controlled);
  EXPECT_EQ(demes.source.value(3), 1e-6);
  EXPECT_EQ(demes.start, study::DemesStart::flat);
  EXPECT_EQ(demes.seed_angle, 0.02);
  EXPECT_EQ(demes.tolerance, 1e-7);
}

TEST(LumpedDemesCase, RefusesWhatItDoesNotKnow)
{
  EXPECT_THROW(read_demes({"Lumped DEMES/Film lenght = 1"}), BadInput);
  EXPECT_THROW(read_demes({"Lumped DEMES/Inertia = 0"}), BadInput);
  EXPECT_THROW(read_demes({"Lumped DEMES/Begin = bent"}), BadInput);
  EXPECT_THROW(read_demes({"Lumped DEMES/Temperature laws = hard"}), BadInput);
}
} // namespace taut::io
