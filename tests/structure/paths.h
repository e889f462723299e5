#pragma once

#include <taut/time/continuation.h>

#include "structure/frames.h"

/// Continuation of a structure's equilibria, for tests.
namespace taut::testing
{
using Kind = time::CurvePoint::Kind;

/// A signal that rises by `rate` per second, for ever and from ever.
inline Signal make_slope(const double rate)
{
  return Signal::expression(std::to_string(rate) + " * t", {});
}

/// Follows paths whose parameter is the time of the signals.
class Path
{
public:
  struct Point : time::CurvePoint
  {
    std::vector<double> shape;
  };

  explicit Path(structure::Structure& structure)
      : u(structure.n_free(), 0.), structure_(structure),
        history_(structure.device()),
        problem_(structure, history_, structure::Networks::relaxed, nullptr)
  {
    options.newton.tolerance = 1e-12;
    options.noticeable_displacement =
        .02 * structure::compute_extent(structure.mesh()) *
        std::sqrt(structure.n_free_global() / 3.);
  }

  time::ContinuationOptions options;
  std::vector<double> u;
  std::vector<Point> points;

  time::ContinuationStatistics follow(const double start, const double end)
  {
    points.clear();
    return time::continue_path(problem_, start, end, u.data(), options,
                               [&](const time::CurvePoint& point)
                               {
                                 points.push_back({point, {}});
                                 points.back().shape.assign(point.u,
                                                            point.u + u.size());
                                 points.back().u = nullptr;
                                 return true;
                               });
  }
  std::vector<Point> select(const Kind kind) const
  {
    std::vector<Point> selected;
    for (const Point& point : points)
      if (point.kind == kind)
        selected.push_back(point);
    return selected;
  }
  structure::LoadState get_loads(const double parameter) const
  {
    return history_.at(parameter);
  }

private:
  structure::Structure& structure_;
  structure::LoadHistory history_;
  structure::Equilibrium problem_;
};
} // namespace taut::testing
