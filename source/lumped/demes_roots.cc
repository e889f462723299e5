#include "demes_roots.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace taut::lumped
{
namespace
{
using Function = std::function<double(double)>;

struct Sample
{
  double x;
  double value;
};

bool differ(const Sample& a, const Sample& b)
{
  return (a.value > 0) != (b.value > 0);
}

double find_root(const Function& function, const Sample& a, const Sample& b)
{
  if (a.value == 0)
    return a.x;
  if (b.value == 0)
    return b.x;
  std::uintmax_t iterations = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      function, a.x, b.x, a.value, b.value,
      boost::math::tools::eps_tolerance<double>(), iterations);
  return std::abs(function(low)) < std::abs(function(high)) ? low : high;
}

/// The point between a and c at which the function comes closest to zero.
Sample find_extremum(const Function& function, const Sample& a, const Sample& c)
{
  const double sign = a.value > 0 ? 1 : -1;
  const auto height = [&](const double x) { return sign * function(x); };
  const auto [x, value] = boost::math::tools::brent_find_minima(
      height, a.x, c.x, std::numeric_limits<double>::digits / 2);
  return {x, sign * value};
}
} // namespace

std::vector<double> scan_roots(const Function& function, const double begin,
                               const double end, const int pieces)
{
  std::vector<double> roots;
  Sample before{begin, function(begin)}, middle = before;
  for (int i = 1; i <= pieces; ++i)
  {
    const double x = i == pieces ? end : begin + (end - begin) * i / pieces;
    const Sample after{x, function(x)};
    if (differ(middle, after))
      roots.push_back(find_root(function, middle, after));
    const bool dips = !differ(before, middle) && !differ(middle, after) &&
                      std::abs(middle.value) < std::abs(before.value) &&
                      std::abs(middle.value) < std::abs(after.value);
    if (dips)
    {
      const Sample extremum = find_extremum(function, before, after);
      if (differ(before, extremum))
      {
        roots.push_back(find_root(function, before, extremum));
        roots.push_back(find_root(function, extremum, after));
      }
    }
    before = middle;
    middle = after;
  }
  return roots;
}
} // namespace taut::lumped
