#include <taut/base/exceptions.h>
#include <taut/io/csv_file.h>
#include <taut/io/files.h>
#include <taut/io/study_journal.h>
#include <taut/io/study_table.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "io/small_case.h"

using namespace taut;
using namespace taut::io;
using namespace taut::io::testing;

namespace
{
const char* const study_content = R"(set Case = case.prm
subsection Vary stretch
  set Values = 2, 3, 4
  set Key = Film film/Pre-stretch
end
subsection Result angle
  set Of = angle
end
)";

/// A folder, and a study without a file of its own.
class StudyInFolder : public CaseOnDisk
{
public:
  StudyInFolder() : CaseOnDisk(study_content, "study.prm")
  {
    study.content.file = file();
    study.content.variables.resize(1);
    study.content.variables[0].name = "stretch";
    study.content.variables[0].values = {"2", "3", "4"};
    study.content.results.resize(1);
    study.content.results[0].name = "angle";
    study.content.results[0].of = "angle";
    study.cases = study::expand(study.content);
    study.identity.parameters["Vary stretch/Values"] = "2, 3, 4";
  }
  StudyFolder get_folder() const
  {
    return {folder().string()};
  }

  StudyFile study;
};

CaseOutcome make_outcome(const unsigned int number, const std::string& angle)
{
  CaseOutcome outcome;
  outcome.number = number;
  outcome.status = "completed";
  outcome.time_reached = 2.5;
  outcome.seconds = 0.125;
  outcome.results = {{angle, "rad"}};
  return outcome;
}
} // namespace

