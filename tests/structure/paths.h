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
/// Lee's frame: two legs of length 120 with a rigid corner, both ends hinged,
/// and a dead load along the column at 24 from the corner. E = 720, A = 6,
/// I = 2, nu = 0.3, shear factor 1.
inline std::unique_ptr<Model> make_lee(const unsigned int n)
{
  structure::Device device;
  constexpr double E = 720, A = 6, I = 2, G = E / 2.6;
  auto frame =
      make_frame("column", make_stiffnesses(E * A, G * A, G * I, E * I, E * I));
  frame.groups = {"column", "inner", "outer"};
  frame.normal = {{0, 1, 0}};
  device.frames = {frame};
  auto plane = make_support("column", {{false, true, false}});
  plane.groups = frame.groups;
  plane.held_rotations = {{true, false, true}};
  device.supports = {plane, make_support("foot", {{true, true, true}}),
                     make_support("wall", {{true, true, true}})};
  device.point_loads = {make_point_load("place", {0, 0, -1})};
  device.point_loads[0].force = make_slope(1);
  auto mesh = make_line_mesh();
  const auto column =
      add_line(mesh, "column", 5 * n, make_straight({0, 0, 0}, {0, 0, 120}));
  const auto inner =
      add_line(mesh, "inner", n, make_straight({0, 0, 120}, {24, 0, 120}));
  const auto outer = add_line(mesh, "outer", 4 * n,
                              make_straight({24, 0, 120}, {120, 0, 120}));
  name_point(mesh, column[0], "foot");
  name_point(mesh, inner[1], "place");
  name_point(mesh, outer[1], "wall");
  fe::add_empty_surface(mesh);
  return std::make_unique<Model>(device, mesh);
}

} // namespace taut::testing
