#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/study/section.h>

#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

namespace taut::study
{
namespace
{
/// The cubic between two rows less a level, for s from 0 to 1, and its slope.
struct Piece
{
  Piece(const MotionTrack& track, const std::size_t row, const double level)
      : begin(track.times[row]), length(track.times[row + 1] - begin),
        c0(track.values[row] - level), c1(length * track.velocities[row])
  {
    const double rise = track.values[row + 1] - track.values[row];
    const double slope = length * track.velocities[row + 1];
    c2 = 3 * rise - 2 * c1 - slope;
    c3 = c1 + slope - 2 * rise;
  }
  double value(const double s) const
  {
    return c0 + s * (c1 + s * (c2 + s * c3));
  }
  double velocity(const double s) const
  {
    return (c1 + s * (2 * c2 + s * 3 * c3)) / length;
  }

  double begin, length, c0, c1, c2 = 0, c3 = 0;
};

MotionPoint find_crossing(const Piece& piece, const double level)
{
  double s = 1;
  if (piece.value(1) > 0)
  {
    std::uintmax_t iterations = 100;
    s = boost::math::tools::toms748_solve(
            [&](const double at) { return piece.value(at); }, 0., 1.,
            boost::math::tools::eps_tolerance<double>(), iterations)
            .second;
  }
  return {piece.begin + s * piece.length, level, piece.velocity(s)};
}
} // namespace

std::vector<double> make_strobe_times(const double period, const double begin,
                                      const double end)
{
  if (!(period > 0))
    throw BadInput("the period of a drive must be positive, got " +
                   number_text(period));
  // What is a multiple of the period may miss it by round-off.
  constexpr double slack = 1e-9;
  std::vector<double> times;
  for (double k = std::ceil(begin / period - slack); k <= end / period + slack;
       ++k)
    times.push_back(std::min(std::max(k * period, begin), end));
  return times;
}

MotionTrack make_strobe(const MotionTrack& track, const double period)
{
  if (track.size() < 2)
    return {};
  return resample(track, make_strobe_times(period, track.times.front(),
                                           track.times.back()));
}

MotionTrack make_crossings(const MotionTrack& track, const double level)
{
  MotionTrack crossings;
  for (std::size_t row = 0; row + 1 < track.size(); ++row)
    if (track.values[row] < level && track.values[row + 1] >= level)
      crossings.add(find_crossing(Piece(track, row, level), level));
  return crossings;
}

double compute_time_mean(const MotionTrack& track)
{
  if (track.size() < 2)
    return track.size() == 1 ? track.values[0] : 0;
  double sum = 0;
  for (std::size_t row = 0; row + 1 < track.size(); ++row)
  {
    const double h = track.times[row + 1] - track.times[row];
    sum += h * (track.values[row] + track.values[row + 1]) / 2 +
           h * h * (track.velocities[row] - track.velocities[row + 1]) / 12;
  }
  return sum / (track.times.back() - track.times.front());
}
} // namespace taut::study
