#pragma once

#include <taut/structure/watches.h>

#include <boost/math/tools/roots.hpp>

/// What the tests of pull-in share.
namespace taut::testing
{
/// A fatal pull-in at a share of the stiffness.
inline structure::EventDescription make_pull_in(const double threshold = 0)
{
  structure::EventDescription event;
  event.name = "pull-in";
  event.kind = structure::EventDescription::Kind::pull_in;
  event.threshold = threshold;
  event.fatal = true;
  return event;
}

template <class Function>
double find_root(const Function& function, const double low, const double high)
{
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(48),
      iterations);
  return (bracket.first + bracket.second) / 2;
}
} // namespace taut::testing
