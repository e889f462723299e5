#include "continuation_record.h"

#include <algorithm>
#include <cmath>

#include <boost/math/tools/minima.hpp>

namespace taut::time
{
namespace
{
/// Of a step: the distance below which a point lies on an earlier part of the
/// path. Interpolation along a step that turns by 30 degrees is off by 2e-4.
constexpr double coincident = 1e-3;

/// +1 or -1, without order.
double make_sign(std::size_t number)
{
  number = (number + 1) * 0x9E3779B97F4A7C15ull;
  number ^= number >> 29;
  number *= 0xBF58476D1CE4E5B9ull;
  return (number >> 40 & 1) != 0 ? 1. : -1.;
}
} // namespace

PathRecord::Mark PathRecord::make_mark(const PathVector& x,
                                       const Communicator& communicator)
{
  Mark mark{};
  for (std::size_t i = 0; i < x.u.size(); ++i)
    for (std::size_t k = 0; k < n_sums; ++k)
      mark[k] += make_sign(n_sums * i + k) * x.u[i];
  for (std::size_t k = 0; k < n_sums; ++k)
    mark[k] = communicator.sum(mark[k]);
  mark[n_sums] = x.parameter;
  return mark;
}

double PathRecord::measure(const Mark& a, const Mark& b,
                           const PathMetric& metric)
{
  double square = std::pow((a[n_sums] - b[n_sums]) / metric.parameter, 2);
  for (std::size_t k = 0; k < n_sums; ++k)
    square += std::pow((a[k] - b[k]) / metric.displacement, 2) / n_sums;
  return std::sqrt(square);
}

bool PathRecord::passes(const Mark& position, const std::size_t segment,
                        const PathMetric& metric) const
{
  const Point &a = points_[segment], &b = points_[segment + 1];
  const double length = measure(a.position, b.position, metric);
  if (std::min(measure(position, a.position, metric),
               measure(position, b.position, metric)) > length)
    return false;
  const auto miss = [&](const double way)
  {
    const double rest = 1 - way;
    Mark mark;
    for (std::size_t k = 0; k < mark.size(); ++k)
      mark[k] =
          a.position[k] +
          way * way * (3 - 2 * way) * (b.position[k] - a.position[k]) +
          b.distance * way * rest * (rest * a.tangent[k] - way * b.tangent[k]);
    return measure(position, mark, metric);
  };
  // A step is so straight that the distance has one minimum along it.
  const auto nearest = boost::math::tools::brent_find_minima(miss, 0., 1., 24);
  return nearest.second < coincident * length;
}

PathRecord::Verdict PathRecord::add(const PathState& state,
                                    const double distance,
                                    const PathSolver& solver)
{
  const PathMetric& metric = solver.metric();
  const Communicator& communicator = solver.communicator();
  points_.push_back({make_mark(state.x, communicator),
                     make_mark(state.tangent, communicator), distance});
  const std::size_t n = points_.size();
  if (n < 4)
    return Verdict::onward;
  if (passes(points_.front().position, n - 2, metric))
    return Verdict::closed;
  bool found = false;
  for (std::size_t segment = 0; segment + 3 < n && !found; ++segment)
    found = passes(points_.back().position, segment, metric);
  n_coincident_ = found ? n_coincident_ + 1 : 0;
  return n_coincident_ > 1 ? Verdict::retraced : Verdict::onward;
}
} // namespace taut::time
