#pragma once

#include <taut/lumped/resonator.h>

#include <vector>

namespace resonator_cases
{
/// The resonator of the thesis: pre-stretch 2 x 4, k = 1, J_lim = 67 (fitted to
/// its statements), networks that share 1 - chi equally.
inline taut::lumped::Resonator
make_thesis_resonator(const double equilibrium_fraction,
                      const std::vector<double>& relaxation_times)
{
  taut::lumped::Resonator resonator;
  resonator.equilibrium_fraction = equilibrium_fraction;
  resonator.networks = taut::lumped::make_networks(
      equilibrium_fraction, std::vector<double>(relaxation_times.size(), 1.),
      relaxation_times);
  return resonator;
}
} // namespace resonator_cases
