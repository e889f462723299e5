// history.csv, events.csv, run.json and the folder that holds them.
#include <taut/base/exceptions.h>
#include <taut/io/csv_file.h>
#include <taut/io/events_writer.h>
#include <taut/io/files.h>
#include <taut/io/history_writer.h>
#include <taut/io/motion_writer.h>
#include <taut/io/output_folder.h>
#include <taut/io/run_summary.h>

#include <gtest/gtest.h>

#include <cmath>

#include "io/output_files.h"
#include <nlohmann/json.hpp>

namespace taut::io
{
namespace
{
using testing::SharedFolder;

const std::vector<study::Column> columns{
    {"time", "s"}, {"lift, tip", "m"}, {"stretch", "1"}};
const std::string header = "time [s],\"lift, tip [m]\",stretch [1]\n";

TEST(History, RowsAreOnDiskWhenWritten)
{
  const SharedFolder folder("history");
  HistoryWriter history(folder.get("history.csv"), columns);
  EXPECT_EQ(read_file(folder.get("history.csv")), header);
  history.write({0, 1. / 3, -2e-9});
  EXPECT_EQ(read_file(folder.get("history.csv")),
            header + "0,0.333333333333333,-2e-09\n");
}

TEST(History, IsCutToTheRowsOfTheCheckpoint)
{
  const SharedFolder folder("history_cut");
  const std::string file = folder.get("history.csv");
  {
    HistoryWriter history(file, columns);
    for (const double time : {0., 1., 2., 3.})
      history.write({time, 0, 0});
  }
  HistoryWriter resumed(file, columns, 2);
  resumed.write({1.5, 0, 0});
  EXPECT_EQ(read_file(file), header + "0,0,0\n1,0,0\n1.5,0,0\n");
}

TEST(History, OtherColumnsAndLostRowsAreRefused)
{
  const SharedFolder folder("history_refused");
  const std::string file = folder.get("history.csv");
  HistoryWriter(file, columns).write({0, 0, 0});
  EXPECT_THROW(HistoryWriter(file, {{"time", "s"}}, 1), BadInput);
  EXPECT_THROW(HistoryWriter(file, columns, 2), BadInput);
  EXPECT_THROW(HistoryWriter(folder.get("none.csv"), columns, 1), BadInput);
}

TEST(History, RowsAreReadBack)
{
  const SharedFolder folder("history_back");
  const std::string file = folder.get("history.csv");
  HistoryWriter history(file, columns);
  history.write({0, 1.5, -2e-9});
  history.write({1, std::nan(""), 3});
  const auto rows = read_rows(file, 2);
  EXPECT_EQ(rows.at(0), (std::vector<double>{0, 1.5, -2e-9}));
  EXPECT_TRUE(std::isnan(rows.at(1).at(1)));
  EXPECT_EQ(rows.at(1).at(2), 3);
  EXPECT_EQ(read_rows(file, 1).size(), 1u);
  EXPECT_TRUE(read_rows(folder.get("none.csv"), 0).empty());
  EXPECT_THROW(read_rows(file, 3), BadInput);
  replace_file(file, header + "0,one,2\n");
  EXPECT_THROW(read_rows(file, 1), BadInput);
}

study::Motion make_motion()
{
  study::Motion motion;
  motion.of = "lift, tip";
  motion.unit = "m";
  motion.verdict.motion_class = study::MotionClass::periodic;
  motion.verdict.period_number = 2;
  motion.section.add({1, 2, 3});
  motion.spectrum = {{0, 0.5}, {0, 0.25}};
  return motion;
}

TEST(MotionTables, HaveTheirUnits)
{
  const auto tables = make_motion_tables(make_motion());
  EXPECT_EQ(make_table_text(tables.at("section")),
            "time [s],\"lift, tip [m]\",\"rate of lift, tip [m/s]\"\n1,2,3\n");
  EXPECT_EQ(make_table_text(tables.at("spectrum")),
            "frequency [Hz],amplitude [m]\n0,0\n0.5,0.25\n");
}

TEST(MotionTables, VerdictIsInTheSummary)
{
  study::RunSummary summary;
  const auto parse = [&]
  { return nlohmann::json::parse(make_run_json(summary, {}, {})); };
  EXPECT_FALSE(parse().contains("motion"));
  summary.motion = make_motion();
  EXPECT_EQ(parse()["motion"]["class"], "periodic");
  EXPECT_EQ(parse()["motion"]["period_number"], 2);
  // What nobody measured is not there, and no number is null.
  EXPECT_FALSE(parse()["motion"].contains("lyapunov_exponent"));
  EXPECT_FALSE(parse()["motion"].contains("reproducible"));
  EXPECT_TRUE(parse()["motion"]["section_spread"].is_null());
  summary.motion->lyapunov = lumped::LyapunovExponent{-0.5, 0.25};
  summary.motion->reproducible = false;
  summary.motion->reproducible_until = 3;
  EXPECT_EQ(parse()["motion"]["lyapunov_exponent"], -0.5);
  EXPECT_EQ(parse()["motion"]["reproducible"], false);
  EXPECT_EQ(parse()["motion"]["reproducible_until"], 3);
}

TEST(Events, RowSaysWhatWhereAndWhen)
{
  const SharedFolder folder("events");
  study::EventRecord event;
  event.time = .5;
  event.name = "slack";
  event.kind = "tension_loss";
  event.place = "left + right";
  event.point = {{1, 2, 0}};
  event.direction.fill(std::nan(""));
  event.value = -1;
  event.margin = .25;
  event.fatal = true;
  EventsWriter(folder.get("events.csv")).write(event);
  const std::string content = read_file(folder.get("events.csv"));
  EXPECT_EQ(content.substr(content.find('\n') + 1),
            "0.5,slack,tension_loss,left + right,1,2,0,nan,nan,nan,-1,0,0.25,"
            "false,true\n");
}

TEST(RunSummary, HoldsTheKeysOfTheContract)
{
  study::RunSummary summary;
  summary.status = study::Status::event;
  summary.reason = "event 'slack' in left";
  summary.time_reached = .5;
  summary.columns = columns;
  summary.final_row = {.5, std::nan(""), 2};
  summary.counters["steps"] = 12;
  summary.balance_relative = 1e-7;
  const auto json = nlohmann::json::parse(make_run_json(
      summary, Machine{2, 1000}, {{"Film left/Thickness", "", "1e-3"}}));
  EXPECT_EQ(json["status"], "event");
  EXPECT_EQ(json["reason"], "event 'slack' in left");
  EXPECT_EQ(json["final"]["stretch"], 2);
  EXPECT_TRUE(json["final"]["lift, tip"].is_null());
  EXPECT_EQ(json["counters"]["steps"], 12);
  EXPECT_EQ(json["energy_balance"]["relative"], 1e-7);
  EXPECT_EQ(json["peak_memory_bytes"], 1000);
  EXPECT_EQ(json["parameters_changed"]["Film left/Thickness"]["value"], "1e-3");
  for (const char* name : {"taut", "deal.II", "PETSc", "SUNDIALS", "gmsh"})
    EXPECT_FALSE(json["versions"][name].get<std::string>().empty()) << name;
  // A BLAS is linked, so the loader knows its file.
  EXPECT_NE(json["versions"]["BLAS"].get<std::string>().find("blas"),
            std::string::npos);
}

TEST(OutputFolder, HoldsOneRun)
{
  const SharedFolder parent("folder");
  const OutputFolder folder{parent.get("run")};
  EXPECT_THROW(check_folder(folder, FolderUse::resume), BadInput);
  check_folder(folder, FolderUse::fresh);
  prepare_folder(folder, FolderUse::fresh);
  check_folder(folder, FolderUse::fresh);
  replace_file(folder.summary(), "{}");
  EXPECT_THROW(check_folder(folder, FolderUse::fresh), BadInput);
  EXPECT_THROW(check_folder(folder, FolderUse::resume), BadInput);
}

TEST(OutputFolder, ReplacingRemovesTheRunAndNothingElse)
{
  const SharedFolder parent("folder_replaced");
  const OutputFolder folder{parent.path()};
  replace_file(folder.summary(), "{}");
  replace_file(folder.get("notes.txt"), "mine");
  check_folder(folder, FolderUse::replace);
  prepare_folder(folder, FolderUse::replace);
  EXPECT_FALSE(std::filesystem::exists(folder.summary()));
  EXPECT_EQ(read_file(folder.get("notes.txt")), "mine");
}

TEST(OutputFolder, ResumingKeepsAllButTheSummary)
{
  const SharedFolder parent("folder_resumed");
  const OutputFolder folder{parent.path()};
  std::filesystem::create_directories(folder.checkpoint());
  for (const std::string& file :
       {folder.get("checkpoint/state"), folder.history(), folder.summary()})
    replace_file(file, "old");
  check_folder(folder, FolderUse::resume);
  prepare_folder(folder, FolderUse::resume);
  EXPECT_EQ(read_file(folder.history()), "old");
  EXPECT_EQ(read_file(folder.get("checkpoint/state")), "old");
  EXPECT_FALSE(std::filesystem::exists(folder.summary()));
}

TEST(OutputFolder, AFileInItsPlaceIsRefused)
{
  const SharedFolder parent("folder_file");
  replace_file(parent.get("run"), "");
  EXPECT_THROW(prepare_folder({parent.get("run")}, FolderUse::fresh), BadInput);
}
} // namespace
} // namespace taut::io
