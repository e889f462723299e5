#pragma once

#include <array>
#include <cmath>

namespace taut::fe
{
template <typename Number>
Number dot(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename Number>
std::array<Number, 3> cross(const std::array<Number, 3>& a,
                            const std::array<Number, 3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

inline double compute_distance(const std::array<double, 3>& a,
                               const std::array<double, 3>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
} // namespace taut::fe
