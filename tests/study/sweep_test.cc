#include <taut/base/exceptions.h>
#include <taut/study/sweep.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

using namespace taut;
using namespace taut::study;

namespace
{
SweepVariable make_variable(const std::string& name,
                            const std::vector<std::string>& values,
                            const std::string& key = "")
{
  SweepVariable variable;
  variable.name = name;
  variable.values = values;
  variable.key = key;
  return variable;
}

SweepSetting make_setting(const std::string& key, const std::string& value)
{
  SweepSetting setting;
  setting.name = "of " + key;
  setting.source_line = 17;
  setting.key = key;
  setting.value = value;
  return setting;
}

StudyDescription make_study()
{
  StudyDescription study;
  study.file = "study.prm";
  study.variables = {make_variable("stretch", {"2", "3"}, "Film/Pre-stretch"),
                     make_variable("law", {"Gent", "Yeoh", "neo-Hookean"})};
  return study;
}

/// What the refusal of an edited study says.
std::string get_refusal(const std::function<void(StudyDescription&)>& edit,
                        const unsigned int line = 0)
{
  StudyDescription study = make_study();
  edit(study);
  try
  {
    expand(study);
  }
  catch (const BadInput& problem)
  {
    EXPECT_EQ(problem.file(), "study.prm");
    EXPECT_EQ(problem.line(), line);
    return problem.what();
  }
  ADD_FAILURE() << "accepted";
  return "";
}

void expect_part(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

using Texts = std::vector<std::string>;
} // namespace

TEST(Sweep, GridHoldsAllCombinationsTheLastFastest)
{
  const auto cases = expand(make_study());
  ASSERT_EQ(cases.size(), 6u);
  EXPECT_EQ(cases[0].values, (Texts{"2", "Gent"}));
  EXPECT_EQ(cases[1].values, (Texts{"2", "Yeoh"}));
  EXPECT_EQ(cases[3].values, (Texts{"3", "Gent"}));
  EXPECT_EQ(cases[5].values, (Texts{"3", "neo-Hookean"}));
  std::set<std::string> folders;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    EXPECT_EQ(cases[i].number, i + 1);
    folders.insert(cases[i].folder);
  }
  EXPECT_EQ(folders.size(), 6u);
  EXPECT_EQ(cases[1].folder, "stretch=2,law=Yeoh");
}

TEST(Sweep, TogetherTakesTheValuesPairwise)
{
  StudyDescription study = make_study();
  study.combine = Combine::together;
  study.variables[1].values.pop_back();
  const auto cases = expand(study);
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[0].values, (Texts{"2", "Gent"}));
  EXPECT_EQ(cases[1].values, (Texts{"3", "Yeoh"}));
}

TEST(Sweep, WithoutVariablesThereIsOneCase)
{
  StudyDescription study;
  study.settings = {make_setting("A/B", "{2*case}")};
  const auto cases = expand(study);
  ASSERT_EQ(cases.size(), 1u);
  EXPECT_EQ(cases[0].keys[0].value, "2");
  EXPECT_FALSE(cases[0].folder.empty());
}

TEST(Sweep, BracesAreFilledWithTextsAndExpressions)
{
  StudyDescription study = make_study();
  study.settings = {
      make_setting("Film/Width", "{0.5*stretch^2 + 0.1}"),
      make_setting("Spring/Law", "{law}"),
      make_setting("Film/Voltage",
                   "ramp(rate = { 10*stretch }, start = {case})")};
  study.folder = "s{stretch}/{law} {case}";
  const auto cases = expand(study);
  const StudyCase& last = cases.back();
  ASSERT_EQ(last.keys.size(), 4u);
  EXPECT_EQ(last.keys[0].key, "Film/Pre-stretch");
  EXPECT_EQ(last.keys[0].value, "3");
  EXPECT_EQ(last.keys[1].value, "4.6");
  EXPECT_EQ(last.keys[2].value, "neo-Hookean");
  EXPECT_EQ(last.keys[3].value, "ramp(rate = 30, start = 6)");
  EXPECT_EQ(last.folder, "s3_neo-Hookean_6");
}

TEST(Sweep, WindowsOfResultsFollowTheCase)
{
  StudyDescription study = make_study();
  SweepResult result;
  result.name = "end";
  result.of = "angle";
  result.from = "{stretch/2}";
  study.results = {result};
  const auto cases = expand(study);
  EXPECT_EQ(cases[0].results[0].from, 1);
  EXPECT_EQ(cases[5].results[0].from, 1.5);
  EXPECT_TRUE(std::isinf(cases[0].results[0].to));
  EXPECT_EQ(cases[0].results[0].of, "angle");
}

