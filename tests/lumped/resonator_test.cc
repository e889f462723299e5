#include <taut/base/exceptions.h>
#include <taut/lumped/frozen_resonator.h>
#include <taut/lumped/resonator_si.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "resonator_cases.h"

using namespace taut;
using namespace taut::lumped;
using resonator_cases::make_thesis_resonator;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// Some state off equilibrium: 1A, 2A, 1B, 2B of two networks.
const std::vector<double> some_internal = {1.6, 2.9, 1.1, 3.1,
                                           1.1, 1.3, 0.9, 1.4};

Resonator make_two_networks()
{
  return make_thesis_resonator(0.4, {0.5, 20});
}

/// Fourth-order central difference; with h = 1e-3 its error is about 1e-11 for
/// functions that change over lengths of order 1.
double differentiate(const std::function<double(double)>& f, const double x)
{
  const double h = 1e-3;
  return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h);
}

void expect_refused(const std::function<void(Resonator&)>& spoil,
                    const std::string& reason)
{
  Resonator resonator = make_two_networks();
  EXPECT_NO_THROW(validate(resonator));
  spoil(resonator);
  try
  {
    validate(resonator);
    FAIL() << "accepted, expected: " << reason;
  }
  catch (const BadInput& error)
  {
    EXPECT_NE(error.message().find(reason), std::string::npos)
        << error.message();
  }
}

/// The SI example of the physics notes: f = 7.073 Hz Omega_n.
ResonatorSI make_device()
{
  ResonatorSI device;
  device.length_a = device.length_b = device.width = 0.02;
  device.thickness = 1e-3;
  device.equilibrium_modulus = 20e3;
  device.network_moduli = {10e3, 5e3, 5e3};
  device.network_taus = {0.01, 1, 100};
  device.density = 960;
  device.bar_mass = 0.02;
  device.relative_permittivity = 4.7;
  device.breakdown_field = 155e6;
  return device;
}

void expect_device_refused(double ResonatorSI::*const value, const double bad)
{
  ResonatorSI device = make_device();
  device.*value = bad;
  EXPECT_THROW(make_resonator(device), BadInput);
}
} // namespace

TEST(ResonatorNetworks, ShareWhatTheGroundNetworkLeaves)
{
  const auto networks = make_networks(0.4, {3, 2, 1}, {0.01, 1, 100});
  ASSERT_EQ(networks.size(), 3u);
  EXPECT_DOUBLE_EQ(networks[0].weight, 0.3);
  EXPECT_DOUBLE_EQ(networks[1].weight, 0.2);
  EXPECT_DOUBLE_EQ(networks[2].weight, 0.1);
  EXPECT_EQ(networks[2].relaxation_time, 100);
}

TEST(ResonatorNetworks, TauMayBeARate)
{
  const auto networks = make_networks(0.5, {1, 1}, {4, 100}, TauMeaning::rate);
  EXPECT_DOUBLE_EQ(networks[0].relaxation_time, 0.25);
  EXPECT_DOUBLE_EQ(networks[1].relaxation_time, 0.01);
}

TEST(ResonatorNetworks, RefusesWhatDoesNotFit)
{
  EXPECT_THROW(make_networks(0.5, {1, 1}, {1}), BadInput);
  EXPECT_THROW(make_networks(0.5, {}, {}), BadInput);
  EXPECT_THROW(make_networks(1, {1}, {1}), BadInput);
  EXPECT_THROW(make_networks(0, {1}, {1}), BadInput);
  EXPECT_THROW(make_networks(1.2, {1}, {1}), BadInput);
  EXPECT_THROW(make_networks(0.5, {-1}, {1}), BadInput);
  EXPECT_THROW(make_networks(0.5, {1}, {0}), BadInput);
  EXPECT_TRUE(make_networks(1, {}, {}).empty());
}

TEST(Resonator, RefusesImpossibleParameters)
{
  expect_refused([](Resonator& r) { r.equilibrium_fraction = 0; },
                 "chi must lie in (0, 1]");
  expect_refused([](Resonator& r) { r.equilibrium_fraction = 1.1; },
                 "chi must lie in (0, 1]");
  expect_refused([](Resonator& r) { r.networks[0].weight += 0.01; },
                 "must sum to 1, got 1.01");
  expect_refused([](Resonator& r) { r.networks[0].weight = -0.3; },
                 "the weight of a network must be positive");
  expect_refused([](Resonator& r) { r.networks[1].relaxation_time = 0; },
                 "a relaxation time must be positive");
  expect_refused([](Resonator& r) { r.length_ratio = -1; },
                 "the ratio of lengths k");
  expect_refused([](Resonator& r) { r.strength = 0; }, "breakdown strength");
  expect_refused([](Resonator& r) { r.inertia_a = -1e-3; },
                 "inertia of strip A must not be negative");
  expect_refused([](Resonator& r) { r.inertia_bar = -1; },
                 "inertia of the bar must not be negative");
  expect_refused([](Resonator& r) { r.inertia_bar = 0; },
                 "the sum of the inertias");
  expect_refused([](Resonator& r) { r.voltage_unit = 0; },
                 "the unit of the voltage");
}

