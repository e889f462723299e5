#include <taut/base/exceptions.h>
#include <taut/lumped/frozen_resonator.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

#include <boost/math/tools/toms748_solve.hpp>

namespace taut::lumped
{
FrozenStrip::FrozenStrip(const Resonator& resonator, const Strip strip)
    : gent_limit_(resonator.gent_limit), stretch_2_(resonator.pre_stretch_2),
      electrified_(strip == Strip::a), offset_(strip == Strip::a ? 0 : 2)
{
  networks_.push_back({resonator.equilibrium_fraction, 0, 1, 1, 0, 0, 0});
  for (const auto& network : resonator.networks)
    networks_.push_back(
        {network.weight, 1 / (6 * network.relaxation_time), 1, 1, 0, 0, 0});
  for (auto& network : networks_)
  {
    network.inverse_square_1 = 1;
    network.e2 = stretch_2_ * stretch_2_;
    network.e3_square_1 = 1 / network.e2;
  }
}

void FrozenStrip::freeze(const double* const internal)
{
  for (std::size_t m = 1; m < networks_.size(); ++m)
  {
    Network& network = networks_[m];
    network.internal_1 = internal[4 * (m - 1) + offset_];
    network.internal_2 = internal[4 * (m - 1) + offset_ + 1];
    const double square_1 = network.internal_1 * network.internal_1;
    const double elastic_2 = stretch_2_ / network.internal_2;
    network.inverse_square_1 = 1 / square_1;
    network.e2 = elastic_2 * elastic_2;
    network.e3_square_1 = square_1 / network.e2;
  }
}

FrozenStrip::Elastic FrozenStrip::compute_elastic(const Network& network,
                                                  const double square_1) const
{
  const double e1 = square_1 * network.inverse_square_1;
  const double e3 = network.e3_square_1 / square_1;
  const double margin = gent_limit_ - e1 - network.e2 - e3 + 3;
  if (!(margin > 0 && e1 > 0))
    throw StepRejected("a strip of the resonator is stretched beyond its Gent "
                       "limit");
  return {e1, network.e2, e3, margin};
}

bool FrozenStrip::is_admissible(const double stretch_1) const
{
  const double square_1 = stretch_1 * stretch_1;
  return stretch_1 > 0 &&
         std::all_of(networks_.begin(), networks_.end(),
                     [&](const Network& network)
                     {
                       return network.inverse_square_1 * square_1 + network.e2 +
                                  network.e3_square_1 / square_1 <
                              gent_limit_ + 3;
                     });
}

std::pair<double, double> FrozenStrip::compute_admissible_interval() const
{
  double lowest = 0, highest = std::numeric_limits<double>::infinity();
  for (const auto& network : networks_)
  {
    // The squares of the ends solve e_1 + e_3 = J_lim + 3 - e_2.
    const double half_sum =
        (gent_limit_ + 3 - network.e2) / (2 * network.inverse_square_1);
    const double product = network.e3_square_1 / network.inverse_square_1;
    const double root = half_sum * half_sum - product;
    if (!(half_sum > 0 && root > 0))
      throw StepRejected("a strip of the resonator is stretched beyond its "
                         "Gent limit at any length");
    const double square = half_sum + std::sqrt(root);
    highest = std::min(highest, std::sqrt(square));
    lowest = std::max(lowest, std::sqrt(product / square));
  }
  return {lowest, highest};
}

StripResponse FrozenStrip::respond(const double stretch_1,
                                   const double voltage) const
{
  const double square_1 = stretch_1 * stretch_1;
  StripResponse sum;
  for (const auto& network : networks_)
  {
    const auto [e1, e2, e3, margin] = compute_elastic(network, square_1);
    const double factor = network.weight * gent_limit_ / margin;
    const double difference = e1 - e3;
    sum.stress_1 += factor * difference;
    sum.stress_2 += factor * (e2 - e3);
    sum.stiffness_1 +=
        factor * (e1 + 3 * e3 + 2 * difference * difference / margin);
  }
  const double field = electrified_ ? voltage * stretch_2_ : 0;
  return {sum.stress_1 / stretch_1 - field * field * stretch_1,
          sum.stress_2 / stretch_2_ - field * field * square_1 / stretch_2_,
          sum.stiffness_1 / square_1 - field * field};
}

void FrozenStrip::compute_rates(const double stretch_1,
                                double* const rates) const
{
  const double square_1 = stretch_1 * stretch_1;
  for (std::size_t m = 1; m < networks_.size(); ++m)
  {
    const Network& network = networks_[m];
    const auto [e1, e2, e3, margin] = compute_elastic(network, square_1);
    const double factor = network.mobility * gent_limit_ / margin;
    double* const rate = rates + 4 * (m - 1) + offset_;
    rate[0] = network.internal_1 * factor * (2 * e1 - e2 - e3);
    rate[1] = network.internal_2 * factor * (2 * e2 - e1 - e3);
  }
}

double FrozenStrip::compute_energy(const double stretch_1,
                                   const double voltage) const
{
  const double square_1 = stretch_1 * stretch_1;
  double energy = 0;
  for (const auto& network : networks_)
  {
    const auto elastic = compute_elastic(network, square_1);
    energy -= network.weight * gent_limit_ / 2 *
              std::log1p((elastic.margin - gent_limit_) / gent_limit_);
  }
  const double field = electrified_ ? voltage * stretch_2_ : 0;
  return energy - field * field * square_1 / 2;
}

double FrozenStrip::compute_dissipation(const double stretch_1) const
{
  const double square_1 = stretch_1 * stretch_1;
  double power = 0;
  for (const auto& network : networks_)
  {
    const auto [e1, e2, e3, margin] = compute_elastic(network, square_1);
    const double factor = gent_limit_ / margin;
    const double mean = (e1 + e2 + e3) / 3;
    const double deviator = (e1 - mean) * (e1 - mean) +
                            (e2 - mean) * (e2 - mean) +
                            (e3 - mean) * (e3 - mean);
    power += 3 * network.weight * network.mobility * factor * factor * deviator;
  }
  return power;
}

FrozenResonator::FrozenResonator(const Resonator& resonator)
    : resonator_(resonator), a_(resonator, Strip::a), b_(resonator, Strip::b)
{
}

void FrozenResonator::freeze(const double* const internal)
{
  a_.freeze(internal);
  b_.freeze(internal);
}

StripResponse FrozenResonator::respond_a(const double stretch_1a,
                                         const double voltage) const
{
  return a_.respond(stretch_1a, voltage);
}

StripResponse FrozenResonator::respond_b(const double stretch_1a) const
{
  return b_.respond(resonator_.get_stretch_1b(stretch_1a), 0);
}

double FrozenResonator::compute_frequency_squared(const double stretch_1a,
                                                  const double voltage) const
{
  return respond_a(stretch_1a, voltage).stiffness_1 +
         resonator_.length_ratio * respond_b(stretch_1a).stiffness_1;
}

std::pair<double, double>
FrozenResonator::compute_imbalance(const double stretch_1a,
                                   const double voltage) const
{
  const auto a = respond_a(stretch_1a, voltage);
  const auto b = respond_b(stretch_1a);
  return {a.stress_1 - b.stress_1,
          a.stiffness_1 + resonator_.length_ratio * b.stiffness_1};
}

double FrozenResonator::find_balance(const double voltage,
                                     const double guess) const
{
  double stretch = guess;
  auto [imbalance, stiffness] = compute_imbalance(stretch, voltage);
  for (int iteration = 0; iteration < 60; ++iteration)
  {
    if (!(stiffness > 0))
      throw StepRejected("the balance of the strips has lost its stability");
    double step = -imbalance / stiffness;
    // Newton is quadratic: the step after such a small one would be round-off.
    if (std::abs(step) < 1e-9 * stretch)
      return stretch + step;
    while (!is_admissible(stretch + step))
      step /= 2;
    stretch += step;
    std::tie(imbalance, stiffness) = compute_imbalance(stretch, voltage);
  }
  throw StepRejected("the strips of the resonator find no balance");
}

double FrozenResonator::find_balance(const double voltage) const
{
  const auto [lowest_a, highest_a] = a_.compute_admissible_interval();
  const auto [lowest_b, highest_b] = b_.compute_admissible_interval();
  const double k = resonator_.length_ratio;
  const double held = resonator_.pre_stretch_1 * (1 + 1 / k);
  // Just inside, where the stresses are large but finite.
  const double inside = 1e-12;
  const double begin = std::max(lowest_a, held - highest_b / k) * (1 + inside);
  const double end = std::min(highest_a, held - lowest_b / k) * (1 - inside);
  const auto imbalance = [&](const double stretch_1a)
  { return compute_imbalance(stretch_1a, voltage).first; };
  if (!(begin < end) || !(imbalance(begin) < 0) || !(imbalance(end) > 0))
    throw StepRejected("the strips of the resonator find no balance");
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      imbalance, begin, end, boost::math::tools::eps_tolerance<double>(40),
      iterations);
  return find_balance(voltage, (bracket.first + bracket.second) / 2);
}

bool FrozenResonator::is_admissible(const double stretch_1a) const
{
  return a_.is_admissible(stretch_1a) &&
         b_.is_admissible(resonator_.get_stretch_1b(stretch_1a));
}

void FrozenResonator::compute_rates(const double stretch_1a,
                                    double* const rates) const
{
  a_.compute_rates(stretch_1a, rates);
  b_.compute_rates(resonator_.get_stretch_1b(stretch_1a), rates);
}

double FrozenResonator::compute_energy(const double stretch_1a,
                                       const double voltage) const
{
  return a_.compute_energy(stretch_1a, voltage) +
         b_.compute_energy(resonator_.get_stretch_1b(stretch_1a), 0) /
             resonator_.length_ratio;
}

double FrozenResonator::compute_dissipation(const double stretch_1a) const
{
  return a_.compute_dissipation(stretch_1a) +
         b_.compute_dissipation(resonator_.get_stretch_1b(stretch_1a)) /
             resonator_.length_ratio;
}
} // namespace taut::lumped
