#include "response_run.h"

#include <taut/base/exceptions.h>
#include <taut/study/section.h>
#include <taut/study/spectrum.h>

#include <algorithm>
#include <cmath>

namespace taut::study
{
namespace
{
constexpr unsigned int periods_per_block = 8;
constexpr unsigned int rows_per_period = 64;
constexpr double response_disturbance = 1e-10;

/// The case under the source of one frequency.
Case drive(Case driven, const double frequency)
{
  const auto& response = driven.procedure.frequency_response;
  const Signal source =
      Signal::sine(response.offset, response.amplitude, frequency, 0);
  driven.lumped_demes.source = source;
  driven.lumped_resonator.voltage = source;
  driven.procedure.start_time = 0;
  driven.procedure.analysis = structure::Analysis::transient;
  return driven;
}

/// Even rows from one time to another, both among them.
std::vector<double> make_block_times(const double begin, const double end,
                                     const unsigned int rows)
{
  std::vector<double> times;
  for (unsigned int i = 1; i < rows; ++i)
    times.push_back(begin + (end - begin) * i / rows);
  return times;
}

/// Mean square of the deviation from the mean, from even rows.
double compute_rms(const MotionTrack& block, const double mean)
{
  double sum = 0;
  for (std::size_t i = 1; i < block.size(); ++i)
    sum += (block.values[i] - mean) * (block.values[i] - mean);
  return std::sqrt(sum / double(block.size() - 1));
}

void measure_block(const MotionTrack& block, ResponsePoint& point)
{
  point.mean = compute_time_mean(block);
  const auto extremes = find_extremes(block);
  point.minimum = extremes[0];
  point.maximum = extremes[1];
  point.amplitude = (extremes[1] - extremes[0]) / 2;
  point.lowest = std::fmin(point.lowest, point.minimum);
  point.highest = std::fmax(point.highest, point.maximum);
}

/// What only the last block is asked for.
void measure_last_block(const MotionTrack& block, ResponsePoint& point)
{
  point.rms = compute_rms(block, point.mean);
  point.first_amplitude = compute_line(block, point.frequency);
  point.second_amplitude = compute_line(block, 2 * point.frequency);
}

/// The smallest n such that rows n periods apart are the same, 0 if there is
/// none up to a block.
unsigned int find_repetition(const MotionTrack& track, const double allowed)
{
  const std::size_t n_rows = track.size() - 1;
  for (unsigned int n = 1; n <= periods_per_block; ++n)
  {
    double worst = 0;
    for (std::size_t row = 0; row + n * rows_per_period <= n_rows; ++row)
      worst = std::max(worst, std::abs(track.values[row + n * rows_per_period] -
                                       track.values[row]));
    if (worst <= allowed)
      return n;
  }
  return 0;
}

/// One frequency, block after block, with a neighbour that began within 1e-10.
class ResponseRun
{
public:
  ResponseRun(const Case& lumped_case, const double frequency,
              const bool is_upward)
      : description_(lumped_case.procedure.frequency_response),
        flow_(make_driven_flow(lumped_case, frequency))
  {
    point_.frequency = frequency;
    point_.is_upward = is_upward;
  }

  /// Starts at the time 0 with `state`, at rest if that is empty, and leaves
  /// the state after the last whole period in it.
  /// Errors: SolverFailed if the model fails.
  ResponsePoint run(std::vector<double>& state)
  {
    if (state.empty())
      state = flow_->make_start(0);
    state_ = neighbour_ = state;
    const auto scales = flow_->get_scales();
    for (std::size_t i = 0; i < state.size(); ++i)
      neighbour_[i] += response_disturbance * scales[i];
    if (description_.from_rest)
      observe();
    else
      settle();
    finish();
    state = state_;
    return point_;
  }

  const ResponsePoint& get_point() const
  {
    return point_;
  }

private:
  void advance(const unsigned int n_periods)
  {
    const double begin = point_.periods / point_.frequency;
    point_.periods += n_periods;
    const double end = point_.periods / point_.frequency;
    const auto times =
        make_block_times(begin, end, n_periods * rows_per_period);
    last_ = std::move(block_);
    block_ = neighbour_block_ = {};
    state_ = flow_->follow(state_, begin, end, times, &block_);
    neighbour_ =
        flow_->follow(neighbour_, begin, end, times, &neighbour_block_);
    measure_block(block_, point_);
  }

