// A neo-Hookean balloon under pressure and voltage, one eighth of it in the
// mesh. Modulus, radius, thickness and density are 1, so that time counts in
// R sqrt(rho/mu) and the radius l follows
//   l'' + 2 l - 2 l^-5 - p l^2 - 2 phi^2 l^3 = 0.
#include <taut/structure/vibration.h>
#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/patchwork.h"
#include "structure/statics.h"
#include <boost/numeric/odeint.hpp>

namespace taut
{
namespace
{
constexpr double pressure = .5, field = .2;
constexpr double equilibrium = 1.0641385268, omega = 2.7478691820;

std::unique_ptr<testing::Model> make_balloon(const unsigned int n)
{
  structure::Device device;
  device.films = {testing::make_film(material::NeoHookean{1}, 1, {{1, 1}})};
  device.films[0].axis = {{.3, .5, -.8}};
  // Newton starts where the voltage presses the film that is not yet inflated.
  device.films[0].tension_field = false;
  device.films[0].material.density = 1;
  device.electrodes = {testing::make_electrode(
      "film",
      Signal::constant(testing::make_voltage(device.films[0], field, 1)))};
  device.supports = {testing::make_support("x0", {{true, false, false}}),
                     testing::make_support("y0", {{false, true, false}}),
                     testing::make_support("z0", {{false, false, true}})};
  structure::Pressure inner;
  inner.name = "gas";
  inner.groups = {"film"};
  inner.pressure = Signal::constant(pressure);
  device.pressures = {inner};
  return std::make_unique<testing::Model>(device, testing::make_octant(n));
}

/// Mean and spread of the nodes' distances from the centre.
struct Radius
{
  double mean, spread;
};

Radius compute_radius(structure::Structure& structure, const double* u)
{
  structure::LoadHistory history(structure.device());
  const auto& x = structure.compute_positions(history.at(0), u);
  double sum = 0, smallest = 1e300, largest = 0;
  const auto n = structure.nodes().n_owned;
  for (unsigned int node = 0; node < n; ++node)
  {
    const double radius =
        std::hypot(fe::entry(x, 3 * node), fe::entry(x, 3 * node + 1),
                   fe::entry(x, 3 * node + 2));
    sum += radius;
    smallest = std::min(smallest, radius);
    largest = std::max(largest, radius);
  }
  return {sum / n, largest - smallest};
}

Radius find_static_radius(const unsigned int n)
{
  const auto model = make_balloon(n);
  testing::Statics statics(*model->structure);
  for (const double share : {.5, 1.})
  {
    statics.set_pressure(share * pressure);
    statics.find(1e-12);
  }
  return compute_radius(*model->structure, statics.u.data());
}

TEST(Balloon, static_stretch_converges_to_the_closed_form)
{
  const Radius coarse = find_static_radius(2), fine = find_static_radius(4);
  const double coarse_error = std::abs(coarse.mean - equilibrium);
  const double fine_error = std::abs(fine.mean - equilibrium);
  EXPECT_LT(fine_error, 2e-5);
  EXPECT_LT(fine.spread, 2e-4);
  // At least of the order of Q2 in L2.
  EXPECT_GT(std::log2(coarse_error / fine_error), 2.85);
}

time::IntegratorOptions make_options(const double tolerance)
{
  time::IntegratorOptions options;
  options.position_tolerance = tolerance;
  options.velocity_time = 1;
  options.first_step = 1e-3;
  return options;
}

TEST(Balloon, small_oscillation_has_the_frequency_of_the_closed_form)
{
  const auto model = make_balloon(4);
  auto& structure = *model->structure;
  structure::InertialSystem system(structure);
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  const double rest = compute_radius(structure, state.data()).mean;
  const auto& free = structure.free_unknowns();
  constexpr double kick = 1e-4;
  for (std::size_t i = 0; i < free.size(); ++i)
    state[free.size() + i] =
        kick * structure.nodes().mesh_position[free[i] / 3][free[i] % 3];

  std::vector<double> passages;
  time::Observer observer;
  observer.event = [&](const time::Event& event, const double*)
  { passages.push_back(event.time); };
  const time::Watch watch{"rest position",
                          [&](double, const double* y)
                          { return compute_radius(structure, y).mean - rest; },
                          false};
  time::Schedule schedule;
  schedule.end = 4;
  integrate(system, state.data(), schedule, make_options(1e-9), {watch},
            observer);
  ASSERT_EQ(passages.size(), 2u);
  EXPECT_NEAR(2 * M_PI / (passages[1] - passages[0]), omega, 1e-4 * omega);
}

TEST(Balloon, breathing_is_a_mode)
{
  const auto model = make_balloon(4);
  structure::QuasiStaticSystem system(*model->structure, {});
  const auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  structure::Vibration vibration(*model->structure,
                                 system.loads_at(0, state.data()), state.data(),
                                 system.internal(state.data()));
  // The pressure on the planes of symmetry does no work.
  EXPECT_LT(vibration.asymmetry(), 1e-10);
  time::ModeOptions options;
  options.count = 3;
  options.target = omega * omega;
  double closest = 1;
  for (const auto& mode : time::find_modes(vibration, options).modes)
    closest = std::min(closest, std::abs(std::sqrt(mode.square) / omega - 1));
  EXPECT_LT(closest, 1e-4);
}

/// The radius at `times` after pressure and voltage come on at once.
std::vector<double> integrate_radius(const std::vector<double>& times)
{
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 2>;
  const auto motion = [](const State& y, State& rate, double)
  {
    const double l = y[0];
    rate[0] = y[1];
    rate[1] = -2 * l + 2 * std::pow(l, -5) + pressure * l * l +
              2 * field * field * l * l * l;
  };
  const auto stepper = odeint::make_controlled(
      1e-12, 1e-12, odeint::runge_kutta_dopri5<State>());
  State y{{1, 0}};
  std::vector<double> radii;
  odeint::integrate_times(stepper, motion, y, times.begin(), times.end(), 1e-3,
                          [&](const State& now, double)
                          { radii.push_back(now[0]); });
  return radii;
}

TEST(Balloon, finite_motion_follows_the_exact_equation)
{
  const auto model = make_balloon(3);
  auto& structure = *model->structure;
  structure::InertialSystem system(structure);
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, false, {});
  const std::vector<double> times{0, .5, 1, 1.5, 2, 2.5, 3, 3.5, 4};
  const auto expected = integrate_radius(times);
  time::Schedule schedule;
  schedule.end = times.back();
  schedule.output_times = times;
  std::vector<double> radii;
  time::Observer observer;
  observer.output = [&](double, const double* y)
  { radii.push_back(compute_radius(structure, y).mean); };
  integrate(system, state.data(), schedule, make_options(1e-6), {}, observer);
  ASSERT_EQ(radii.size(), expected.size());
  // The swing is .13; the mesh errs by 1e-4 of the radius.
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(radii[i], expected[i], 2e-4) << "t = " << times[i];
}
} // namespace
} // namespace taut
