#include <taut/io/study_file.h>

#include <sstream>

#include "io/refusal.h"

using namespace taut;
using namespace taut::io;
using namespace taut::io::testing;

namespace
{
const char* const lumped_case = R"(set Model = demes
subsection Lumped DEMES
  set Film length = 0.02
  set Film width = 0.04
  set Film thickness = 5e-4
  set Shear modulus = 52246.6
  set Viscosity = 49.9
  set Frame modulus = 2e9
  set Frame width = 0.010032
  set Frame thickness = 5e-4
  set Inertia = 2.117476e-5
end
)";

const char* const small_study = R"(set Case = base.prm
set Combine = grid
subsection Vary pre_stretch
  set Range = 2, 4, 3
  set Key = Lumped DEMES/Pre-stretch
end
subsection Vary source
  set Values = 1000, 2000
  set Unit = V
end
subsection Set source
  set Key = Lumped DEMES/Source
  set Value = ramp(rate = {source/2})
end
subsection Result end
  set Of = angle
  set Statistic = final
end
)";

/// A study beside its case.
class StudyOnDisk : public CaseOnDisk
{
public:
  explicit StudyOnDisk(const std::string& content,
                       const std::string& case_content = lumped_case,
                       const std::string& name = "study.prm")
      : CaseOnDisk(content, name)
  {
    std::ofstream(folder() / "base.prm") << case_content;
  }
};
} // namespace

TEST(StudyFile, GivesCasesWithTheKeysOfTheirCaseFile)
{
  const StudyOnDisk disk(small_study);
  const StudyFile study = read_study_file(disk.file());
  ASSERT_EQ(study.cases.size(), 6u);
  EXPECT_EQ(
      get_overrides(study.cases[5]),
      (std::vector<std::string>{"Lumped DEMES/Pre-stretch = 4",
                                "Lumped DEMES/Source = ramp(rate = 1000)"}));
  const auto last =
      read_case(study.content.case_file, get_overrides(study.cases[5]));
  EXPECT_EQ(last.lumped_demes.pre_stretch, 4);
  EXPECT_EQ(last.lumped_demes.source.value(2), 2000);
  // Of the key, and as the study says.
  EXPECT_EQ(study.content.variables[0].unit, "1");
  EXPECT_EQ(study.content.variables[1].unit, "V");
}

TEST(StudyFile, EffectiveParametersReadBackAsTheSameStudy)
{
  const StudyOnDisk disk(small_study);
  const StudyFile study = read_study_file(disk.file());
  const CaseOnDisk elsewhere(study.effective_parameters);
  const StudyFile again = read_study_file(elsewhere.file());
  EXPECT_EQ(again.content.case_file, study.content.case_file);
  EXPECT_EQ(find_difference(study.identity, again.identity), "");
  EXPECT_EQ(again.effective_parameters, study.effective_parameters);
}

TEST(StudyFile, MayBeJson)
{
  const StudyOnDisk disk(R"({"Case": "base.prm",
    "Vary pre_stretch": {"Values": [2, 2.5],
                         "Key": "Lumped DEMES/Pre-stretch"}})",
                         lumped_case, "study.json");
  const StudyFile study = read_study_file(disk.file());
  ASSERT_EQ(study.cases.size(), 2u);
  EXPECT_EQ(study.cases[1].values[0], "2.5");
}

TEST(StudyFile, ValuesWithCommasAreSeparatedBySemicolons)
{
  const StudyOnDisk disk(edit(small_study, "Values = 1000, 2000",
                              "Values = steps(0: 0, 1: 5); 7"));
  const auto study =
      read_study_file(disk.file(), {"Set source/Value = {source}"});
  ASSERT_EQ(study.cases.size(), 6u);
  EXPECT_EQ(study.cases[0].keys[1].value, "steps(0: 0, 1: 5)");
  EXPECT_EQ(study.cases[1].keys[1].value, "7");
}

TEST(StudyFile, TitlesAndResultsDoNotMakeAnotherStudy)
{
  const StudyOnDisk disk(small_study);
  const auto study = read_study_file(disk.file());
  const auto same = read_study_file(
      disk.file(), {"Title = other", "Result end/Statistic = mean"});
  EXPECT_EQ(find_difference(study.identity, same.identity), "");
  const auto other =
      read_study_file(disk.file(), {"Vary pre_stretch/Range = 2, 4, 5"});
  EXPECT_NE(find_difference(study.identity, other.identity)
                .find("'Vary pre_stretch/Range' was '2, 4, 3' and is"),
            std::string::npos);
  std::ofstream(disk.folder() / "base.prm") << edit(lumped_case, "49.9", "50");
  EXPECT_EQ(
      find_difference(study.identity, read_study_file(disk.file()).identity),
      "the case file has changed in line 7");
}

class StudyRefused : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(StudyRefused, WithLineAndKey)
{
  const Refusal& refusal = GetParam();
  const std::string content = edit(small_study, refusal.from, refusal.to);
  const StudyOnDisk disk(content);
  expect_refused_by([](const std::string& file) { read_study_file(file); },
                    disk.file(), content, refusal);
}

