#pragma once

#include <array>
#include <vector>

namespace taut::study
{
/// A motion at one time.
struct MotionPoint
{
  double time = 0;     ///< (s)
  double value = 0;    ///< in its own unit
  double velocity = 0; ///< its rate (1/s)
};

/// One quantity of a run at increasing times. Between them it is the cubic
/// through values and velocities (Hermite), whose error is of fourth order.
struct MotionTrack
{
  std::vector<double> times;
  std::vector<double> values;
  std::vector<double> velocities;

  std::size_t size() const
  {
    return times.size();
  }
  void add(const MotionPoint& point);
  MotionPoint get(std::size_t row) const;
};

/// The derivative of the polynomial through each value and its four nearest
/// neighbours in the list: of fourth order where the times are evenly spaced.
/// Fewer than two values have the derivative 0.
std::vector<double> differentiate(const std::vector<double>& times,
                                  const std::vector<double>& values);

/// The rows at `begin` and later.
MotionTrack cut_before(const MotionTrack& track, double begin);

/// The track at given times between its first and its last one. At a row it is
/// that row.
MotionTrack resample(const MotionTrack& track,
                     const std::vector<double>& times);

/// Smallest and largest value, also between the rows.
std::array<double, 2> find_extremes(const MotionTrack& track);

/// Half of the difference of both.
double compute_half_range(const MotionTrack& track);
} // namespace taut::study
