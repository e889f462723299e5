#include <taut/base/exceptions.h>
#include <taut/io/events_writer.h>
#include <taut/io/files.h>
#include <taut/io/history_writer.h>
#include <taut/io/run_results.h>

#include <gtest/gtest.h>

#include "io/small_case.h"

using namespace taut;
using namespace taut::io;
using namespace taut::io::testing;
using study::Statistic;

namespace
{
RecordedRun make_run()
{
  RecordedRun run;
  run.columns = {{"time", "s"}, {"angle, left", "rad"}};
  run.rows = {{0, 1}, {1, 4}, {2, 2}};
  run.events = {{"far", "probe_above", 0.5, 3}, {"far", "probe_above", 1.5, 4}};
  run.read_summary = []
  {
    return R"({"status": "completed",
               "motion": {"class": "periodic", "period": 0.25, "gap": null},
               "modes": {"stable": true, "frequencies": [3.5, 4.5]}})";
  };
  return run;
}

ResultValue compute(const std::string& of,
                    const Statistic statistic = Statistic::final,
                    const double from = -1e9)
{
  study::ResultRequest request;
  request.of = of;
  request.statistic = statistic;
  request.from = from;
  return compute_result(make_run(), request, {"far", "near"});
}

std::string get_refusal(const std::string& of,
                        const Statistic statistic = Statistic::final)
{
  try
  {
    compute(of, statistic);
  }
  catch (const BadInput& problem)
  {
    return problem.message();
  }
  return "accepted";
}
} // namespace

TEST(RunResults, OfColumnsHaveTheirUnit)
{
  EXPECT_EQ(compute("angle, left").text, "2");
  EXPECT_EQ(compute("angle, left").unit, "rad");
  EXPECT_EQ(compute("angle, left", Statistic::time_of_maximum).text, "1");
  EXPECT_EQ(compute("angle, left", Statistic::time_of_maximum).unit, "s");
  EXPECT_EQ(compute("angle, left", Statistic::maximum, 3).text, "");
}

TEST(RunResults, OfEventsAreThoseOfTheFirst)
{
  EXPECT_EQ(compute("event far", Statistic::time).text, "0.5");
  EXPECT_EQ(compute("event far", Statistic::value).text, "3");
  EXPECT_EQ(compute("event far", Statistic::value, 1).text, "4");
  // It may happen in another case.
  EXPECT_EQ(compute("event near", Statistic::time).text, "");
}

TEST(RunResults, OfTheSummaryAreNumbersOrWords)
{
  EXPECT_EQ(compute("motion/class").text, "periodic");
  EXPECT_EQ(compute("motion/period").text, "0.25");
  EXPECT_EQ(compute("modes/frequencies/1").text, "4.5");
  EXPECT_EQ(compute("modes/stable").text, "true");
  // What one motion has another may lack.
  EXPECT_EQ(compute("motion/gap").text, "");
  EXPECT_EQ(compute("motion/exponent").text, "");
  EXPECT_EQ(compute("modes/frequencies/7").text, "");
}

TEST(RunResults, RefuseWhatNoRunOfTheCaseHas)
{
  EXPECT_NE(get_refusal("angle, lefd").find("did you mean 'angle, left'?"),
            std::string::npos);
  EXPECT_NE(get_refusal("motions/class").find("known are"), std::string::npos);
  EXPECT_NE(
      get_refusal("event fat", Statistic::time).find("did you mean 'far'?"),
      std::string::npos);
  EXPECT_NE(get_refusal("modes/frequencies").find("add /0"), std::string::npos);
  EXPECT_NE(get_refusal("motion").find("no single value"), std::string::npos);
  EXPECT_NE(get_refusal("motion/period", Statistic::mean).find("no statistic"),
            std::string::npos);
}

TEST(RunResults, FromTheFolderAreThoseFromMemory)
{
  const CaseOnDisk disk("set Title = a");
  const OutputFolder folder{disk.folder().string()};
  const RecordedRun run = make_run();
  HistoryWriter history(folder.history(), run.columns);
  for (const auto& row : run.rows)
    history.write(row);
  EventsWriter events(folder.events());
  for (const RecordedEvent& event : run.events)
  {
    study::EventRecord record;
    record.name = event.name;
    record.kind = event.kind;
    record.place = "a, \"b\"";
    record.time = event.time;
    record.value = event.value;
    events.write(record);
  }
  replace_file(folder.summary(), run.read_summary());
  const RecordedRun read = read_run(folder);
  EXPECT_EQ(read.rows, run.rows);
  EXPECT_EQ(read.columns[1].name, "angle, left");
  EXPECT_EQ(read.columns[1].unit, "rad");
  ASSERT_EQ(read.events.size(), 2u);
  EXPECT_EQ(read.events[1].kind, "probe_above");
  EXPECT_EQ(read.events[1].time, 1.5);
  EXPECT_EQ(read.events[1].value, 4);
  EXPECT_EQ(read.read_summary(), run.read_summary());
}

TEST(RunResults, NeedAWholeHistory)
{
  const CaseOnDisk disk("set Title = a");
  const OutputFolder folder{disk.folder().string()};
  EXPECT_THROW(read_run(folder), BadInput);
  replace_file(folder.history(), "time [s],angle [rad]\n0,1\n1\n");
  EXPECT_THROW(read_run(folder), BadInput);
}

TEST(RecordingOutput, KeepsRowsAndEvents)
{
  RecordedRun run;
  RecordingOutput output(run);
  output.begin({{"time", "s"}});
  output.write_row({0.5});
  study::EventRecord event;
  event.name = "far";
  event.time = 0.25;
  output.write_event(event);
  EXPECT_EQ(run.columns.at(0).name, "time");
  EXPECT_EQ(run.rows.at(0).at(0), 0.5);
  EXPECT_EQ(run.events.at(0).time, 0.25);
  EXPECT_FALSE(output.wants_checkpoint());
}

TEST(RunResults, ARunThatAnEventHasStoppedMayLackWhatItShouldFindOut)
{
  RecordedRun run = make_run();
  run.read_summary = [] { return R"({"status": "event"})"; };
  study::ResultRequest request;
  request.of = "modes/frequencies/0";
  EXPECT_EQ(compute_result(run, request, {}).text, "");
  run.read_summary = [] { return R"({"status": "completed"})"; };
  EXPECT_THROW(compute_result(run, request, {}), BadInput);
}
