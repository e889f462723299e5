#include <taut/io/comparison_writer.h>
#include <taut/io/files.h>

#include <gtest/gtest.h>
#include <io/output_files.h>

#include <cmath>

#include <nlohmann/json.hpp>

namespace taut::io
{
namespace
{
study::Comparison make_small_comparison()
{
  study::Comparison comparison;
  comparison.times = {0, 0.5, 1};
  comparison.voltage = {0, 10, 20};
  study::ComparedQuantity charge;
  charge.name = "charge";
  charge.unit = "C";
  charge.film = {0, 1e-6, std::nan("")};
  charge.lumped = {0, 2e-6, 4e-6};
  charge.max_relative_difference = 0.5;
  charge.rms_relative_difference = 0.25;
  charge.time_of_max = 0.5;
  comparison.quantities = {charge};
  comparison.film_events = {{0.5, 10, "breakdown", "active", false}};
  comparison.film_failure = comparison.film_events[0];
  comparison.compared_until = 0.5;
  comparison.film_summary.status = study::Status::event;
  comparison.equivalent.ignored = {"the air drags"};
  return comparison;
}

TEST(ComparisonWriter, JsonKeepsTheContract)
{
  const auto json =
      nlohmann::json::parse(make_comparison_json(make_small_comparison()));
  ASSERT_EQ(json.at("quantities").size(), 1u);
  const auto& quantity = json.at("quantities")[0];
  EXPECT_EQ(quantity.at("name"), "charge");
  EXPECT_EQ(quantity.at("unit"), "C");
  EXPECT_EQ(quantity.at("max_relative_difference"), 0.5);
  EXPECT_EQ(quantity.at("rms_relative_difference"), 0.25);
  EXPECT_EQ(quantity.at("time_of_max"), 0.5);
  EXPECT_EQ(json.at("compared_until"), 0.5);
  const auto& events = json.at("events");
  ASSERT_EQ(events.at("film").size(), 1u);
  EXPECT_EQ(events.at("film")[0].at("kind"), "breakdown");
  EXPECT_TRUE(events.at("lumped").empty());
  EXPECT_EQ(events.at("film_failure").at("time"), 0.5);
  EXPECT_TRUE(events.at("lumped_failure").is_null());
  EXPECT_TRUE(events.at("failure_difference").is_null());
  EXPECT_EQ(json.at("film_status"), "event");
  EXPECT_EQ(json.at("ignored")[0], "the air drags");
}

TEST(ComparisonWriter, TableLeavesEmptyWhatAModelLacks)
{
  const testing::SharedFolder folder("comparison");
  const std::string file = folder.get("compare.csv");
  write_comparison_table(file, make_small_comparison());
  EXPECT_EQ(read_file(file),
            "time [s],voltage [V],charge film [C],charge lumped [C]\n"
            "0,0,0,0\n"
            "0.5,10,1e-06,2e-06\n"
            "1,20,,4e-06\n");
}

TEST(ComparisonWriter, DescriptionNamesQuantitiesAndFailures)
{
  const std::string text = describe_comparison(make_small_comparison());
  for (const char* part :
       {"charge", "5.00e-01", "2.50e-01", "breakdown in active", "lumped",
        "does not fail", "the air drags"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}
} // namespace
} // namespace taut::io
