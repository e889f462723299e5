#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/lumped/resonator.h>

#include <cmath>
#include <numeric>
#include <string>

namespace taut::lumped
{
namespace
{
void require_positive(const double value, const std::string& name)
{
  if (!(value > 0) || !std::isfinite(value))
    throw BadInput(name + " must be positive and finite, got " +
                   number_text(value));
}

void require_not_negative(const double value, const std::string& name)
{
  if (!(value >= 0) || !std::isfinite(value))
    throw BadInput(name + " must not be negative, got " + number_text(value));
}

void require_fraction(const double fraction)
{
  if (!(fraction > 0 && fraction <= 1))
    throw BadInput("the equilibrium fraction chi must lie in (0, 1], got " +
                   number_text(fraction));
}

void validate_networks(const Resonator& resonator)
{
  double sum = resonator.equilibrium_fraction;
  for (const auto& network : resonator.networks)
  {
    require_positive(network.weight, "the weight of a network");
    require_positive(network.relaxation_time, "a relaxation time");
    sum += network.weight;
  }
  // Weights are commonly given with a few digits less than a double holds.
  if (std::abs(sum - 1) > 1e-9)
    throw BadInput("the equilibrium fraction and the weights of the networks "
                   "must sum to 1, got " +
                   number_text(sum));
}

void validate_pre_stretch(const Resonator& resonator)
{
  require_positive(resonator.gent_limit, "the Gent limit J_lim");
  require_positive(resonator.pre_stretch_1, "the pre-stretch lambda_1p");
  require_positive(resonator.pre_stretch_2, "the pre-stretch lambda_2p");
  const double a = resonator.pre_stretch_1 * resonator.pre_stretch_1;
  const double b = resonator.pre_stretch_2 * resonator.pre_stretch_2;
  const double reached = a + b + 1 / (a * b) - 3;
  if (!(reached < resonator.gent_limit))
    throw BadInput("the pre-stretch " + number_text(resonator.pre_stretch_1) +
                   " x " + number_text(resonator.pre_stretch_2) +
                   " needs a Gent limit J_lim above " + number_text(reached) +
                   ", got " + number_text(resonator.gent_limit));
}
} // namespace

std::vector<ResonatorNetwork> make_networks(const double equilibrium_fraction,
                                            const std::vector<double>& split,
                                            const std::vector<double>& tau,
                                            const TauMeaning meaning)
{
  require_fraction(equilibrium_fraction);
  if (split.size() != tau.size())
    throw BadInput("the networks have " + std::to_string(split.size()) +
                   " weights but " + std::to_string(tau.size()) +
                   " relaxation times");
  if (split.empty() != (equilibrium_fraction == 1))
    throw BadInput("an equilibrium fraction below 1 needs networks, and 1 "
                   "leaves nothing for them; got " +
                   number_text(equilibrium_fraction) + " and " +
                   std::to_string(split.size()) + " networks");
  for (std::size_t m = 0; m < split.size(); ++m)
  {
    require_positive(split[m], "the weight of a network");
    require_positive(tau[m], "tau of a network");
  }
  const double sum = std::accumulate(split.begin(), split.end(), 0.);
  std::vector<ResonatorNetwork> networks;
  for (std::size_t m = 0; m < split.size(); ++m)
    networks.push_back({(1 - equilibrium_fraction) * split[m] / sum,
                        meaning == TauMeaning::rate ? 1 / tau[m] : tau[m]});
  return networks;
}

void validate(const Resonator& resonator)
{
  require_positive(resonator.length_ratio, "the ratio of lengths k");
  require_fraction(resonator.equilibrium_fraction);
  validate_networks(resonator);
  validate_pre_stretch(resonator);
  require_positive(resonator.strength, "the breakdown strength d");
  require_positive(resonator.voltage_unit, "the unit of the voltage");
  require_not_negative(resonator.inertia_a, "the inertia of strip A");
  require_not_negative(resonator.inertia_b, "the inertia of strip B");
  require_not_negative(resonator.inertia_bar, "the inertia of the bar");
  require_positive(resonator.inertia_a + resonator.inertia_b +
                       resonator.inertia_bar,
                   "the sum of the inertias of strips and bar");
}
} // namespace taut::lumped
