#pragma once

#include <array>

namespace taut::lumped
{
/// Collocation at the points of Radau, order 2 n - 1, stable however fast a
/// part of the motion relaxes. All on a step of length 1.
struct RadauRule
{
  static constexpr int n = 8;
  using Nodal = std::array<double, n>;
  using Matrix = std::array<Nodal, n>;
  /// Values at the beginning of the step and at its points.
  using Sampled = std::array<double, n + 1>;

  /// 0 and the points, the last of which is 1.
  Sampled points;
  /// Barycentric weights of all of them.
  Sampled weights;
  /// Row i times nodal values: integral of their polynomial from 0 to point i.
  Matrix integral;
  /// The same twice.
  Matrix double_integral;
  /// Inverse of `integral`.
  Matrix derivative;
  /// Row times nodal values: their polynomial at 0.
  Nodal at_start;
  /// Times values at the n + 1 points: derivative of their polynomial at 0.
  Sampled derivative_at_start;

  /// Weights with which a polynomial given at the n + 1 points is evaluated.
  Sampled make_interpolation(double position) const;
};

/// Computed at the first call.
const RadauRule& get_radau_rule();

double combine(const RadauRule::Sampled& weights,
               const RadauRule::Sampled& values);
} // namespace taut::lumped
