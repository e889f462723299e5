#include <taut/base/exceptions.h>
#include <taut/io/comparison_demes_writer.h>
#include <taut/io/files.h>
#include <taut/io/parameters.h>

#include <gtest/gtest.h>
#include <io/output_files.h>

#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace taut::io
{
namespace
{
const std::string dc = std::string(TAUT_CASES) + "/demes/dc.prm";

TEST(ComparisonDemesCase, NamesThePartsOfTheDevice)
{
  const auto read = read_case(dc);
  EXPECT_FALSE(read.comparison);
  ASSERT_TRUE(read.demes_comparison);
  EXPECT_EQ(read.demes_comparison->legs, std::vector<std::string>{"legs"});
  EXPECT_EQ(read.demes_comparison->electrode, "film");
  EXPECT_EQ(read.demes_comparison->right_body, "right");
  EXPECT_EQ(read.demes_comparison->chord_probe, "chord");
}

TEST(ComparisonDemesCase, WrongNamesAndForeignKeysAreRefused)
{
  for (const auto& [setting, says] :
       std::vector<std::pair<std::string, std::string>>{
           {"Film = fim", "did you mean 'film'"},
           {"Electrode = fim", "no electrode"},
           {"Legs = leg", "did you mean 'legs'"},
           {"Legs = none", "name of a frame is needed"},
           {"Left body = lefd", "did you mean 'left'"},
           {"Right body = left", "must be two bodies"},
           {"Angle probe = angel", "did you mean 'angle'"},
           {"Chord probe = cord", "did you mean 'chord'"},
           {"Stretch probe = strech", "did you mean 'stretch'"},
           {"Bar = left", "no meaning for Model = demes"},
           {"Model = beam", "demes"},
           {"Model = resonator", "no meaning for Model = resonator"}})
    try
    {
      read_case(dc, {"Comparison/" + setting});
      ADD_FAILURE() << "accepted: " << setting;
    }
    catch (const BadInput& problem)
    {
      EXPECT_NE(std::string(problem.what()).find(says), std::string::npos)
          << problem.what();
    }
}

study::DemesComparison make_comparison()
{
  study::DemesComparison comparison;
  comparison.times = {0, 0.5};
  comparison.voltage = {0, 10};
  const auto set =
      [](study::DemesModel& model, const char* name, const double angle)
  {
    model.name = name;
    model.rest.shape = {angle, 0.03, 1.5};
    model.angle = {angle, angle};
    model.chord = {0.03, 0.03};
    model.stretch = {1.5, std::nan("")};
  };
  set(comparison.film, "finite elements", 0.9);
  set(comparison.elastica, "elastica", 1);
  set(comparison.arc, "arc", 0.8);
  comparison.film.oscillation.frequency = 3;
  comparison.arc.oscillation.frequency = 4;
  comparison.arc.rest.relaxed_frequency = 5;
  comparison.arc.driven = comparison.arc.rest;
  study::ComparedQuantity quantity;
  quantity.name = "angle";
  quantity.unit = "rad";
  quantity.max_relative_difference = 0.125;
  comparison.quantities = {quantity};
  comparison.equivalent.ignored = {"the air drags"};
  comparison.compared_until = 0.5;
  return comparison;
}

TEST(ComparisonDemesWriter, JsonKeepsTheContractAndAddsTheModels)
{
  const auto json =
      nlohmann::json::parse(make_comparison_json(make_comparison()));
  const auto& quantity = json.at("quantities").at(0);
  EXPECT_EQ(quantity.at("name"), "angle");
  EXPECT_EQ(quantity.at("max_relative_difference"), 0.125);
  EXPECT_EQ(quantity.at("rms_relative_difference"), 0);
  EXPECT_EQ(quantity.at("time_of_max"), 0);
  const auto& models = json.at("models");
  ASSERT_EQ(models.size(), 3u);
  EXPECT_EQ(models[0].at("name"), "finite elements");
  EXPECT_EQ(models[0].at("rest").at("angle"), 0.9);
  EXPECT_TRUE(models[0].at("rest").at("relaxed_frequency").is_null());
  EXPECT_TRUE(models[0].at("driven").is_null());
  const auto& arc = models[2];
  EXPECT_EQ(arc.at("driven").at("relaxed_frequency"), 5);
  EXPECT_DOUBLE_EQ(arc.at("film_difference").at("angle"), 0.125);
  EXPECT_DOUBLE_EQ(arc.at("film_difference").at("frequency"), -0.25);
  EXPECT_TRUE(models[1].at("film_difference").at("frequency").is_null());
  EXPECT_TRUE(json.at("events").at("film").empty());
  EXPECT_EQ(json.at("ignored")[0], "the air drags");
}

TEST(ComparisonDemesWriter, TableHasAllModelsAndLeavesGapsEmpty)
{
  const testing::SharedFolder folder("comparison_demes");
  const std::string file = folder.get("compare.csv");
  write_comparison_table(file, make_comparison());
  const std::string text = read_file(file);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "time [s],voltage [V],angle finite elements [rad],angle elastica "
            "[rad],angle arc [rad],chord finite elements [m],chord elastica "
            "[m],chord arc [m],stretch finite elements [1],stretch elastica "
            "[1],stretch arc [1]");
  EXPECT_NE(text.find(",,,\n"), std::string::npos);
}
} // namespace
} // namespace taut::io
