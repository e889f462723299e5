#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/lumped/demes_run.h>
#include <taut/lumped/demes_statics.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "demes_stepper.h"
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace taut::lumped
{
namespace
{
const double pi = std::acos(-1.);
constexpr double infinity = std::numeric_limits<double>::infinity();

void validate_start(const Demes& demes, const DemesState& start)
{
  if (!(start.inner_stretch > 0) || !std::isfinite(start.inner_stretch))
    throw BadInput("the inner stretch at the start must be positive, got " +
                   number_text(start.inner_stretch));
  const double chord = compute_chord(start.angle, demes.eccentricity).value;
  if (!(std::abs(start.angle) < pi && chord > 0) ||
      !std::isfinite(start.velocity))
    throw BadInput("the ends of the frame must stay apart at the start: the "
                   "angle must lie between -pi and pi, got " +
                   number_text(start.angle) + " with velocity " +
                   number_text(start.velocity));
}

bool is_straight(const Demes& demes, const DemesState& start)
{
  return demes.eccentricity == 0 && demes.rest_angle == 0 && start.angle == 0;
}

class Run
{
public:
  Run(const Demes& demes, const DemesRunOptions& options)
      : demes_(demes), options_(options),
        stepper_(demes, options, result_.statistics),
        next_output_(std::upper_bound(options.output_times.begin(),
                                      options.output_times.end(),
                                      options.start_time))
  {
  }

  DemesRun run()
  {
    DemesState state = options_.start;
    double begin = options_.start_time;
    for (const double end : make_segment_ends())
    {
      enter_segment(begin, end, state);
      while (stepper_.get_time() < end && !result_.stop)
        advance(end);
      state = stepper_.get_state();
      begin = end;
      if (result_.stop)
        break;
    }
    if (!result_.stop && result_.rows.back().time < options_.end_time)
      write(make_row(options_.end_time, {state, 0, 0}));
    add_notes();
    return std::move(result_);
  }

private:
  std::vector<double> make_segment_ends() const
  {
    std::vector<double> ends = stepper_.get_kinks();
    ends.push_back(options_.end_time);
    return ends;
  }

  void enter_segment(const double begin, const double end,
                     const DemesState& state)
  {
    const bool first = begin == options_.start_time;
    const double stretch = compute_stretch(state.angle);
    const double before = stepper_.get_drive(begin);
    stepper_.start(begin, end, state);
    // A jump of the drive meets a frame that stands still meanwhile: the work
    // of the source is what the electric energy loses.
    if (!first)
      source_work_ +=
          compute_electric(demes_, stretch, before).energy -
          compute_electric(demes_, stretch, stepper_.get_drive(begin)).energy;
    const DemesRow row = make_row(begin, {state, 0, 0});
    if (first || is_due(begin))
      write(row);
    while (is_due(begin))
      ++next_output_;
    watch_force(begin, row.membrane_force);
    if (row.membrane_force <= 0 && (first || force_ > 0))
      report(row, first);
    force_ = row.membrane_force;
  }

  void advance(const double segment_end)
  {
    if (result_.statistics.steps >= options_.max_steps)
      throw SolverFailed(
          "more than " + std::to_string(options_.max_steps) +
          " time steps, stopped at tau = " + number_text(stepper_.get_time()));
    stepper_.advance();
    for (int i = 1; i <= RadauRule::n && !result_.stop; ++i)
    {
      const double force = stepper_.get_point_force(i);
      if (force_ > 0 && force <= 0)
        cross(stepper_.get_point_time(i - 1), stepper_.get_point_time(i));
      force_ = force;
    }
    if (result_.stop)
      return;
    find_smallest_force();
    write_until(stepper_.get_time(), segment_end);
    const DemesMoment end = stepper_.interpolate(stepper_.get_time());
    dissipated_ += end.dissipated;
    source_work_ += end.source_work;
  }

  /// The force falls through zero between two times of the last step.
  void cross(const double begin, const double end)
  {
    std::uintmax_t iterations = 100;
    const auto force = [&](const double time) { return compute_force(time); };
    const double time =
        compute_force(begin) > 0 && compute_force(end) < 0
            ? boost::math::tools::toms748_solve(
                  force, begin, end,
                  boost::math::tools::eps_tolerance<double>(), iterations)
                  .second
            : end;
    write_until(time, infinity);
    report(make_row(time, stepper_.interpolate(time)), false);
  }

  void report(const DemesRow& row, const bool at_start)
  {
    result_.events.push_back({at_start, row});
    if (at_start || !options_.stop_at_compression)
      return;
    result_.stop = result_.events.back();
    watch_force(row.time, row.membrane_force);
    if (result_.rows.back().time < row.time)
      write(row);
  }

  /// Looks between the points of the last step if it comes close.
  void find_smallest_force()
  {
    int lowest = 0, highest = 0;
    const auto get = [&](const int i) { return stepper_.get_point_force(i); };
    for (int i = 1; i <= RadauRule::n; ++i)
    {
      lowest = get(i) < get(lowest) ? i : lowest;
      highest = get(i) > get(highest) ? i : highest;
    }
    // Between points so close to each other it falls by less than that.
    const double margin = 0.1 * (get(highest) - get(lowest));
    if (!(get(lowest) - margin < result_.smallest_force))
      return;
    watch_force(stepper_.get_point_time(lowest), get(lowest));
    const auto [time, value] = boost::math::tools::brent_find_minima(
        [&](const double time) { return compute_force(time); },
        stepper_.get_point_time(std::max(lowest - 1, 0)),
        stepper_.get_point_time(std::min(lowest + 1, RadauRule::n)),
        std::numeric_limits<double>::digits / 2);
    watch_force(time, value);
  }

  void watch_force(const double time, const double force)
  {
    if (!(force < result_.smallest_force))
      return;
    result_.smallest_force = force;
    result_.smallest_force_time = time;
  }

  double compute_stretch(const double angle) const
  {
    return demes_.pre_stretch * compute_chord(angle, demes_.eccentricity).value;
  }

  double compute_force(const double time) const
  {
    const DemesState state = stepper_.interpolate(time).state;
    return compute_membrane_force(demes_, compute_stretch(state.angle),
                                  state.inner_stretch,
                                  stepper_.get_drive(time));
  }

  bool is_due(const double time) const
  {
    return next_output_ != options_.output_times.end() && *next_output_ <= time;
  }

  /// Outputs of the last step; those at the end of a segment wait for the jump
  /// there.
  void write_until(const double time, const double segment_end)
  {
    const bool last = segment_end == options_.end_time;
    while (is_due(time) && (*next_output_ < segment_end || last))
    {
      const double due = *next_output_++;
      write(make_row(due, stepper_.interpolate(due)));
    }
  }

  void write(const DemesRow& row)
  {
    result_.rows.push_back(row);
  }

  DemesRow make_row(const double time, const DemesMoment& moment) const
  {
    const DemesState& state = moment.state;
    DemesRow row;
    row.time = time;
    row.angle = state.angle;
    row.velocity = state.velocity;
    row.inner_stretch = state.inner_stretch;
    row.stretch = compute_stretch(state.angle);
    row.drive = stepper_.get_drive(time);
    row.conjugate = compute_electric(demes_, row.stretch, row.drive).conjugate;
    row.membrane_force = compute_membrane_force(demes_, row.stretch,
                                                state.inner_stretch, row.drive);
    row.kinetic_energy = state.velocity * state.velocity / 2;
    row.free_energy = compute_free_energy(demes_, state.angle,
                                          state.inner_stretch, row.drive);
    row.dissipated_energy = dissipated_ + moment.dissipated;
    row.source_work = source_work_ + moment.source_work;
    return row;
  }

  void add_notes()
  {
    const DemesState& start = options_.start;
    if (is_straight(demes_, start) && start.velocity == 0)
      result_.notes.push_back(explain_flatness());
    else if (std::abs(start.angle) < 0.1 &&
             start.inner_stretch == demes_.pre_stretch)
      result_.notes.push_back(
          "The run starts next to the straight frame: seed angle " +
          number_text(start.angle) + " rad, velocity " +
          number_text(start.velocity) + ", eccentricity " +
          number_text(demes_.eccentricity) + ".");
    if (result_.smallest_force < 0)
      result_.notes.push_back(
          "The film pushes, where a real one goes slack: its force falls to " +
          number_text(result_.smallest_force) +
          " at tau = " + number_text(result_.smallest_force_time) + ".");
  }

  std::string explain_flatness() const
  {
    const double critical = compute_critical_pre_stretch(demes_);
    if (demes_.pre_stretch <= critical)
      return "The frame stays flat: its pre-stretch " +
             number_text(demes_.pre_stretch) + " does not exceed " +
             number_text(critical) + ", at which the film bends it.";
    return "The frame stays flat: the straight frame without eccentricity is "
           "an equilibrium, and a start exactly in it at rest never leaves it. "
           "Give a seed angle, a velocity or an eccentricity.";
  }

  const Demes& demes_;
  const DemesRunOptions& options_;
  DemesRun result_{{}, {}, {}, infinity, 0, {}, {}};
  DemesStepper stepper_;
  std::vector<double>::const_iterator next_output_;
  /// Force at the last point, and exchanges before the last step.
  double force_ = infinity;
  double dissipated_ = 0;
  double source_work_ = 0;
};
} // namespace

void validate(const DemesRunOptions& options)
{
  if (!(options.end_time >= options.start_time) ||
      !std::isfinite(options.end_time))
    throw BadInput("a run must end after it starts, not go from tau = " +
                   number_text(options.start_time) +
                   " to tau = " + number_text(options.end_time));
  if (!(options.tolerance >= 1e-13 && options.tolerance <= 1e-3))
    throw BadInput("the tolerance must lie between 1e-13 and 1e-3, got " +
                   number_text(options.tolerance));
}

DemesState make_flat_start(const Demes& demes, const double seed)
{
  return {seed, 0, demes.pre_stretch};
}

DemesState make_rest_start(const Demes& demes, const double drive)
{
  const auto equilibria = find_equilibria(demes, drive);
  auto rest = equilibria.back();
  for (auto state = equilibria.rbegin(); state != equilibria.rend(); ++state)
    if (state->energy < rest.energy)
      rest = *state;
  return {rest.angle, 0, rest.stretch};
}

Signal make_drive(const double reference_drive, const double reference_voltage,
                  const double direct_voltage, const double alternating_voltage,
                  const double frequency)
{
  const double scale = reference_drive / reference_voltage;
  return Signal::sine(scale * direct_voltage, scale * alternating_voltage,
                      frequency / (2 * pi), 0);
}

DemesRun run_demes(const Demes& demes, const DemesRunOptions& options)
{
  lumped::validate(demes);
  validate(options);
  validate_start(demes, options.start);
  return Run(demes, options).run();
}
} // namespace taut::lumped
