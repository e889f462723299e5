#pragma once

#include <taut/study/motion_flow.h>
#include <taut/study/run.h>

#include <limits>

namespace taut::study
{
/// The motion to which a lumped model settles under a source of one frequency.
struct ResponsePoint
{
  double frequency = 0; ///< (Hz)
  bool is_upward = true;
  /// Over the last block of periods, in the unit of what is watched; NaN if the
  /// model fails.
  double mean = std::numeric_limits<double>::quiet_NaN();
  double minimum = mean, maximum = mean;
  double amplitude = mean; ///< half of the difference of both
  double rms = mean;       ///< of the deviation from the mean
  /// Of the parts at the frequency of the source and at twice that, with which
  /// the film is pulled.
  double first_amplitude = mean, second_amplitude = mean;
  /// Over all the time at this frequency.
  double lowest = mean, highest = mean;
  /// After so many periods the settled motion repeats, to a hundredth of the
  /// amplitude; 0 if it does not up to 8, or has not settled.
  unsigned int period_number = 0;
  bool settled = false;
  unsigned int periods = 0;
  /// Whether another start within 1e-10 gives the last block within a hundredth
  /// of the amplitude.
  bool reproducible = false;
};

/// Watches a motion block by block (8 periods each) until it has settled: twice
/// in a row, what the last change of its mean and of its amplitude lets expect
/// of further changes, as a geometric series of the last two, is less than
/// `tolerance` times the amplitude.
class SettlingWatch
{
public:
  explicit SettlingWatch(double tolerance);

  /// Takes the next block; true from when the motion has settled.
  bool add(double mean, double amplitude);

private:
  bool is_calm(double allowed) const;

  double tolerance_;
  bool was_calm_ = false;
  std::vector<std::array<double, 2>> blocks_;
};

/// The frequencies (Hz) of a response, increasing.
std::vector<double>
make_frequencies(const FrequencyResponseDescription& description);

/// All points of a lumped case's response in the order in which they were
/// computed, upwards before downwards. Up and down are two sweeps, each from
/// the case's start; with `from_rest` each point is. Independent ones run side
/// by side.
/// Errors: BadInput for a film, an unknown column or impossible parameters.
std::vector<ResponsePoint> compute_response(const Case& lumped_case);

/// What a sweep up and one down differ in, as sentences: ranges of frequencies
/// where their amplitudes differ by more than a hundredth of the largest.
std::vector<std::string> find_jumps(const std::vector<ResponsePoint>& points);

/// Runs Case::procedure's frequency response. Its points are the table
/// "response" of the summary and the rows of the history, with the frequency in
/// the place of time.
RunSummary run_response(const Case& lumped_case, RunOutput& output);
} // namespace taut::study