INSTANTIATE_TEST_SUITE_P(
    Sections, StudyRefused,
    ::testing::Values(
        Refusal{"unknown key", "set Combine", "set Combined", "set Combined",
                "Combined", "did you mean 'Combine'?"},
        Refusal{"unknown section", "subsection Vary source",
                "subsection Varry source", "subsection Varry", "Varry source",
                "did you mean 'Vary source'?"},
        Refusal{"no case", "set Case = base.prm", "set Title = a", nullptr,
                "Case", "missing"},
        Refusal{"no such case", "base.prm", "bases.prm", "set Case", "Case",
                "there is no file"},
        Refusal{"no such plot", "set Combine = grid", "set Plot = plot.py",
                "set Plot", "Plot", "there is no file"},
        Refusal{"word", "grid", "gird", "set Combine", "Combine",
                "did you mean 'grid'?"},
        Refusal{"statistic", "final", "finally", "set Statistic",
                "Result end/Statistic", "did you mean 'final'?"},
        Refusal{"statistic of an event", "final", "time", "set Statistic",
                "Result end/Statistic", "event NAME"},
        Refusal{"statistic of a column", "Of = angle", "Of = event film pushes",
                "set Statistic", "Result end/Statistic", "an event has"}));

INSTANTIATE_TEST_SUITE_P(
    Values, StudyRefused,
    ::testing::Values(
        Refusal{"no values", "set Range = 2, 4, 3", "set Unit = 1",
                "subsection Vary pre_stretch", "Vary pre_stretch/Values",
                "no values"},
        Refusal{"both", "set Unit = V", "set Range = 1, 2, 2",
                "set Range = 1, 2, 2", "Vary source/Range", "either"},
        Refusal{"empty range", "2, 4, 3", "2, 2, 3", "set Range",
                "Vary pre_stretch/Range", "empty range"},
        Refusal{"no number of the range", "2, 4, 3", "2, 4, 0", "set Range",
                "Vary pre_stretch/Range", "no values"},
        Refusal{"half a number", "2, 4, 3", "2, 4, 2.5", "set Range",
                "Vary pre_stretch/Range", "no whole number"},
        Refusal{"two numbers", "2, 4, 3", "2, 4", "set Range",
                "Vary pre_stretch/Range", "3 numbers"},
        Refusal{"logarithmic through zero", "set Range = 2, 4, 3",
                "set Range = -2, 4, 3\n  set Spacing = logarithmic",
                "set Range", "Vary pre_stretch/Range", "logarithmic"},
        Refusal{"a gap in the list", "1000, 2000", "1000,, 2000", "set Values",
                "Vary source/Values", "a value is missing"}));

INSTANTIATE_TEST_SUITE_P(
    Keys, StudyRefused,
    ::testing::Values(
        Refusal{"key of a variable", "DEMES/Pre-stretch", "DEMES/Prestretch",
                "set Key = Lumped DEMES/Prestretch", "Vary pre_stretch/Key",
                "did you mean 'Pre-stretch'?"},
        Refusal{"section of a variable", "DEMES/Pre-stretch",
                "DEMS/Pre-stretch", "set Key = Lumped DEMS",
                "Vary pre_stretch/Key", "did you mean 'Lumped DEMES'?"},
        Refusal{"key of a setting", "DEMES/Source", "DEMES/Sources",
                "set Key = Lumped DEMES/Sources", "Set source/Key",
                "did you mean 'Source'?"}));

TEST(StudyFile, UnknownKeyOfTheCaseIsNamedInTheCase)
{
  const std::string content = edit(lumped_case, "Viscosity", "Viscosty");
  const StudyOnDisk disk(small_study, content);
  try
  {
    read_study_file(disk.file());
    FAIL() << "accepted";
  }
  catch (const BadInput& problem)
  {
    EXPECT_EQ(problem.file(), (disk.folder() / "base.prm").string());
    EXPECT_EQ(problem.line(), 7u);
  }
}

TEST(StudyFile, AKeyThatOneCaseLacksIsRefused)
{
  // Only a Gent spring has a limit.
  const std::string content =
      edit(small_case, "set File = meshes/two.geo", "set File = two.geo");
  const StudyOnDisk disk(R"(set Case = base.prm
subsection Vary law
  set Values = Gent, neo-Hookean
  set Key = Material rubber/Spring ground/Law
end
subsection Set limit
  set Key = Material rubber/Spring ground/Limit
  set Value = 50
end
)",
                         content);
  try
  {
    read_study_file(disk.file());
    FAIL() << "accepted";
  }
  catch (const BadInput& problem)
  {
    EXPECT_EQ(problem.key(), "Set limit/Key");
    EXPECT_EQ(problem.line(), 7u);
  }
}

TEST(StudyFile, ExamplesHaveCasesThatMayBeRun)
{
  for (const char* name : {"pre_stretch.prm", "fibre_angle.prm"})
  {
    const StudyFile study =
        read_study_file(std::string(TAUT_CASES) + "/studies/" + name);
    EXPECT_GT(study.cases.size(), 1u) << name;
    for (const study::StudyCase& item : study.cases)
      EXPECT_NO_THROW(
          make_case_file(study.case_text, get_overrides(item), false))
          << name << ", case " << item.number;
  }
}

TEST(Describe, KnowsTheSectionsOfStudies)
{
  std::ostringstream text;
  describe(text, "Vary");
  EXPECT_NE(text.str().find("Spacing"), std::string::npos);
  EXPECT_EQ(text.str().find("Film"), std::string::npos);
}
