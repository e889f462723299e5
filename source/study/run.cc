#include <taut/base/exceptions.h>

#include <algorithm>
#include <set>

#include "motion_recorder.h"
#include "run_continuation.h"
#include "run_events.h"
#include "run_film.h"
#include "run_notes.h"
#include "run_rest_shape.h"

namespace taut::study
{
namespace
{
using Clock = std::chrono::steady_clock;
using structure::Analysis;

std::unique_ptr<structure::StructureSystem>
make_system(const Case& run_case, structure::Structure& structure)
{
  if (run_case.procedure.analysis == Analysis::transient)
    return std::make_unique<structure::InertialSystem>(structure);
  time::PathOptions path;
  path.newton.tolerance = run_case.procedure.newton_tolerance;
  return std::make_unique<structure::QuasiStaticSystem>(structure, path);
}

bool is_path(const Case& run_case)
{
  const Analysis analysis = run_case.procedure.analysis;
  return analysis == Analysis::equilibrium ||
         analysis == Analysis::continuation;
}

/// Static paths of relaxed films stay relaxed.
structure::Networks get_networks(const Case& run_case)
{
  return is_path(run_case) &&
                 run_case.procedure.start == structure::Start::relaxed
             ? structure::Networks::relaxed
             : structure::Networks::as_given;
}

} // namespace

FilmRun::FilmRun(const Case& run_case, structure::Structure& structure,
                 RunOutput& output, const std::optional<StateVisit>& visit)
    : case_(run_case), output_(output), visit_(visit),
      system_(make_system(run_case, structure)), probes_(*system_),
      watches_(*system_, probes_, get_networks(run_case)),
      rows_(*system_, probes_, watches_, !is_path(run_case)),
      history_times_(make_history_times(run_case)),
      field_times_(make_output_times(run_case.procedure,
                                     run_case.output.field_intervals,
                                     run_case.output.field_times))
{
}

void FilmRun::start(const std::optional<Checkpoint>& resume)
{
  const ProcedureDescription& procedure = case_.procedure;
  if (resume)
  {
    progress_ = resume->progress;
    state_ = resume->state;
    system_->history().enter_interval(progress_.time);
    rows_.resume(progress_);
    last_row_ = last_frame_ = progress_.time;
    resumed_ = true;
    return;
  }
  progress_.time = procedure.start_time;
  if (procedure.shape == Shape::rest)
  {
    auto start = start_from_rest_shape(case_, *system_, rows_);
    state_ = start.state;
    rest_shape_ = start.counters;
    summary_.notes = start.notes;
    summary_.other_branch = start.other_branch;
  }
  else
  {
    time::PathOptions options;
    options.newton.tolerance = procedure.newton_tolerance;
    state_ = system_->make_initial_state(procedure.start_time, procedure.start,
                                         procedure.shape == Shape::equilibrium,
                                         options);
  }
  for (const std::string& note :
       make_start_notes(*system_, procedure.start_time, state_.data()))
    summary_.notes.push_back(note);
  rows_.begin(procedure.start_time, state_.data());
}

void FilmRun::write(const double time, const double* state, const bool is_last)
{
  const auto is_due = [&](const std::vector<double>& times)
  { return is_last || std::binary_search(times.begin(), times.end(), time); };
  // The last time of a run may also be one of its output times, and the first
  // of a run that goes on is already written.
  if (is_due(history_times_) && time != last_row_)
    write_row(time, state);
  if (is_due(field_times_) && time != last_frame_)
    write_frame(time, state);
}

void FilmRun::write_row(const double time, const double* state)
{
  last_row_ = time;
  summary_.final_row = rows_.make_row(time, state);
  summary_.final_row.insert(summary_.final_row.end(), path_values_.begin(),
                            path_values_.end());
  output_.write_row(summary_.final_row);
  ++progress_.history_rows;
}

void FilmRun::write_frame(const double time, const double* state)
{
  if (!case_.output.write_fields)
    return;
  last_frame_ = time;
  output_.write_fields(time, *system_, state);
  ++progress_.field_frames;
}

std::vector<Column> FilmRun::make_columns() const
{
  auto columns = rows_.make_columns();
  if (case_.procedure.analysis == Analysis::continuation)
    for (const Column& column : make_continuation_columns())
      columns.push_back(column);
  return columns;
}

void FilmRun::write_event(const time::Event& event, const double* state)
{
  const auto& description = system_->structure().device().events[event.watch];
  // What was active when the run was cut has been reported before.
  if (event.at_start && resumed_ && !description.fatal)
    return;
  const EventRecord record = make_event_record(
      description, event, watches_.report(event.watch, event.time, state));
  output_.write_event(record);
  ++progress_.event_rows;
  if (description.fatal)
    summary_.reason = "event '" + description.name + "' in " + record.place;
}

void FilmRun::write_checkpoint(const double time, const double* state)
{
  progress_.time = time;
  rows_.save(progress_);
  output_.write_checkpoint(progress_, *system_, state);
}

time::Schedule FilmRun::make_schedule() const
{
  const ProcedureDescription& procedure = case_.procedure;
  time::Schedule schedule;
  schedule.start = progress_.time;
  schedule.end = procedure.end_time;
  std::set<double> times(history_times_.begin(), history_times_.end());
  times.insert(field_times_.begin(), field_times_.end());
  for (const double time : times)
    if (time >= schedule.start)
      schedule.output_times.push_back(time);
  schedule.restart_every_steps = case_.checkpoint.every_steps;
  const double every = case_.checkpoint.every_time;
  if (every > 0)
    for (long i = 1; procedure.start_time + i * every < schedule.end; ++i)
      if (procedure.start_time + i * every > schedule.start)
        schedule.restart_times.push_back(procedure.start_time + i * every);
  return schedule;
}

time::Observer FilmRun::make_observer()
{
  time::Observer observer;
  observer.output = [this](const double time, const double* state)
  { write(time, state, time == case_.procedure.end_time); };
  observer.step = [this](const time::Step& step,
                         const time::IntegratorStatistics& statistics)
  {
    ++progress_.steps;
    output_.report_step(step, statistics, rows_.balance_relative());
    if (output_.wants_checkpoint())
      write_checkpoint(step.end(), step.state());
  };
  observer.event = [this](const time::Event& event, const double* state)
  { write_event(event, state); };
  observer.armed = [this](const std::vector<bool>& armed)
  { progress_.armed_events = armed; };
  observer.interrupted = [this] { return output_.interrupted(); };
  observer.checkpoint = [this](const double time, const double* state)
  { write_checkpoint(time, state); };
  return observer;
}

void FilmRun::integrate()
{
  auto watches = watches_.make_time_watches();
  for (std::size_t i = 0; i < progress_.armed_events.size(); ++i)
    watches.at(i).is_armed = progress_.armed_events[i];
  const auto result = time::integrate(*system_, state_.data(), make_schedule(),
                                      case_.procedure.integrator, watches,
                                      make_observer(), &progress_.time);
  const auto& statistics = result.statistics;
  progress_.time = result.time;
  summary_.counters = {{"steps", statistics.steps},
                       {"rejected_by_error", statistics.rejected_by_error},
                       {"rejected_by_newton", statistics.rejected_by_newton},
                       {"evaluations", statistics.evaluations},
                       {"factorisations", statistics.factorisations},
                       {"solves", statistics.solves},
                       {"newton_iterations", statistics.newton_iterations}};
  if (result.outcome == time::Outcome::stopped_by_event)
    summary_.status = Status::event;
  if (result.outcome == time::Outcome::interrupted)
  {
    summary_.status = Status::interrupted;
    summary_.reason = "interrupted";
    write_checkpoint(result.time, state_.data());
  }
  if (result.outcome != time::Outcome::completed)
    write(result.time, state_.data(), true);
}

void FilmRun::fail(const std::string& reason)
{
  summary_.status = Status::failed;
  summary_.reason = reason;
  // The state is the last one that converged, if there is one.
  if (!state_.empty() && progress_.steps > 0)
    write(progress_.time, state_.data(), true);
}

void FilmRun::finish(const Clock::time_point began)
{
  summary_.time_reached = progress_.time;
  summary_.columns = make_columns();
  summary_.balance_absolute = rows_.balance_absolute();
  summary_.balance_relative = rows_.balance_relative();
  // A path through equilibria has no time in which work could be summed.
  if (case_.procedure.analysis == Analysis::equilibrium ||
      case_.procedure.analysis == Analysis::continuation)
    summary_.balance_absolute = summary_.balance_relative = std::nan("");
  summary_.counters.insert(rest_shape_.begin(), rest_shape_.end());
  summary_.counters["unknowns"] = system_->structure().n_free_global();
  summary_.timings["run"] =
      std::chrono::duration<double>(Clock::now() - began).count();
}

void FilmRun::advance()
{
  if (visit_ && visit_->at_start)
    write(progress_.time, state_.data(), true);
  else if (case_.procedure.analysis == Analysis::equilibrium)
    follow_path();
  else if (case_.procedure.analysis == Analysis::continuation)
    continue_path();
  else
    integrate();
}

void FilmRun::visit_state()
{
  if (visit_ && summary_.status == Status::completed)
    visit_->visit(progress_.time, *system_, state_, summary_);
}

RunSummary FilmRun::run(const std::optional<Checkpoint>& resume)
{
  const auto began = Clock::now();
  output_.begin(make_columns());
  try
  {
    start(resume);
    advance();
    visit_state();
  }
  catch (const SolverFailed& failure)
  {
    fail(failure.what());
  }
  catch (const StepRejected& failure)
  {
    fail(failure.what());
  }
  finish(began);
  return summary_;
}

RunSummary run_film(const Case& run_case, structure::Structure& structure,
                    RunOutput& output, const std::optional<Checkpoint>& resume,
                    const std::optional<StateVisit>& visit)
{
  return record_motion(
      run_case, output,
      [&](RunOutput& recorded)
      { return FilmRun(run_case, structure, recorded, visit).run(resume); });
}
} // namespace taut::study