TEST(Sweep, RangesAreEvenAndEndWhereTheyShould)
{
  EXPECT_EQ(make_range(0, 0.3, 4, Spacing::linear),
            (Texts{"0", "0.1", "0.2", "0.3"}));
  EXPECT_EQ(make_range(3, 1, 3, Spacing::linear), (Texts{"3", "2", "1"}));
  EXPECT_EQ(make_range(0.01, 100, 5, Spacing::logarithmic),
            (Texts{"0.01", "0.1", "1", "10", "100"}));
  EXPECT_EQ(make_range(-1, -4, 3, Spacing::logarithmic),
            (Texts{"-1", "-2", "-4"}));
  EXPECT_EQ(make_range(5, 7, 1, Spacing::linear), (Texts{"5"}));
  EXPECT_EQ(make_range(0, 1, 200, Spacing::linear).size(), 200u);
}

TEST(Sweep, RefusesRangesThatAreNone)
{
  EXPECT_THROW(make_range(0, 1, 0, Spacing::linear), BadInput);
  EXPECT_THROW(make_range(2, 2, 3, Spacing::linear), BadInput);
  EXPECT_THROW(make_range(0, 1, 3, Spacing::logarithmic), BadInput);
  EXPECT_THROW(make_range(-1, 1, 3, Spacing::logarithmic), BadInput);
}

TEST(Sweep, RefusesListsOfDifferentLengths)
{
  const auto text = get_refusal([](StudyDescription& study)
                                { study.combine = Combine::together; });
  expect_part(text, "'law' has 3 values, but 'stretch' has 2");
}

TEST(Sweep, RefusesCasesWithTheSameFolder)
{
  auto text =
      get_refusal([](StudyDescription& study) { study.folder = "law_{law}"; });
  expect_part(text, "the cases 1 and 4 have the same folder 'law_Gent'");
  text = get_refusal(
      [](StudyDescription& study) {
        study.variables[0].values = {"2", "3", "2"};
      });
  expect_part(text, "the cases 1 and 7 have the same folder");
  // Nobody writes where no folder is kept.
  StudyDescription study = make_study();
  study.folder = "law_{law}";
  study.keep_folders = false;
  EXPECT_EQ(expand(study).size(), 6u);
}

TEST(Sweep, RefusesFoldersOutsideItsOwn)
{
  expect_part(get_refusal([](StudyDescription& study) { study.folder = ".."; }),
              "is no name of a folder");
}

TEST(Sweep, RefusesNamesOfVariables)
{
  for (const char* name : {"pre stretch", "sin", "case", "2x"})
    expect_part(get_refusal([&](StudyDescription& study)
                            { study.variables[0].name = name; }),
                "cannot name a variable");
}

TEST(Sweep, RefusesVariablesWithoutValues)
{
  expect_part(get_refusal([](StudyDescription& study)
                          { study.variables[1].values.clear(); }),
              "has no value");
}

TEST(Sweep, RefusesExpressionsAtTheirLine)
{
  const auto refuse = [](const std::string& value)
  {
    return get_refusal([&value](StudyDescription& study)
                       { study.settings = {make_setting("A/B", value)}; },
                       17);
  };
  expect_part(refuse("{2*strech}"), "did you mean 'stretch'?");
  expect_part(refuse("{2*law}"), "law");
  expect_part(refuse("{2*stretch"), "a brace has no partner");
  expect_part(refuse("2}"), "a brace has no partner");
  expect_part(refuse("{1/(stretch - 3)}"), "case 4: ");
}

TEST(Sweep, RefusesWindowsThatAreNoTimes)
{
  SweepResult result;
  result.name = "end";
  result.of = "angle";
  result.to = "{law}";
  expect_part(
      get_refusal([&](StudyDescription& study) { study.results = {result}; }),
      "'Gent' is no time");
}

TEST(Sweep, RefusesAColumnTwiceAndAKeyTwice)
{
  SweepResult result;
  result.name = "stretch";
  expect_part(
      get_refusal([&](StudyDescription& study) { study.results = {result}; }),
      "the table has another column 'stretch'");
  expect_part(
      get_refusal([](StudyDescription& study)
                  { study.settings = {make_setting("Film/Pre-stretch", "1")}; },
                  17),
      "is given by 'Vary stretch', too");
}
