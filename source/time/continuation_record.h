#pragma once

#include <array>
#include <vector>

#include "continuation_solver.h"

namespace taut::time
{
/// Remembers where a path has been, so that it is noticed when it comes back.
/// Of each point it keeps the parameter and a few sums of displacements with
/// fixed signs, which differ where the displacements do.
class PathRecord
{
public:
  enum class Verdict
  {
    onward,
    closed,  ///< the last step has passed the start
    retraced ///< the last two points lie on earlier parts of the path
  };

  /// `distance`: from the point before, along the path.
  Verdict add(const PathState& state, double distance,
              const PathSolver& solver);

private:
  static constexpr std::size_t n_sums = 3;
  /// Sums, then the parameter.
  using Mark = std::array<double, n_sums + 1>;
  struct Point
  {
    Mark position, tangent;
    double distance; ///< from the point before
  };

  static Mark make_mark(const PathVector& x, const Communicator& communicator);
  static double measure(const Mark& a, const Mark& b, const PathMetric& metric);
  bool passes(const Mark& position, std::size_t segment,
              const PathMetric& metric) const;

  std::vector<Point> points_;
  unsigned int n_coincident_ = 0;
};
} // namespace taut::time
