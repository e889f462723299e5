// Films whose charge is prescribed: closed forms, stability, and charges that
// no voltage gives. Units: modulus, thickness and square are 1.
#include <taut/base/exceptions.h>
#include <taut/structure/probes.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "structure/statics.h"

namespace taut
{
namespace
{
using Control = structure::Electrode::Control;
using structure::Networks;

/// A square in its plane on rollers west and south, without compression laws.
structure::Device make_square(const material::Spring& spring)
{
  structure::Device device;
  device.films = {testing::make_film(spring, 1, {{1, 1}})};
  device.films[0].tension_field = false;
  device.electrodes = {testing::make_electrode("film", Signal())};
  device.electrodes[0].control = Control::charge;
  device.supports = {testing::make_support("film", {{false, false, true}}),
                     testing::make_support("west", {{true, false, false}}),
                     testing::make_support("south", {{false, true, false}})};
  return device;
}

/// The voltage of the dimensionless field 1.
double get_unit(const structure::Device& device)
{
  return testing::make_voltage(device.films[0], 1, 1);
}

/// Et of a free equibiaxial Gent film, limit 100.
double compute_field(const double l)
{
  return std::sqrt((std::pow(l, -2) - std::pow(l, -8)) /
                   (1 - (2 * l * l + std::pow(l, -4) - 3) / 100));
}

/// The charge of the unit square at the field Et and stretches (l, w).
double compute_charge(const structure::Device& device, const double field,
                      const double l, const double w)
{
  return field * l * l * w * w / get_unit(device);
}

void stretch(const structure::Structure& structure, const double l,
             std::vector<double>& u)
{
  const auto& free = structure.free_unknowns();
  for (std::size_t i = 0; i < free.size(); ++i)
    u[i] = (l - 1) * structure.nodes().mesh_position[free[i] / 3][free[i] % 3];
}

TEST(Charge, FollowsTheGentCurveThroughItsUnstablePart)
{
  // The peak is at 1.2638, the valley at 5.0743: numbers to 1e-8.
  const std::vector<double> stretches{1,   1.1, 1.2, 1.26380444, 1.3, 1.5, 2,
                                      2.6, 3.4, 4.2, 5.07425996, 5.6, 6.3, 6.8};
  auto device = make_square(material::Gent{1, 100});
  std::vector<double> charges;
  for (const double l : stretches)
    charges.push_back(compute_charge(device, compute_field(l), l, l));
  device.electrodes[0].charge = Signal::table(stretches, charges);
  testing::Model model(device, testing::make_sheet_mesh());
  auto& structure = *model.structure;
  structure::LoadHistory history(device);
  structure::Equilibrium problem(structure, history, Networks::relaxed,
                                 nullptr);
  std::vector<double> u(structure.n_free(), 0.);
  time::PathOptions options;
  options.first_step = options.largest_step = .1;
  // Springs and field nearly cancel; Newton overshoots the tolerance.
  options.newton.tolerance = 1e-6;
  const auto ignore = [](double, const double*) {};
  for (std::size_t i = 0; i + 1 < stretches.size(); ++i)
  {
    history.enter_interval(stretches[i]);
    const double l = stretches[i + 1];
    time::follow_path(problem, stretches[i], l, u.data(), options, ignore);
    const auto loads = structure.resolve_voltages(history.at(l), u.data(),
                                                  nullptr, Networks::relaxed);
    EXPECT_NEAR(loads.voltages[0] / get_unit(device), compute_field(l), 1e-8);
    EXPECT_LT(
        testing::compute_deviation(
            fe::compute_metric(structure.cells(),
                               structure.compute_positions(loads, u.data())),
            {{l * l, l * l, 0}}),
        1e-8);
  }
  EXPECT_NEAR(compute_field(1.26380444), .68936322, 1e-8);
  EXPECT_NEAR(compute_field(5.07425996), .27460055, 1e-8);
}

/// Negative eigenvalues of a free Gent square at the stretch l.
int count_unstable(const double l, const Control control)
{
  auto device = make_square(material::Gent{1, 100});
  device.electrodes[0].control = control;
  const double field = compute_field(l);
  device.electrodes[0].voltage = Signal::constant(field * get_unit(device));
  device.electrodes[0].charge =
      Signal::constant(compute_charge(device, field, l, l));
  testing::Model model(device, testing::make_sheet_mesh());
  testing::Statics statics(*model.structure);
  stretch(*model.structure, l, statics.u);
  return statics.count_negative_eigenvalues();
}

TEST(Charge, FreeFilmIsStableJustBeyondTheVoltagesPeak)
{
  EXPECT_EQ(count_unstable(1.2637, Control::voltage), 0);
  EXPECT_EQ(count_unstable(1.2640, Control::voltage), 1);
  EXPECT_EQ(count_unstable(1.2637, Control::charge), 0);
  EXPECT_EQ(count_unstable(1.2640, Control::charge), 0);
  // Further on its free edges let parts thin at the expense of others; charge
  // stops one mode only, the uniform one. Beyond the valley all is stable.
  EXPECT_EQ(count_unstable(2, Control::voltage) -
                count_unstable(2, Control::charge),
            1);
  EXPECT_EQ(count_unstable(5.08, Control::charge), 0);
}

TEST(Charge, DeadLoadedFilmIsStableBeyondPullIn)
{
  // The load s = 1 on the edges: e = l^-2 - l^-8 - l^-3 has its peak at
  // l = 1.7463.
  auto device = make_square(material::NeoHookean{1});
  for (const auto& [group, direction] :
       {std::pair<std::string, std::array<double, 3>>{"east", {{1, 0, 0}}},
        {"north", {{0, 1, 0}}}})
  {
    structure::EdgeLoad load;
    load.name = "pull " + group;
    load.groups = {group};
    load.direction = direction;
    load.force = Signal::constant(1);
    device.edge_loads.push_back(load);
  }
  const auto compute_dead_loaded_field = [](const double l)
  { return std::sqrt(std::pow(l, -2) - std::pow(l, -8) - std::pow(l, -3)); };
  testing::Model model(device, testing::make_sheet_mesh());
  testing::Statics statics(*model.structure);
  for (const double l : {1.7, 1.76, 1.8})
  {
    const double field = compute_dead_loaded_field(l);
    auto& electrode = statics.loads.electrodes[0];
    electrode.control = Control::charge;
    electrode.charge = Signal::constant(compute_charge(device, field, l, l));
    statics.apply();
    stretch(*model.structure, .98 * l, statics.u);
    statics.find();
    EXPECT_LT(testing::compute_deviation(statics.compute_metric(),
                                         {{l * l, l * l, 0}}),
              1e-8);
    EXPECT_EQ(statics.count_negative_eigenvalues(), 0) << l;
    electrode.control = Control::voltage;
    statics.set_voltage(field * get_unit(device));
    EXPECT_EQ(statics.count_negative_eigenvalues(), l > 1.7463) << l;
  }
}

/// Negative eigenvalues of the tangent as a dense matrix.
int count_densely(structure::Structure& structure,
                  const structure::LoadState& loads, const double* u)
{
  const std::size_t n = structure.n_free();
  dealii::LAPACKFullMatrix<double> matrix(n, n);
  for (std::size_t k = 0; k < n; ++k)
  {
    std::vector<double> unit(n, 0.), column(n);
    unit[k] = 1;
    structure.multiply_tangent(loads, u, nullptr, Networks::relaxed,
                               std::numeric_limits<double>::infinity(), false,
                               true, unit.data(), column.data());
    for (std::size_t i = 0; i < n; ++i)
      matrix(i, k) = column[i];
  }
  matrix.compute_eigenvalues();
  int count = 0;
  for (std::size_t k = 0; k < n; ++k)
    count += matrix.eigenvalue(k).real() < 0;
  return count;
}

TEST(Charge, UnstableModesAreThoseOfTheDenseTangentWithTwoElectrodes)
{
  auto device = make_square(material::Gent{1, 100});
  device.electrodes = {testing::make_electrode("left", Signal()),
                       testing::make_electrode("right", Signal())};
  const double l = 1.6, field = compute_field(l);
  for (auto& electrode : device.electrodes)
  {
    electrode.voltage = Signal::constant(field * get_unit(device));
    electrode.charge =
        Signal::constant(.5 * compute_charge(device, field, l, l));
  }
  std::vector<int> counts;
  for (const auto& controls :
       std::vector<std::array<Control, 2>>{{Control::voltage, Control::voltage},
                                           {Control::charge, Control::voltage},
                                           {Control::charge, Control::charge}})
  {
    for (const unsigned int e : {0, 1})
      device.electrodes[e].control = controls[e];
    // Halves of equal charge need halves of equal size.
    testing::Model model(device, testing::make_rectangle(2, 2, 2, 1, 1), 0, {},
                         MPI_COMM_SELF);
    testing::Statics statics(*model.structure);
    stretch(*model.structure, l, statics.u);
    counts.push_back(statics.count_negative_eigenvalues());
    const auto loads = statics.get_loads();
    EXPECT_EQ(counts.back(),
              count_densely(*model.structure, loads, statics.u.data()));
  }
  EXPECT_GT(counts[0], counts[1]);
  EXPECT_GE(counts[1], counts[2]);
}

TEST(Charge, ForceOfAHeldStripIsThatOfTheLumpedModel)
{
  // Width held: s = l - l^-3 - D^2/(eps l^3), the charge D per undeformed area.
  auto device = make_square(material::NeoHookean{1});
  device.supports.push_back(
      testing::make_support("east", {{true, false, false}}, {{"1", "0", "0"}}));
  device.supports.push_back(
      testing::make_support("north", {{false, true, false}}));
  testing::Model model(device, testing::make_sheet_mesh());
  testing::Statics statics(*model.structure);
  for (const double D : {.4, -.9})
  {
    statics.loads.electrodes[0].charge = Signal::constant(D / get_unit(device));
    for (const double l : {1.2, 1.9})
    {
      statics.set_amplitude(3, l - 1);
      const auto& X = model.structure->nodes().mesh_position;
      const auto& free = model.structure->free_unknowns();
      for (std::size_t i = 0; i < free.size(); ++i)
        statics.u[i] = free[i] % 3 == 0 ? (l - 1) * X[free[i] / 3][0] : 0;
      statics.find();
      EXPECT_NEAR(statics.get_reaction(3)[0], l - (1 + D * D) * std::pow(l, -3),
                  1e-11);
      const auto loads = statics.get_loads();
      EXPECT_NEAR(loads.voltages[0] / get_unit(device), D / (l * l), 1e-12);
    }
  }
}

/// A film clamped at stretches (2, .6): wrinkled.
structure::Device make_wrinkled()
{
  auto device = make_square(material::NeoHookean{1});
  device.films[0].tension_field = true;
  device.films[0].pre_stretch = {{2, .6}};
  for (const char* edge : {"east", "north"})
    device.supports.push_back(
        testing::make_support(edge, {{true, true, true}}));
  return device;
}

TEST(Charge, VoltageOfAWrinkledFilmIsTheSlopeOfItsEnergy)
{
  testing::Model model(make_wrinkled(), testing::make_sheet_mesh());
  testing::Statics statics(*model.structure);
  // A third of the charge at which the wrinkles run away.
  const double charge = 6e-6, step = 1e-3 * charge;
  const auto compute_energy = [&](const double Q)
  {
    statics.loads.electrodes[0].charge = Signal::constant(Q);
    statics.apply();
    statics.find();
    return statics.compute_energies().total();
  };
  const double slope =
      (compute_energy(charge + step) - compute_energy(charge - step)) /
      (2 * step);
  compute_energy(charge);
  const auto loads = statics.get_loads();
  // Central differences: of the square of the step.
  EXPECT_NEAR(slope, loads.voltages[0], 1e-6 * loads.voltages[0]);
  EXPECT_NEAR(model.structure->compute_charges(loads)[0], charge,
              1e-10 * charge);
}

TEST(Charge, ThatNoVoltageGivesIsRefused)
{
  auto device = make_wrinkled();
  device.electrodes[0].charge = Signal::ramp(1e-3, 0, 1);
  testing::Model model(device, testing::make_sheet_mesh());
  auto& structure = *model.structure;
  structure::LoadHistory history(device);
  structure::Equilibrium problem(structure, history, Networks::relaxed,
                                 nullptr);
  std::vector<double> u(structure.n_free(), 0.);
  time::PathOptions options;
  options.first_step = .01;
  double last = 0;
  const auto keep_voltage = [&](const double time, const double* x)
  {
    last =
        structure
            .resolve_voltages(history.at(time), x, nullptr, Networks::relaxed)
            .voltages[0] /
        get_unit(device);
  };
  history.enter_interval(0);
  try
  {
    time::follow_path(problem, 0, 1, u.data(), options, keep_voltage);
    FAIL() << "a charge without a voltage was accepted";
  }
  catch (const SolverFailed& failure)
  {
    EXPECT_NE(std::string(failure.what()).find(device.electrodes[0].name),
              std::string::npos);
  }
  // A wrinkled neo-Hookean film has a natural width while Et l < 1.
  EXPECT_GT(last, .49);
  EXPECT_LT(last, .5);
}

TEST(Charge, ProbesShowVoltageAndCurrent)
{
  auto device = make_square(material::NeoHookean{1});
  device.electrodes[0].charge = Signal::ramp(.075 / get_unit(device), 0, 1);
  using Kind = structure::Probe::Kind;
  for (const Kind kind : {Kind::voltage, Kind::charge, Kind::capacitance,
                          Kind::current, Kind::mean_stretch})
  {
    structure::Probe probe;
    probe.name = "probe";
    probe.kind = kind;
    probe.of = kind == Kind::mean_stretch ? "film" : device.electrodes[0].name;
    device.probes.push_back(probe);
  }
  testing::Model model(device, testing::make_sheet_mesh());
  structure::QuasiStaticSystem system(*model.structure, {});
  const auto state =
      system.make_initial_state(1, structure::Start::unrelaxed, true, {});
  structure::Probes probes(system);
  const auto values = probes.evaluate(1, state.data());
  const double charge = .075 / get_unit(device), l = values[4];
  EXPECT_NEAR(values[1], charge, 1e-12 * charge);
  EXPECT_NEAR(values[0] * values[2], charge, 1e-12 * charge);
  EXPECT_NEAR(values[2] * get_unit(device) * get_unit(device), std::pow(l, 4),
              1e-8);
  EXPECT_NEAR(values[3], charge, 1e-12 * charge);
  device.electrodes[0].control = Control::voltage;
  testing::Model held(device, testing::make_sheet_mesh());
  structure::QuasiStaticSystem other(*held.structure, {});
  EXPECT_THROW(structure::Probes{other}, BadInput);
}
} // namespace
} // namespace taut
