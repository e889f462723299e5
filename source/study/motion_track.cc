#include <taut/study/motion_track.h>

#include <algorithm>
#include <cmath>

#include <boost/math/interpolators/cubic_hermite.hpp>

namespace taut::study
{
namespace
{
/// Derivative at times[at] of the polynomial through rows [first, last).
double differentiate_at(const std::vector<double>& times,
                        const std::vector<double>& values, const std::size_t at,
                        const std::size_t first, const std::size_t last)
{
  double sum = 0;
  for (std::size_t j = first; j < last; ++j)
  {
    if (j == at)
      continue;
    double weight = 1 / (times[at] - times[j]);
    for (std::size_t k = first; k < last; ++k)
      if (k != j && k != at)
        weight *= (times[at] - times[k]) / (times[j] - times[k]);
    sum += weight * (values[at] - values[j]);
  }
  return sum;
}

/// Where the cubic of an interval turns, and what it is there.
void visit_turns(const MotionTrack& track, const std::size_t row,
                 std::array<double, 2>& extremes)
{
  const double h = track.times[row + 1] - track.times[row];
  const double v0 = track.values[row], v1 = track.values[row + 1];
  const double d0 = h * track.velocities[row],
               d1 = h * track.velocities[row + 1];
  if (d0 * d1 >= 0)
    return;
  // v0 + d0 s + b s^2 + a s^3 for s from 0 to 1: one turn, since the slope
  // changes its sign.
  const double a = 2 * (v0 - v1) + d0 + d1, b = 3 * (v1 - v0) - 2 * d0 - d1;
  const double root = std::sqrt(std::max(b * b - 3 * a * d0, 0.));
  const double q = -(b + std::copysign(root, b));
  for (const double s : {q / (3 * a), d0 / q})
    if (s > 0 && s < 1)
    {
      const double value = v0 + s * (d0 + s * (b + s * a));
      extremes[0] = std::min(extremes[0], value);
      extremes[1] = std::max(extremes[1], value);
    }
}
} // namespace

void MotionTrack::add(const MotionPoint& point)
{
  times.push_back(point.time);
  values.push_back(point.value);
  velocities.push_back(point.velocity);
}

MotionPoint MotionTrack::get(const std::size_t row) const
{
  return {times.at(row), values.at(row), velocities.at(row)};
}

std::vector<double> differentiate(const std::vector<double>& times,
                                  const std::vector<double>& values)
{
  constexpr std::size_t width = 5;
  const std::size_t n = times.size(), used = std::min(n, width);
  std::vector<double> rates;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t first =
        std::min(i > width / 2 ? i - width / 2 : 0, n - used);
    rates.push_back(differentiate_at(times, values, i, first, first + used));
  }
  return rates;
}

MotionTrack cut_before(const MotionTrack& track, const double begin)
{
  const auto first =
      std::lower_bound(track.times.begin(), track.times.end(), begin) -
      track.times.begin();
  return {{track.times.begin() + first, track.times.end()},
          {track.values.begin() + first, track.values.end()},
          {track.velocities.begin() + first, track.velocities.end()}};
}

MotionTrack resample(const MotionTrack& track, const std::vector<double>& times)
{
  auto knots = track.times;
  auto values = track.values;
  auto velocities = track.velocities;
  const boost::math::interpolators::cubic_hermite<std::vector<double>> curve(
      std::move(knots), std::move(values), std::move(velocities));
  MotionTrack result;
  for (const double time : times)
  {
    const auto row =
        std::lower_bound(track.times.begin(), track.times.end(), time);
    if (row != track.times.end() && *row == time)
      result.add(track.get(std::size_t(row - track.times.begin())));
    else
      result.add({time, curve(time), curve.prime(time)});
  }
  return result;
}

std::array<double, 2> find_extremes(const MotionTrack& track)
{
  if (track.size() == 0)
    return {0, 0};
  const auto [lowest, highest] =
      std::minmax_element(track.values.begin(), track.values.end());
  std::array<double, 2> extremes{*lowest, *highest};
  for (std::size_t row = 0; row + 1 < track.size(); ++row)
    visit_turns(track, row, extremes);
  return extremes;
}

double compute_half_range(const MotionTrack& track)
{
  const auto extremes = find_extremes(track);
  return (extremes[1] - extremes[0]) / 2;
}
} // namespace taut::study
