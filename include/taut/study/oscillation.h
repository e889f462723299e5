#pragma once

#include <array>
#include <limits>
#include <vector>

namespace taut::study
{
/// What a history shows of an oscillation; NaN if it shows none.
struct Oscillation
{
  /// Of the whole periods between the first and the last upward crossing of
  /// the mean (Hz).
  double frequency = std::numeric_limits<double>::quiet_NaN();
  double mean = std::numeric_limits<double>::quiet_NaN();
  /// The first and the last crossing upwards and downwards (s); if there are
  /// not two downwards, those upwards.
  std::array<double, 2> rises{}, falls{};
};

/// Measures a history at increasing times (s) by its upward crossings of its
/// own mean, linear between rows. A swing counts if it goes beyond 5 % of the
/// largest on both sides, so that faster ripples do not; fewer than two
/// crossings, or a history that stays within `smallest` of its mean, are no
/// oscillation.
Oscillation measure_oscillation(const std::vector<double>& times,
                                const std::vector<double>& values,
                                double smallest);

/// Mean over the periods between upward crossings and over those between
/// downward ones, half of each: where the oscillation decays the first is too
/// high by what the second is too low.
double compute_mean(const std::vector<double>& times,
                    const std::vector<double>& values,
                    const Oscillation& oscillation);

/// Mean from begin to end of a history that is linear between its rows.
double compute_mean(const std::vector<double>& times,
                    const std::vector<double>& values, double begin,
                    double end);
} // namespace taut::study
