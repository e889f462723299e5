#include "demes_stepper.h"

#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "demes_formulas.h"

namespace taut::lumped
{
namespace
{
constexpr int n = RadauRule::n;
const double pi = std::acos(-1.);
/// Iterations after which a step is given up.
constexpr int most_iterations = 20;
/// Last change of the iteration over the tolerance; what it leaves is smaller
/// still.
constexpr double iteration_share = 2e-2;
/// Of the step that the error estimate would allow; more would be rejected
/// often.
constexpr double safety = 0.75;
/// Values of the angle and the velocity below which errors count as absolute.
constexpr double least_scale = 1e-3;

/// (matrix + diagonal) x = right-hand side, in place. No pivots are sought: the
/// derivative matrix of the rule times its quadrature weights is positive, and
/// so is the diagonal.
void solve_in_place(RadauRule::Matrix& matrix, RadauRule::Nodal& x)
{
  RadauRule::Nodal inverse;
  for (int k = 0; k < n; ++k)
  {
    inverse[k] = 1 / matrix[k][k];
    for (int i = k + 1; i < n; ++i)
    {
      const double factor = matrix[i][k] * inverse[k];
      // Whole rows, although their beginnings are no longer needed: loops of
      // constant length run side by side.
      for (int j = 0; j < n; ++j)
        matrix[i][j] -= factor * matrix[k][j];
      x[i] -= factor * x[k];
    }
  }
  for (int k = n - 1; k >= 0; --k)
  {
    x[k] *= inverse[k];
    for (int i = 0; i < k; ++i)
      x[i] -= matrix[i][k] * x[k];
  }
}

double fourth_power(const double x)
{
  return x * x * x * x;
}
} // namespace

DemesStepper::DemesStepper(const Demes& demes, const DemesRunOptions& options,
                           time::OdeStatistics& statistics)
    : demes_(demes), options_(options), statistics_(statistics),
      rule_(get_radau_rule()),
      drive_signal_(demes, options.start_time, options.end_time)
{
}

void DemesStepper::start(const double time, const double end,
                         const DemesState& state)
{
  begin_ = time_ = time;
  end_ = end;
  drive_signal_.begin_segment(time, end);
  state_ = state;
  last_step_ = 0;
  // Short against the oscillation that the stiffnesses of order 1 allow; the
  // error estimate adapts it at once.
  if (step_ == 0)
    step_ = 0.01;
}

double DemesStepper::get_relaxation_rate() const
{
  return 4 * demes_.viscous_ratio / demes_.relaxation;
}

void DemesStepper::advance()
{
  for (;;)
  {
    const double free = std::min(step_, options_.largest_step);
    const bool last = free >= (end_ - time_) * (1 - 1e-12);
    const double step = last ? end_ - time_ : free;
    const double error = solve(step) ? measure_error(step)
                                     : std::numeric_limits<double>::infinity();
    const bool solved = std::isfinite(error);
    // The error estimate is of order n + 1.
    const double change =
        solved ? safety * std::pow(std::max(error, 1e-12), -1. / (n + 1)) : 0.4;
    if (solved && error <= 1)
    {
      accept(step, last ? end_ : time_ + step);
      // The remainder of a segment says nothing about a whole step.
      const double next = step * std::clamp(change, 0.5, 2.);
      step_ = last ? std::max(next, std::min(step_, 2 * next)) : next;
      return;
    }
    ++statistics_.rejected;
    step_ = step * std::clamp(change, 0.1, 0.9);
    if (time_ + step_ / 8 == time_)
      throw SolverFailed("the step of the lumped DEMES vanished at tau = " +
                         number_text(time_) + ": " + reason_);
  }
}

/// The beginning of the step, and the accelerations of the last one continued.
void DemesStepper::predict(const double step)
{
  angle_[0] = state_.angle;
  velocity_[0] = state_.velocity;
  inner_power_[0] = fourth_power(state_.inner_stretch);
  for (int i = 0; i <= n; ++i)
    drive_[i] = get_drive(time_ + step * rule_.points[i]);
  angle_.fill(state_.angle);
  update_chords();
  update_accelerations(0, 0);
  for (int i = 1; i <= n; ++i)
    acceleration_[i] =
        last_step_ == 0 ? acceleration_[0]
                        : combine(rule_.make_interpolation(
                                      1 + rule_.points[i] * step / last_step_),
                                  last_acceleration_);
}

/// Whether the iteration converged.
bool DemesStepper::solve(const double step)
{
  predict(step);
  const double enough =
      iteration_share * options_.tolerance * get_scale() / step;
  double last_change = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < most_iterations; ++iteration)
  {
    ++statistics_.evaluations;
    place_angles(step);
    update_chords();
    if (!is_admissible() || !relax_inner(step))
      return false;
    const double change = update_accelerations(1, n);
    if (change <= enough)
    {
      finish(step);
      return true;
    }
    if (iteration > 4 && !(change < last_change))
      break;
    last_change = change;
  }
  reason_ = "the iteration of its states does not converge";
  return false;
}

void DemesStepper::place_angles(const double step)
{
  for (int i = 1; i <= n; ++i)
  {
    double sum = 0;
    for (int j = 1; j <= n; ++j)
      sum += rule_.double_integral[i - 1][j - 1] * acceleration_[j];
    angle_[i] =
        angle_[0] + step * (rule_.points[i] * velocity_[0] + step * sum);
  }
}

void DemesStepper::update_chords()
{
  formulas::compute_chords(angle_, demes_.eccentricity, stretch_, slope_);
  for (int i = 0; i <= n; ++i)
  {
    stretch_[i] *= demes_.pre_stretch;
    slope_[i] *= demes_.pre_stretch;
  }
}

