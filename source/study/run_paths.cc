#include <algorithm>
#include <set>

#include "run_continuation.h"
#include "run_film.h"

namespace taut::study
{
void FilmRun::set_path_state(const double time, const double* u)
{
  std::copy(u, u + system_->structure().n_free(), state_.begin());
  if (case_.procedure.start == structure::Start::relaxed)
    system_->set_relaxed(time, state_.data());
  system_->set_circuits_at_rest(time, state_.data());
}

void FilmRun::watch_path(const double time)
{
  const auto watches = watches_.make_time_watches();
  margins_.resize(watches.size(), 1.);
  for (std::size_t i = 0; i < watches.size(); ++i)
  {
    const double margin = watches[i].value(time, state_.data());
    if (margin < 0 && !(margins_[i] < 0))
    {
      write_event({i, time, time == case_.procedure.start_time}, state_.data());
      if (watches[i].fatal)
        summary_.status = Status::event;
    }
    // What has not recovered counts as it was.
    if (margin < 0 || margin > watches[i].recovered)
      margins_[i] = margin;
  }
}

void FilmRun::observe_path(const double time, const double* u)
{
  set_path_state(time, u);
  write(time, state_.data(), true);
  watch_path(time);
}

bool FilmRun::observe_continuation(const time::CurvePoint& point)
{
  progress_.time = point.parameter;
  ++progress_.steps;
  set_path_state(point.parameter, point.u);
  path_values_ = make_continuation_values(point);
  write_row(point.parameter, state_.data());
  // The frames of a path are those asked for and those that are special.
  if (point.kind != time::CurvePoint::Kind::regular ||
      std::binary_search(field_times_.begin(), field_times_.end(),
                         point.parameter))
    write_frame(point.parameter, state_.data());
  watch_path(point.parameter);
  return summary_.status == Status::completed && !output_.interrupted();
}

void FilmRun::continue_path()
{
  std::vector<double> u(state_.begin(),
                        state_.begin() + system_->structure().n_free());
  std::set<double> parameters(field_times_.begin(), field_times_.end());
  parameters.insert(case_.output.history_times.begin(),
                    case_.output.history_times.end());
  const auto report =
      follow_continuation(case_, *system_, system_->internal(state_.data()),
                          u.data(), {parameters.begin(), parameters.end()},
                          {[this](const time::CurvePoint& point)
                           { return observe_continuation(point); },
                           [this](const EventRecord& record)
                           {
                             output_.write_event(record);
                             ++progress_.event_rows;
                           }});
  summary_.counters = report.counters;
  summary_.notes.insert(summary_.notes.end(), report.notes.begin(),
                        report.notes.end());
}

void FilmRun::follow_path()
{
  const ProcedureDescription& procedure = case_.procedure;
  structure::Equilibrium problem(system_->structure(), system_->history(),
                                 procedure.start == structure::Start::relaxed
                                     ? structure::Networks::relaxed
                                     : structure::Networks::as_given,
                                 system_->internal(state_.data()));
  observe_path(procedure.start_time, state_.data());
  std::vector<double> u(state_.begin(),
                        state_.begin() + system_->structure().n_free());
  // Load steps end at the kinks of the signals and where a row is asked for,
  // too.
  std::set<double> ends{procedure.end_time};
  const double length = procedure.end_time - procedure.start_time;
  for (unsigned int i = 1; i < procedure.load_steps; ++i)
    ends.insert(procedure.start_time + length * i / procedure.load_steps);
  for (const double kink :
       system_->stop_times(procedure.start_time, procedure.end_time))
    ends.insert(kink);
  for (const auto* times :
       {&case_.output.history_times, &case_.output.field_times})
    for (const double time : *times)
      if (time > procedure.start_time && time < procedure.end_time)
        ends.insert(time);
  time::PathOptions options;
  options.newton.tolerance = procedure.newton_tolerance;
  time::EquilibriumStatistics total;
  for (const double end : ends)
  {
    if (summary_.status != Status::completed || output_.interrupted())
      break;
    options.first_step = options.largest_step = end - progress_.time;
    options.smallest_step = 1e-6 * options.first_step;
    const auto statistics = time::follow_path(
        problem, progress_.time, end, u.data(), options,
        [&](const double time, const double*) { progress_.time = time; });
    total.iterations += statistics.iterations;
    total.factorisations += statistics.factorisations;
    total.residuals += statistics.residuals;
    ++progress_.steps;
    observe_path(end, u.data());
    system_->history().enter_interval(end);
  }
  summary_.counters = {{"steps", progress_.steps},
                       {"newton_iterations", total.iterations},
                       {"factorisations", total.factorisations},
                       {"evaluations", total.residuals}};
}
} // namespace taut::study