  void settle()
  {
    SettlingWatch watch(description_.settled_within);
    while (point_.periods + periods_per_block <= description_.most_periods)
    {
      advance(periods_per_block);
      point_.settled = watch.add(point_.mean, point_.amplitude);
      if (point_.settled && point_.periods >= description_.least_periods)
        return;
    }
  }

  /// The whole periods of a given time, the last ones as a block.
  void observe()
  {
    SettlingWatch watch(description_.settled_within);
    const auto n_periods =
        std::max(1u, static_cast<unsigned int>(description_.observation_time *
                                               point_.frequency * (1 + 1e-9)));
    const unsigned int first = n_periods % periods_per_block;
    if (first > 0)
      advance(first);
    while (point_.periods < n_periods)
    {
      advance(periods_per_block);
      point_.settled = watch.add(point_.mean, point_.amplitude);
    }
  }

  void finish()
  {
    measure_last_block(block_, point_);
    double difference = 0;
    for (std::size_t row = 0; row < block_.size(); ++row)
      difference = std::max(difference, std::abs(neighbour_block_.values[row] -
                                                 block_.values[row]));
    point_.reproducible = difference <= 0.01 * point_.amplitude;
    if (point_.settled)
      point_.period_number = find_repetition(join(), 0.01 * point_.amplitude);
  }

  /// The last two blocks, so that every period of a block has a later one.
  MotionTrack join() const
  {
    MotionTrack both = last_;
    for (std::size_t row = both.size() > 0 ? 1 : 0; row < block_.size(); ++row)
      both.add(block_.get(row));
    return both;
  }

  const FrequencyResponseDescription description_;
  const std::unique_ptr<MotionFlow> flow_;
  ResponsePoint point_;
  std::vector<double> state_, neighbour_;
  MotionTrack last_, block_, neighbour_block_;
};

} // namespace

SettlingWatch::SettlingWatch(const double tolerance) : tolerance_(tolerance) {}

bool SettlingWatch::is_calm(const double allowed) const
{
  const std::size_t n = blocks_.size();
  if (n < 3)
    return false;
  for (const std::size_t i : {0, 1})
  {
    const double before = std::abs(blocks_[n - 2][i] - blocks_[n - 3][i]);
    const double change = std::abs(blocks_[n - 1][i] - blocks_[n - 2][i]);
    // Changes that are a thousandth of what is allowed follow no series.
    const bool is_scatter = change <= 1e-3 * allowed;
    if (!is_scatter &&
        !(change < before && change * change / (before - change) <= allowed))
      return false;
  }
  return true;
}

bool SettlingWatch::add(const double mean, const double amplitude)
{
  blocks_.push_back({mean, amplitude});
  const bool calm = is_calm(tolerance_ * amplitude);
  const bool settled = calm && was_calm_;
  was_calm_ = calm;
  return settled;
}

std::unique_ptr<MotionFlow> make_driven_flow(const Case& lumped_case,
                                             const double frequency)
{
  FlowOptions options;
  options.of = lumped_case.procedure.frequency_response.of;
  if (options.of.empty())
    options.of = get_lumped_coordinate(lumped_case);
  options.velocity = get_lumped_velocity(lumped_case, options.of);
  return make_flow(drive(lumped_case, frequency), options);
}

ResponsePoint compute_point(const Case& lumped_case, const double frequency,
                            const bool is_upward, std::vector<double>& state)
{
  ResponseRun run(lumped_case, frequency, is_upward);
  try
  {
    return run.run(state);
  }
  catch (const SolverFailed&)
  {
    state.clear();
    ResponsePoint failed;
    failed.frequency = frequency;
    failed.is_upward = is_upward;
    failed.periods = run.get_point().periods;
    return failed;
  }
}

} // namespace taut::study