TEST(StudyMessages, ReadBackAsTheyWere)
{
  CaseJob job;
  job.number = 7;
  job.case_file = "a \"b\".prm";
  job.overrides = {"A/B = 1", "C = two words"};
  job.folder = "x/y";
  job.resume = true;
  job.results = {{"angle", study::Statistic::time_of_minimum, 1.5, 1e300},
                 {"motion/class"}};
  const CaseJob same = read_job(write_line(job));
  EXPECT_EQ(same.number, 7u);
  EXPECT_EQ(same.case_file, job.case_file);
  EXPECT_EQ(same.overrides, job.overrides);
  EXPECT_EQ(same.folder, "x/y");
  EXPECT_TRUE(same.resume);
  ASSERT_EQ(same.results.size(), 2u);
  EXPECT_EQ(same.results[0].statistic, study::Statistic::time_of_minimum);
  EXPECT_EQ(same.results[0].from, 1.5);
  EXPECT_EQ(same.results[0].to, 1e300);
  EXPECT_EQ(same.results[1].of, "motion/class");
  EXPECT_EQ(same.results[1].from, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(same.results[1].to, std::numeric_limits<double>::infinity());

  CaseOutcome outcome = make_outcome(7, "0.1");
  outcome.reason = "several\nlines, \xff and \"quotes\"";
  outcome.mistake = ResultMistake{1, "no such column"};
  const std::string line = write_line(outcome);
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
  const CaseOutcome again = read_outcome(line);
  EXPECT_EQ(again.status, "completed");
  EXPECT_EQ(again.time_reached, 2.5);
  EXPECT_EQ(again.seconds, 0.125);
  EXPECT_EQ(again.results.at(0).text, "0.1");
  EXPECT_EQ(again.results.at(0).unit, "rad");
  EXPECT_EQ(again.mistake->message, "no such column");
  EXPECT_THROW(read_outcome("{\"case\": 1"), std::runtime_error);
  EXPECT_THROW(read_job("{}"), std::runtime_error);
}

TEST(StudyJournal, KeepsWhatHappenedAndTheLastWordCounts)
{
  const StudyInFolder disk;
  {
    StudyJournal journal(disk.get_folder(), disk.study);
    EXPECT_TRUE(journal.outcomes().empty());
    CaseOutcome failed = make_outcome(2, "");
    failed.status = "failed";
    failed.results.clear();
    journal.add(failed);
    journal.add(make_outcome(1, "0.5"));
    journal.add(make_outcome(2, "0.25"));
  }
  const StudyJournal journal(disk.get_folder(), disk.study);
  ASSERT_EQ(journal.outcomes().size(), 2u);
  EXPECT_EQ(journal.outcomes().at(1).results.at(0).text, "0.5");
  EXPECT_EQ(journal.outcomes().at(2).status, "completed");
}

TEST(StudyJournal, DropsALineThatWasNotFinished)
{
  const StudyInFolder disk;
  {
    StudyJournal journal(disk.get_folder(), disk.study);
    journal.add(make_outcome(1, "0.5"));
  }
  std::ofstream(disk.get_folder().journal(), std::ios::app)
      << "{\"case\":2,\"status\":\"comp";
  {
    StudyJournal journal(disk.get_folder(), disk.study);
    EXPECT_EQ(journal.outcomes().size(), 1u);
    journal.add(make_outcome(3, "0.125"));
  }
  const StudyJournal journal(disk.get_folder(), disk.study);
  EXPECT_EQ(journal.outcomes().size(), 2u);
  EXPECT_EQ(journal.outcomes().count(3), 1u);
}

TEST(StudyJournal, ResultsOfOtherQuestionsAreForgotten)
{
  StudyInFolder disk;
  {
    StudyJournal journal(disk.get_folder(), disk.study);
    journal.add(make_outcome(1, "0.5"));
  }
  disk.study.content.results[0].from = "1";
  {
    StudyJournal journal(disk.get_folder(), disk.study);
    EXPECT_TRUE(journal.outcomes().at(1).results.empty());
    journal.add(make_outcome(1, "0.75"));
  }
  const StudyJournal journal(disk.get_folder(), disk.study);
  EXPECT_EQ(journal.outcomes().at(1).results.at(0).text, "0.75");
}

TEST(StudyJournal, RefusesTheFolderOfAnotherStudy)
{
  StudyInFolder disk;
  {
    const StudyJournal journal(disk.get_folder(), disk.study);
  }
  disk.study.identity.parameters["Vary stretch/Values"] = "2, 3";
  try
  {
    const StudyJournal journal(disk.get_folder(), disk.study);
    FAIL() << "accepted";
  }
  catch (const BadInput& problem)
  {
    EXPECT_NE(problem.message().find("'Vary stretch/Values' was '2, 3, 4'"),
              std::string::npos)
        << problem.message();
  }
}

TEST(StudyJournal, HasOneWriterAtATime)
{
  const StudyInFolder disk;
  const StudyJournal journal(disk.get_folder(), disk.study);
  EXPECT_THROW(StudyJournal(disk.get_folder(), disk.study), BadInput);
  EXPECT_THROW(prepare_folder(disk.get_folder(), true), BadInput);
}

TEST(StudyFolder, IsNotThatOfARun)
{
  const StudyInFolder disk;
  replace_file(disk.get_folder().get("run.json"), "{}");
  EXPECT_THROW(prepare_folder(disk.get_folder(), true), BadInput);
}

TEST(StudyTable, HasARowForEachCaseThatHasEnded)
{
  const StudyInFolder disk;
  CaseOutcome failed = make_outcome(3, "");
  failed.status = "failed";
  failed.reason = "too stiff, too thin";
  failed.results.clear();
  failed.time_reached.reset();
  const CaseOutcomes outcomes = {{1, make_outcome(1, "0.5")}, {3, failed}};
  std::istringstream table(
      make_study_table({disk.study.content, disk.study.cases, outcomes}));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "case [1],stretch,angle [rad],time reached [s],seconds [s],"
                  "status,reason,folder");
  std::getline(table, line);
  EXPECT_EQ(line, "1,2,0.5,2.5,0.125,completed,,cases/stretch=2");
  std::getline(table, line);
  EXPECT_EQ(
      split_csv_line(line),
      (std::vector<std::string>{"3", "4", "", "", "0.125", "failed",
                                "too stiff, too thin", "cases/stretch=4"}));
  EXPECT_FALSE(std::getline(table, line));
}

TEST(StudyTable, CountsAndNamesWhatFailed)
{
  const StudyInFolder disk;
  CaseOutcome refused = make_outcome(2, "");
  refused.status = "refused";
  refused.reason = "too thin";
  const CaseOutcomes outcomes = {{1, make_outcome(1, "0.5")}, {2, refused}};
  const StudyState state{disk.study.content, disk.study.cases, outcomes};
  const StudyCounts counts = count_outcomes(state);
  EXPECT_EQ(counts.total, 3u);
  EXPECT_EQ(counts.done, 1u);
  EXPECT_EQ(counts.refused, 1u);
  EXPECT_EQ(counts.failed, 0u);
  const std::string json = make_study_json(state, true, 1.5);
  for (const char* part : {"interrupted", "too thin", "\"angle\"", "\"rad\""})
    EXPECT_NE(json.find(part), std::string::npos) << part;
}

TEST(CsvFile, LinesReadBackAsTheyWere)
{
  const std::vector<std::string> fields = {"a", "", "b, c", "say \"d\"", "e"};
  std::string line = make_csv_line(fields);
  line.pop_back();
  EXPECT_EQ(split_csv_line(line), fields);
}
