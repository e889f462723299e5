#pragma once

#include <taut/structure/watches.h>
#include <taut/study/film_rows.h>
#include <taut/study/output_times.h>
#include <taut/study/run.h>
#include <taut/time/continuation.h>

#include <chrono>
#include <cmath>

namespace taut::study
{
/// One run of a film case.
class FilmRun
{
public:
  FilmRun(const Case& run_case, structure::Structure& structure,
          RunOutput& output, const std::optional<StateVisit>& visit);

  RunSummary run(const std::optional<Checkpoint>& resume);

private:
  void start(const std::optional<Checkpoint>& resume);
  void advance();
  void visit_state();
  void follow_path();
  void continue_path();
  void integrate();
  time::Schedule make_schedule() const;
  time::Observer make_observer();
  void write(double time, const double* state, bool is_last);
  void write_row(double time, const double* state);
  void write_frame(double time, const double* state);
  void write_event(const time::Event& event, const double* state);
  void write_checkpoint(double time, const double* state);
  void set_path_state(double time, const double* u);
  void watch_path(double time);
  void observe_path(double time, const double* u);
  bool observe_continuation(const time::CurvePoint& point);
  std::vector<Column> make_columns() const;
  void fail(const std::string& reason);
  void finish(std::chrono::steady_clock::time_point began);

  const Case& case_;
  RunOutput& output_;
  const std::optional<StateVisit> visit_;
  std::unique_ptr<structure::StructureSystem> system_;
  structure::Probes probes_;
  structure::Watches watches_;
  FilmRows rows_;
  const std::vector<double> history_times_, field_times_;
  std::vector<double> state_;
  RunProgress progress_;
  RunSummary summary_;
  /// Counters of the way to the rest shape.
  std::map<std::string, double> rest_shape_;
  /// Of the watches, at the last point of a static path.
  std::vector<double> margins_;
  /// In the columns that a continuation adds.
  std::vector<double> path_values_;
  double last_row_ = std::nan(""), last_frame_ = std::nan("");
  bool resumed_ = false;
};
} // namespace taut::study
