#pragma once

#include <taut/time/integrate.h>

#include "structure/statics.h"

/// Viscous films in homogeneous tests and their runs in time.
namespace taut::testing
{
/// A unit square of distorted cells in its plane, held on rollers west and
/// south; the others as `supports` say.
inline structure::Device
make_sheet(const material::Elastomer& elastomer,
           const std::vector<structure::Support>& supports)
{
  structure::Device device;
  device.films = {make_film(material::NeoHookean{1}, 1, {{1, 1}})};
  device.films[0].material = elastomer;
  device.supports = {make_support("film", {{false, false, true}}),
                     make_support("west", {{true, false, false}}),
                     make_support("south", {{false, true, false}})};
  for (const auto& support : supports)
    device.supports.push_back(support);
  return device;
}

inline time::IntegratorOptions make_slow_options(const double tolerance)
{
  time::IntegratorOptions options;
  options.method = time::Method::bdf;
  options.position_tolerance = tolerance;
  options.internal_tolerance = tolerance;
  options.first_step = 1e-6;
  return options;
}
} // namespace taut::testing