TEST(Resonator, RefusesAPreStretchBeyondTheGentLimit)
{
  // 4 + 16 + 1/64 - 3 = 17.015625.
  expect_refused([](Resonator& r) { r.gent_limit = 17.01; },
                 "needs a Gent limit J_lim above 17.015625, got 17.01");
  expect_refused([](Resonator& r) { r.pre_stretch_2 = 9; },
                 "the pre-stretch 2 x 9 needs");
  expect_refused([](Resonator& r) { r.pre_stretch_1 = 0; },
                 "the pre-stretch lambda_1p must be positive");
  expect_refused([](Resonator& r) { r.gent_limit = -3; }, "must be positive");
}

TEST(ResonatorSI, ExampleOfThePhysicsNotes)
{
  const auto scales = make_scales(make_device());
  const auto resonator = make_resonator(make_device());
  // The notes give three to four digits.
  EXPECT_NEAR(0.2 * scales.voltage, 6.20e3, 5);
  EXPECT_NEAR(resonator.strength, 5, 5e-3);
  EXPECT_NEAR(scales.angular_frequency, 44.44, 5e-3);
  EXPECT_NEAR(scales.angular_frequency / (2 * pi), 7.073, 5e-4);
  EXPECT_EQ(scales.stress, 40e3);
  EXPECT_DOUBLE_EQ(resonator.equilibrium_fraction, 0.5);
  EXPECT_DOUBLE_EQ(resonator.networks[0].weight, 0.25);
  EXPECT_DOUBLE_EQ(resonator.networks[2].weight, 0.125);
}

TEST(ResonatorSI, ScalesGiveForcesEnergyAndCharge)
{
  auto device = make_device();
  device.length_b = 0.04;
  const auto scales = make_scales(device);
  EXPECT_DOUBLE_EQ(make_resonator(device).length_ratio, 0.5);
  EXPECT_DOUBLE_EQ(scales.force_1, 40e3 * 0.02 * 1e-3);
  EXPECT_DOUBLE_EQ(scales.force_2a, 40e3 * 0.02 * 1e-3);
  EXPECT_DOUBLE_EQ(scales.force_2b, 40e3 * 0.04 * 1e-3);
  EXPECT_DOUBLE_EQ(scales.energy, 40e3 * 0.02 * 0.02 * 1e-3);
  // Q = permittivity V / L_3 lambda_1A^2 lambda_2^2 L_1A L_2.
  const double voltage = 5e3, area = 3. * 4.;
  const double charge =
      4.7 * vacuum_permittivity * voltage / 1e-3 * area * area * 0.02 * 0.02;
  EXPECT_NEAR(scales.charge * (voltage / scales.voltage) * area * area, charge,
              1e-14 * charge);
}

TEST(ResonatorSI, RefusesImpossibleValues)
{
  for (const auto value :
       {&ResonatorSI::length_a, &ResonatorSI::length_b, &ResonatorSI::width,
        &ResonatorSI::thickness, &ResonatorSI::equilibrium_modulus,
        &ResonatorSI::density, &ResonatorSI::bar_mass,
        &ResonatorSI::breakdown_field, &ResonatorSI::gent_limit})
    expect_device_refused(value, -1);
  expect_device_refused(&ResonatorSI::relative_permittivity, 0.5);
  expect_device_refused(&ResonatorSI::gent_limit, 10);
  auto device = make_device();
  device.network_moduli[1] = -5e3;
  EXPECT_THROW(make_resonator(device), BadInput);
}

TEST(FrozenStrip, StressesAreDerivativesOfTheEnergy)
{
  auto resonator = make_two_networks();
  const double voltage = 0.17, stretch = 2.3;
  for (const auto side : {Strip::a, Strip::b})
  {
    FrozenStrip strip(resonator, side);
    strip.freeze(some_internal.data());
    const auto response = strip.respond(stretch, voltage);
    const auto energy_1 = [&](const double l)
    { return strip.compute_energy(l, voltage); };
    const auto energy_2 = [&](const double l)
    {
      Resonator other = resonator;
      other.pre_stretch_2 = l;
      FrozenStrip widened(other, side);
      widened.freeze(some_internal.data());
      return widened.compute_energy(stretch, voltage);
    };
    const auto stress = [&](const double l)
    { return strip.respond(l, voltage).stress_1; };
    EXPECT_NEAR(response.stress_1, differentiate(energy_1, stretch), 1e-10);
    EXPECT_NEAR(response.stress_2, differentiate(energy_2, 4), 1e-10);
    EXPECT_NEAR(response.stiffness_1, differentiate(stress, stretch), 1e-10);
  }
}

TEST(FrozenStrip, OnlyStripAFeelsTheVoltage)
{
  const auto resonator = make_two_networks();
  FrozenStrip a(resonator, Strip::a), b(resonator, Strip::b);
  const std::vector<double> same(8, 1.2);
  a.freeze(same.data());
  b.freeze(same.data());
  EXPECT_EQ(a.respond(2, 0).stress_1, b.respond(2, 0.3).stress_1);
  // V*^2 lambda_1 lambda_2^2 and V*^2 lambda_2 lambda_1^2.
  EXPECT_NEAR(b.respond(2, 0).stress_1 - a.respond(2, 0.3).stress_1,
              0.09 * 2 * 16, 1e-14);
  EXPECT_NEAR(b.respond(2, 0).stress_2 - a.respond(2, 0.3).stress_2,
              0.09 * 4 * 4, 1e-14);
}