bool DemesStepper::is_admissible()
{
  for (int i = 0; i <= n; ++i)
    if (!(std::abs(angle_[i]) < pi && stretch_[i] > 0))
    {
      reason_ = "the ends of the frame meet";
      return false;
    }
  return true;
}

/// The rule applied to the linear equation of q, for its growth since the
/// beginning of the step.
bool DemesStepper::relax_inner(const double step)
{
  auto matrix = rule_.derivative;
  const double rate = get_relaxation_rate();
  Nodal growth{};
  for (int i = 0; i < n; ++i)
  {
    const double square = stretch_[i + 1] * stretch_[i + 1];
    const double scale = step * rate;
    matrix[i][i] += scale / square;
    growth[i] = scale * (square - inner_power_[0] / square);
  }
  solve_in_place(matrix, growth);
  for (int i = 0; i < n; ++i)
  {
    inner_power_[i + 1] = inner_power_[0] + growth[i];
    if (inner_power_[i + 1] > 0)
      continue;
    reason_ = "the inner stretch vanishes";
    return false;
  }
  return true;
}

/// At the points from `first` to `last`. Returns the largest change.
double DemesStepper::update_accelerations(const int first, const int last)
{
  const Demes& demes = demes_;
  const Sampled before = acceleration_;
  for (int i = first; i <= last; ++i)
  {
    force_[i] = formulas::compute_force(demes, stretch_[i],
                                        std::sqrt(inner_power_[i]), drive_[i]);
    acceleration_[i] = -demes.frame_stiffness * (angle_[i] - demes.rest_angle) -
                       slope_[i] * force_[i];
  }
  double largest = 0;
  for (int i = first; i <= last; ++i)
  {
    const double difference = std::abs(acceleration_[i] - before[i]);
    // Not std::max, which would lose a NaN.
    if (!(difference <= largest))
      largest = difference;
  }
  return largest;
}

/// States of the converged accelerations.
void DemesStepper::finish(const double step)
{
  for (int i = 1; i <= n; ++i)
  {
    double first = 0, second = 0;
    for (int j = 1; j <= n; ++j)
    {
      first += rule_.integral[i - 1][j - 1] * acceleration_[j];
      second += rule_.double_integral[i - 1][j - 1] * acceleration_[j];
    }
    velocity_[i] = velocity_[0] + step * first;
    angle_[i] =
        angle_[0] + step * (rule_.points[i] * velocity_[0] + step * second);
  }
}

double DemesStepper::get_scale() const
{
  return std::max(
      {least_scale, std::abs(state_.angle), std::abs(state_.velocity)});
}

/// How far the polynomials miss the equations at the beginning of the step,
/// where these are not imposed, turned into an error of the states inside.
double DemesStepper::measure_error(const double step) const
{
  double missed = acceleration_[0];
  for (int j = 1; j <= n; ++j)
    missed -= rule_.at_start[j - 1] * acceleration_[j];
  const double rate = get_relaxation_rate();
  const double square = stretch_[0] * stretch_[0];
  const double missed_inner =
      rate * (square - inner_power_[0] / square) -
      combine(rule_.derivative_at_start, inner_power_) / step;
  // Between the points the polynomials miss far less; what they miss of q is
  // forgotten at the rate with which q relaxes.
  constexpr double falling_off = n * n;
  const double error = std::abs(missed) * step / falling_off / get_scale();
  const double inner_error = std::abs(missed_inner) /
                             (falling_off / step + rate / square) /
                             (4 * inner_power_[0]);
  return std::max(error, inner_error) / options_.tolerance;
}

void DemesStepper::accept(const double step, const double end)
{
  ++statistics_.steps;
  begin_ = time_;
  time_ = end;
  last_step_ = step;
  last_acceleration_ = acceleration_;
  state_ = {angle_[n], velocity_[n], std::sqrt(std::sqrt(inner_power_[n]))};
  compute_exchanges(step);
}

/// Both powers at the points, integrated by the rule.
void DemesStepper::compute_exchanges(const double step)
{
  Nodal dissipation{}, source{};
  const bool voltage = demes_.control == DemesControl::voltage;
  const bool constant = drive_signal_.is_constant();
  for (int i = 1; i <= n; ++i)
  {
    dissipation[i - 1] = compute_dissipation(
        demes_, stretch_[i], std::sqrt(std::sqrt(inner_power_[i])));
    if (constant)
      continue;
    const double capacitance =
        formulas::compute_capacitance(demes_, stretch_[i]);
    source[i - 1] = drive_signal_.rate(get_point_time(i)) * drive_[i] *
                    (voltage ? capacitance : -1 / capacitance);
  }
  dissipated_[0] = source_work_[0] = 0;
  for (int i = 1; i <= n; ++i)
  {
    dissipated_[i] = source_work_[i] = 0;
    for (int j = 0; j < n; ++j)
    {
      dissipated_[i] += step * rule_.integral[i - 1][j] * dissipation[j];
      source_work_[i] += step * rule_.integral[i - 1][j] * source[j];
    }
  }
}

double DemesStepper::get_point_time(const int i) const
{
  return i == n ? time_ : begin_ + last_step_ * rule_.points[i];
}

DemesMoment DemesStepper::interpolate(const double time) const
{
  const auto weights = rule_.make_interpolation(
      time == time_ ? 1 : (time - begin_) / last_step_);
  DemesMoment moment;
  moment.state.angle = combine(weights, angle_);
  moment.state.velocity = combine(weights, velocity_);
  moment.state.inner_stretch =
      std::sqrt(std::sqrt(combine(weights, inner_power_)));
  moment.dissipated = combine(weights, dissipated_);
  moment.source_work = combine(weights, source_work_);
  return moment;
}
} // namespace taut::lumped
