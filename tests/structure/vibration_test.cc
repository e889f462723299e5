// Vibration modes of the resonator against closed forms: with one element a
// strip it is the lumped model.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "structure/vibrations.h"
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/roots.hpp>

namespace taut
{
namespace
{
constexpr double pi = boost::math::constants::pi<double>();

/// The ideal resonator: two strips on rollers, Gent
/// ground network and two Gent networks, a guided bar.
constexpr double limit = 67, pre_1 = 2, pre_2 = 4, share = .5;
constexpr std::array<double, 2> weights{.3, .2}, times{.01, 3.};
constexpr double density = 960, bar_mass = .02, thickness = 1e-3, side = .01;
constexpr double modulus = 4e4;

structure::Device make_resonator(const double field)
{
  structure::Device device;
  device.mesh.degree = 1;
  auto film = testing::make_film(material::Gent{share * modulus, limit},
                                 thickness, {{pre_1, pre_2}});
  film.material.density = density;
  for (unsigned int m = 0; m < 2; ++m)
    film.material.networks.push_back(
        {material::Gent{weights[m] * modulus, limit}, times[m]});
  film.tension_field = false;
  film.axis = {{1, 0, 0}};
  device.films = {film};
  device.electrodes = {testing::make_electrode(
      "left", Signal::constant(testing::make_voltage(film, field, modulus)))};
  device.supports = {testing::make_support("west", {{true, true, true}}),
                     testing::make_support("east", {{true, true, true}}),
                     testing::make_support("film", {{false, true, true}})};
  auto bar = testing::make_bar("middle", bar_mass);
  bar.free = {{true, false, false}};
  bar.rotates = false;
  device.bars = {bar};
  return device;
}

fe::MeshData make_strips(const unsigned int cells = 1)
{
  return testing::make_rectangle(2 * cells, 1, 1, 2 * side * pre_1,
                                 side * pre_2);
}

/// 1/alpha of (3.15) with k = 1 (s^2).
double compute_inertia()
{
  return (2 * density * side * side / 3 + bar_mass / thickness) / modulus;
}

/// dD s_1/d lambda_1 of a Gent network with inner stretches, (3.29).
double compute_stiffness(const double l1, const double i1, const double i2)
{
  const double e1 = std::pow(l1 / i1, 2), e2 = std::pow(pre_2 / i2, 2),
               e3 = 1 / (e1 * e2), D = limit - e1 - e2 - e3 + 3;
  return limit * ((e1 + 3 * e3) / (l1 * l1 * D) +
                  2 * std::pow((e1 - e3) / (l1 * D), 2));
}

/// lambda_1A: the bar is the only free unknown.
double get_stretch(testing::Resting& resonator)
{
  double u = 0;
  if (resonator.system().structure().n_free() > 0)
    u = resonator.state()[0];
  return pre_1 +
         dealii::Utilities::MPI::sum(u, resonator.system().communicator()) /
             side;
}

/// Omega_n^2 alpha of (3.29) for networks relaxed or just stretched.
double compute_frequency(const double l1, const double field,
                         const bool relaxed)
{
  const auto strip = [&](const double l)
  {
    double sum = share * compute_stiffness(l, 1, 1);
    for (const double weight : weights)
      sum += weight * (relaxed ? 4 / (l * l) : compute_stiffness(l, 1, 1));
    return sum;
  };
  return (strip(l1) + strip(2 * pre_1 - l1) - std::pow(field * pre_2, 2)) /
         compute_inertia();
}

TEST(ResonatorModes, IdealResonatorHasTheLumpedFrequency)
{
  for (const double field : {0., .1})
    for (const bool relaxed : {true, false})
    {
      testing::Resting resonator(make_resonator(field), make_strips(), relaxed);
      const double expected =
          compute_frequency(get_stretch(resonator), field, relaxed);
      const auto squares = resonator.find_squares(5);
      ASSERT_EQ(squares.size(), 1u);
      EXPECT_NEAR(squares[0] / expected, 1, 1e-10)
          << "field " << field << ", relaxed " << relaxed;
    }
}

TEST(ResonatorModes, ChargeStiffensWhatVoltageSoftens)
{
  const double field = .1;
  auto device = make_resonator(field);
  testing::Resting by_voltage(device, make_strips());
  const double l = get_stretch(by_voltage);
  auto& structure = by_voltage.system().structure();
  const auto loads = by_voltage.system().loads_at(0, by_voltage.state().data());
  structure.compute_positions(loads, by_voltage.state().data());
  std::vector<double> forces(structure.n_free());
  structure.compute_forces(
      loads, by_voltage.state().data(),
      by_voltage.system().internal(by_voltage.state().data()),
      structure::Networks::as_given, forces.data(), nullptr);
  device.electrodes[0].control = structure::Electrode::Control::charge;
  device.electrodes[0].voltage = Signal();
  device.electrodes[0].charge =
      Signal::constant(structure.compute_charges(loads)[0]);
  testing::Resting by_charge(device, make_strips());
  EXPECT_NEAR(get_stretch(by_charge), l, 1e-10);
  // - V^2 c/2 against Q^2/(2 c) with c = c_0 l^2: second derivatives -c_0 V^2
  // and 3 c_0 V^2.
  EXPECT_NEAR((by_charge.find_squares(1)[0] - by_voltage.find_squares(1)[0]) *
                  compute_inertia() / (4 * std::pow(field * pre_2, 2)),
              1, 1e-6);
}

/// What a relaxation adds to the square of a fast frequency, and its time.
struct Part
{
  double stiffness, time;
};

/// The root of s^2 + s d + w_r^2 + sum of k_m s T_m/(1 + s T_m) next to a
/// guess (Newton's method).
std::complex<double> find_root(const double relaxed,
                               const std::vector<Part>& parts,
                               const double drag, std::complex<double> s)
{
  for (unsigned int i = 0; i < 50; ++i)
  {
    std::complex<double> value = s * s + drag * s + relaxed,
                         slope = 2. * s + drag;
    for (const Part& part : parts)
    {
      const auto quotient = 1. + s * part.time;
      value += part.stiffness * s * part.time / quotient;
      slope += part.stiffness * part.time / (quotient * quotient);
    }
    s -= value / slope;
  }
  return s;
}

TEST(ResonatorModes, RelaxedResonatorIsAZenerOscillator)
{
  for (const double drag : {0., 500.})
  {
    const double field = .1;
    auto device = make_resonator(field);
    device.environment.air_drag = drag;
    testing::Resting resonator(device, make_strips());
    const double l = get_stretch(resonator);
    const double frozen = compute_frequency(l, field, true);
    std::vector<Part> parts;
    double relaxed = frozen;
    for (unsigned int m = 0; m < 2; ++m)
    {
      parts.push_back(
          {weights[m] * (4 / (l * l) + 4 / std::pow(2 * pre_1 - l, 2)) /
               compute_inertia(),
           times[m]});
      relaxed -= parts[m].stiffness;
    }
    auto vibration = resonator.make_vibration();
    const auto modes = time::find_modes(vibration, {}).modes;
    vibration.relax();
    const auto slow = time::find_modes(vibration, {}).modes;
    ASSERT_EQ(slow.size(), 1u);
    EXPECT_NEAR(slow[0].square / relaxed, 1, 1e-10);
    const auto damped = structure::compute_damped_modes(vibration, modes, slow);
    const double omega = std::sqrt(frozen);
    ASSERT_EQ(damped.size(), 1u);
    ASSERT_EQ(damped[0].products.size(), 2u);
    for (unsigned int m = 0; m < 2; ++m)
      EXPECT_NEAR(damped[0].products[m] / (omega * times[m]), 1, 1e-9);
    // Drag acts on the film only, as its mass does.
    const double resistance = drag / density *
                              (2 * density * side * side / 3 / modulus) /
                              compute_inertia();
    const auto root =
        find_root(relaxed, parts, resistance, std::complex<double>(0, omega));
    EXPECT_NEAR(std::abs(damped[0].rate / root - 1.), 0, 1e-9);
    EXPECT_GT(damped[0].ratio(), .01);
  }
}

TEST(ResonatorModes, CircuitRelaxesBetweenVoltageAndCharge)
{
  const double field = .12;
  auto device = make_resonator(field);
  device.films[0].material.networks.clear();
  device.electrodes[0].control = structure::Electrode::Control::circuit;
  const double l = get_stretch(*std::make_unique<testing::Resting>(
      make_resonator(field), make_strips()));
  const double unit = testing::make_voltage(device.films[0], 1, modulus);
  const double capacitance =
      modulus * side * side * thickness * std::pow(l * pre_2 / unit, 2);
  // About one radian.
  const double time = .02;
  device.electrodes[0].series_resistance = time / capacitance;
  testing::Resting resonator(device, make_strips());
  EXPECT_NEAR(get_stretch(resonator), l, 1e-10);
  auto vibration = resonator.make_vibration();
  ASSERT_EQ(vibration.relaxations().size(), 1u);
  EXPECT_NEAR(vibration.relaxations()[0].time / time, 1, 1e-9);
  const auto modes = time::find_modes(vibration, {}).modes;
  const auto damped = structure::compute_damped_modes(vibration, modes, {});
  // As the spring alone, which is what is left of the networks.
  const double by_voltage = (share * compute_stiffness(l, 1, 1) +
                             share * compute_stiffness(2 * pre_1 - l, 1, 1) -
                             std::pow(field * pre_2, 2)) /
                            compute_inertia();
  const Part circuit{4 * std::pow(field * pre_2, 2) / compute_inertia(), time};
  EXPECT_NEAR(modes[0].square / (by_voltage + circuit.stiffness), 1, 1e-6);
  const auto root =
      find_root(by_voltage, {circuit}, 0, {0, std::sqrt(modes[0].square)});
  // Differences by the voltage make the border.
  EXPECT_NEAR(std::abs(damped[0].rate / root - 1.), 0, 1e-6);
  EXPECT_GT(damped[0].ratio(), .01);
}

TEST(ResonatorModes, NetworksOfHeldWidthRelaxAtAnotherRate)
{
  // With the width held at 1, xi' = (xi/T) (l^2/xi^4 - l^-2) loses
  // 4/(l^2 T) of a difference from its rest xi = l in a second (Wang et al.
  // 2024, equation 23).
  auto device = make_resonator(0);
  device.electrodes.clear();
  const double l = 1.5, time = .01;
  auto& film = device.films[0];
  film.pre_stretch = {l, 1};
  film.material.springs = {material::NeoHookean{modulus}};
  film.material.networks = {
      {material::NeoHookean{modulus}, time, material::FlowLaw::held_width}};
  testing::Resting resonator(device,
                             testing::make_rectangle(2, 1, 1, .02 * l, .01));
  auto vibration = resonator.make_vibration();
  const auto modes = time::find_modes(vibration, {}).modes;
  const auto damped = structure::compute_damped_modes(vibration, modes, {});
  const double omega = std::sqrt(modes[0].square);
  EXPECT_NEAR(damped[0].products[0] / (omega * time * l * l / 4), 1, 1e-9);
}

TEST(ResonatorModes, EffectiveMassesOfAllModesAreTheMassThatMoves)
{
  auto device = make_resonator(.1);
  device.mesh.degree = 2;
  device.supports[2].held = {false, false, true};
  testing::Resting resonator(
      device, testing::make_rectangle(4, 2, 1, 4 * side, 4 * side));
  auto vibration = resonator.make_vibration();
  time::ModeOptions options;
  options.count = 1000;
  const auto modes = time::find_modes(vibration, options).modes;
  for (unsigned int axis = 0; axis < 2; ++axis)
  {
    const auto& inertia = vibration.get_unit_inertia(axis);
    double sum = 0;
    for (const auto& mode : modes)
      sum += std::pow(vibration.multiply(mode.shape.data(), inertia.data()), 2);
    // b . M^{-1} b, b the inertia of a unit acceleration.
    std::vector<double> rest(inertia.size());
    resonator.system().structure().solve_mass(inertia.data(), rest.data());
    EXPECT_NEAR(sum / vibration.multiply(rest.data(), inertia.data()), 1, 1e-9);
    EXPECT_LT(sum, vibration.total_mass());
  }
  EXPECT_NEAR(vibration.total_mass(),
              bar_mass + 2 * density * side * side * thickness, 1e-12);
}

/// Roots of z tan z = 2 M/m of motions in which the bar takes part.
double find_wave(const double ratio, const double from, const double to)
{
  std::uintmax_t iterations = 200;
  return boost::math::tools::toms748_solve(
             [=](const double z)
             { return ratio * z * std::sin(z) - 2 * std::cos(z); },
             from, to, boost::math::tools::eps_tolerance<double>(50),
             iterations)
      .first;
}

TEST(ResonatorModes, ManyElementsCarryWavesInTheStrips)
{
  auto device = make_resonator(0);
  device.mesh.degree = 2;
  const double strip_mass = density * side * side * thickness;
  device.bars[0].mass = 2 * strip_mass;
  testing::Resting resonator(device, make_strips(12));
  const auto squares = resonator.find_squares(3);
  // Symmetric strips: k = 1, V = 0, both waves at c^2 = G S'/rho.
  const double stiffness = modulus / density *
                           (share * compute_stiffness(pre_1, 1, 1) +
                            (1 - share) * 4 / pre_1 / pre_1);
  const double unit = stiffness / (side * side);
  EXPECT_NEAR(squares[0] / unit / std::pow(find_wave(2, .1, 1.5), 2), 1, 1e-6);
  // With the bar at rest.
  EXPECT_NEAR(squares[1] / unit / (pi * pi), 1, 1e-5);
  EXPECT_NEAR(squares[2] / unit / std::pow(find_wave(2, 3.2, 4.7), 2), 1, 1e-4);
}
} // namespace
} // namespace taut
