#include "demes_radau_rule.h"

#include <cmath>
#include <cstdint>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace taut::lumped
{
namespace
{
constexpr int n = RadauRule::n;

/// The points are the zeros of P_n - P_(n-1) mapped to [0, 1].
RadauRule::Sampled find_points()
{
  const auto value = [](const double x)
  {
    return boost::math::legendre_p(n, 2 * x - 1) -
           boost::math::legendre_p(n - 1, 2 * x - 1);
  };
  RadauRule::Sampled points{};
  // The points lie apart by far more than a piece.
  constexpr int pieces = 400;
  int found = 0;
  for (int i = 0; i < pieces - 1; ++i)
  {
    const double begin = double(i) / pieces, end = double(i + 1) / pieces;
    if ((value(begin) > 0) == (value(end) > 0))
      continue;
    std::uintmax_t iterations = 100;
    const auto [low, high] = boost::math::tools::toms748_solve(
        value, begin, end, boost::math::tools::eps_tolerance<double>(),
        iterations);
    points[++found] = (low + high) / 2;
  }
  points[n] = 1;
  return points;
}

RadauRule::Sampled make_weights(const RadauRule::Sampled& points)
{
  RadauRule::Sampled weights;
  for (int j = 0; j <= n; ++j)
  {
    weights[j] = 1;
    for (int k = 0; k <= n; ++k)
      if (k != j)
        weights[j] /= points[j] - points[k];
  }
  return weights;
}

/// The polynomial that is 1 at point j and 0 at the others but 0.
double evaluate_basis(const RadauRule::Sampled& points, const int j,
                      const double x)
{
  double value = 1;
  for (int k = 1; k <= n; ++k)
    if (k != j)
      value *= (x - points[k]) / (points[j] - points[k]);
  return value;
}

/// Order 0: integral to `end`; order 1: the integral of that.
double integrate_basis(const RadauRule::Sampled& points, const int j,
                       const double end, const int order)
{
  const auto integrand = [&](const double x)
  { return evaluate_basis(points, j, x) * (order == 0 ? 1 : end - x); };
  return boost::math::quadrature::gauss<double, 10>::integrate(integrand, 0.,
                                                               end);
}

RadauRule make_rule()
{
  RadauRule rule{};
  rule.points = find_points();
  rule.weights = make_weights(rule.points);
  const auto& x = rule.points;
  for (int i = 1; i <= n; ++i)
  {
    rule.at_start[i - 1] = evaluate_basis(x, i, 0);
    for (int j = 1; j <= n; ++j)
    {
      rule.integral[i - 1][j - 1] = integrate_basis(x, j, x[i], 0);
      rule.double_integral[i - 1][j - 1] = integrate_basis(x, j, x[i], 1);
      if (i != j)
        rule.derivative[i - 1][j - 1] =
            rule.weights[j] / rule.weights[i] / (x[i] - x[j]);
    }
    double& diagonal = rule.derivative[i - 1][i - 1];
    for (int j = 0; j <= n; ++j)
      if (i != j)
        diagonal += 1 / (x[i] - x[j]);
  }
  for (int j = 1; j <= n; ++j)
  {
    rule.derivative_at_start[j] = -rule.weights[j] / rule.weights[0] / x[j];
    rule.derivative_at_start[0] -= 1 / x[j];
  }
  return rule;
}
} // namespace

RadauRule::Sampled RadauRule::make_interpolation(const double position) const
{
  Sampled shares{};
  double sum = 0;
  for (int j = 0; j <= n; ++j)
  {
    if (position == points[j])
    {
      shares = {};
      shares[j] = 1;
      return shares;
    }
    sum += shares[j] = weights[j] / (position - points[j]);
  }
  for (double& share : shares)
    share /= sum;
  return shares;
}

const RadauRule& get_radau_rule()
{
  static const RadauRule rule = make_rule();
  return rule;
}

double combine(const RadauRule::Sampled& weights,
               const RadauRule::Sampled& values)
{
  double sum = 0;
  for (int j = 0; j <= n; ++j)
    sum += weights[j] * values[j];
  return sum;
}
} // namespace taut::lumped
