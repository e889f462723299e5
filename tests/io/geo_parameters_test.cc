#include <taut/base/exceptions.h>
#include <taut/io/geo_parameters.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace
{
using Names = std::vector<std::string>;

class GeoParameters : public testing::Test
{
protected:
  void SetUp() override
  {
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override
  {
    std::filesystem::remove_all(folder_);
  }

  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }

private:
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  ("taut_geo_" + std::to_string(getpid()));
};

TEST_F(GeoParameters, lists_every_name_of_define_constant)
{
  const auto file = write("a.geo", "DefineConstant[a = 1, b_2 = {2}];\n"
                                   "c = 3;\n"
                                   "DefineConstant [ d={4,Name \"x\"} ];");
  EXPECT_EQ(taut::io::get_geo_parameter_names(file), (Names{"a", "b_2", "d"}));
}

TEST_F(GeoParameters, passes_over_comments_strings_and_options)
{
  const auto file = write(
      "a.geo", "// DefineConstant[no = 1];\n"
               "/* DefineConstant[nor = 1]; */\n"
               "DefineConstant[ a = {1, Name \"//, z = 3\", Min 0,\n"
               "  Choices {1 = \"one\", 2 = \"two, b = 1\"}}, // , c = 1\n"
               "  e = Max(1, f)];\n"
               "Printf(\"DefineConstant[neither = 1]\");");
  EXPECT_EQ(taut::io::get_geo_parameter_names(file), (Names{"a", "e"}));
}

TEST_F(GeoParameters, follows_includes_also_in_a_circle)
{
  const auto file =
      write("a.geo", "DefineConstant[a = 1];\nInclude \"b.geo\";\n");
  write("b.geo", "Include \"a.geo\";\nDefineConstant[b = 1];\n");
  EXPECT_EQ(taut::io::get_geo_parameter_names(file), (Names{"a", "b"}));
}

TEST_F(GeoParameters, refuses_a_file_that_is_missing)
{
  EXPECT_THROW(taut::io::get_geo_parameter_names("missing.geo"),
               taut::BadInput);
  const auto file = write("a.geo", "Include \"missing.geo\";");
  EXPECT_THROW(taut::io::get_geo_parameter_names(file), taut::BadInput);
}
} // namespace