TEST(FrozenStrip, EvolutionDissipatesTheEnergyItReleases)
{
  const auto resonator = make_two_networks();
  const double stretch = 2.3;
  for (const auto side : {Strip::a, Strip::b})
  {
    FrozenStrip strip(resonator, side);
    strip.freeze(some_internal.data());
    std::vector<double> rates(8, 0.);
    strip.compute_rates(stretch, rates.data());
    const auto energy = [&](const double time)
    {
      auto internal = some_internal;
      for (std::size_t i = 0; i < internal.size(); ++i)
        internal[i] += time * rates[i];
      FrozenStrip moved(resonator, side);
      moved.freeze(internal.data());
      return moved.compute_energy(stretch, 0);
    };
    const double dissipation = strip.compute_dissipation(stretch);
    EXPECT_GT(dissipation, 0);
    EXPECT_NEAR(dissipation, -differentiate(energy, 0), 1e-8 * dissipation);
  }
}

TEST(FrozenStrip, RelaxedNetworksAreAtRest)
{
  const auto resonator = make_two_networks();
  FrozenStrip strip(resonator, Strip::a);
  const std::vector<double> relaxed = {2.3, 4, 1, 1, 2.3, 4, 1, 1};
  strip.freeze(relaxed.data());
  std::vector<double> rates(8, 0.);
  strip.compute_rates(2.3, rates.data());
  for (const double rate : rates)
    EXPECT_NEAR(rate, 0, 1e-14);
  EXPECT_NEAR(strip.compute_dissipation(2.3), 0, 1e-28);
}

TEST(FrozenStrip, RefusesStretchesBeyondTheGentLimit)
{
  const auto resonator = make_two_networks();
  FrozenStrip strip(resonator, Strip::a);
  const auto [lowest, highest] = strip.compute_admissible_interval();
  EXPECT_NO_THROW(strip.respond(highest * (1 - 1e-9), 0));
  EXPECT_THROW(strip.respond(highest * (1 + 1e-9), 0), StepRejected);
  EXPECT_NO_THROW(strip.respond(lowest * (1 + 1e-9), 0));
  EXPECT_THROW(strip.respond(lowest * (1 - 1e-9), 0), StepRejected);
}

TEST(FrozenResonator, BalanceIsFoundToRoundOffFromAnywhere)
{
  auto resonator = make_two_networks();
  for (const double k : {0.3, 1., 2.})
  {
    resonator.length_ratio = k;
    FrozenResonator frozen(resonator);
    frozen.freeze(some_internal.data());
    for (const double voltage : {0., 0.1, 0.2})
    {
      const double stretch = frozen.find_balance(voltage);
      const auto a = frozen.respond_a(stretch, voltage);
      const auto b = frozen.respond_b(stretch);
      EXPECT_NEAR(a.stress_1, b.stress_1, 1e-14);
      // Both are within a few units in the last place of the root.
      EXPECT_NEAR(frozen.find_balance(voltage, 1.05 * stretch), stretch, 1e-14);
    }
  }
}

TEST(FrozenResonator, BalanceOutsideTheGentLimitIsRejected)
{
  const auto resonator = make_two_networks();
  FrozenResonator frozen(resonator);
  // A network at rest in a wide film cannot follow a narrow one.
  const std::vector<double> internal = {2, 0.4, 2, 0.4, 2, 4, 2, 4};
  frozen.freeze(internal.data());
  EXPECT_THROW(frozen.find_balance(0.1), StepRejected);
}

TEST(FrozenResonator, FrequencyFollowsTheClosedForm)
{
  // (2.4) of the notes in a relaxed state, where the networks add
  // (1 - chi) 4 / lambda_1^2 per strip.
  auto resonator = make_two_networks();
  resonator.length_ratio = 2;
  FrozenResonator frozen(resonator);
  const double l2 = 4, v = 0.15, chi = 0.4, j = 67, la = 2.2,
               lb = resonator.get_stretch_1b(la);
  const std::vector<double> internal = {la, l2, lb, l2, la, l2, lb, l2};
  frozen.freeze(internal.data());
  const auto stiffness = [&](const double l)
  {
    const double d = j - l * l - l2 * l2 - 1 / (l * l * l2 * l2) + 3;
    const double slope = l - std::pow(l, -3) / (l2 * l2);
    return chi * j * (1 + 3 * std::pow(l, -4) / (l2 * l2)) / d +
           2 * chi * j * slope * slope / (d * d) + (1 - chi) * 4 / (l * l);
  };
  const double expected = stiffness(la) + 2 * stiffness(lb) - v * v * l2 * l2;
  EXPECT_NEAR(frozen.compute_frequency_squared(la, v), expected, 1e-14);
}
