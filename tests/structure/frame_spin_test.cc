#include <gtest/gtest.h>

#include <cmath>

#include "structure/frame_motion.h"
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/ellint_1.hpp>

// Large rotations in time: a free rigid body and a beam on a pivot.
namespace taut::testing
{
namespace
{
const std::array<double, 3> inertia{{1, 2, 3}};

/// A rigid body with three moments of inertia around a stub of a beam, free.
structure::Device make_body_device()
{
  structure::Device device;
  device.frames = {make_frame("stub", make_stiffnesses(1, 1, 1, 1, 1))};
  structure::RigidBody body;
  body.name = "body";
  body.groups = {"stub"};
  body.mass = 1;
  body.rotary_inertia = inertia;
  device.bodies = {body};
  return device;
}

fe::MeshData make_stub()
{
  auto mesh = make_line_mesh();
  add_line(mesh, "stub", 1, make_straight({-.5, 0, 0}, {.5, 0, 0}));
  fe::add_empty_surface(mesh);
  return mesh;
}

/// Of the motion without torque, started near the middle axis with
/// `omega`: Jacobi's elliptic functions.
double compute_period(const Vector3& omega)
{
  const auto& [a, b, c] = inertia;
  double energy = 0, momentum = 0; // twice the energy, the momentum squared
  for (unsigned int i = 0; i < 3; ++i)
  {
    energy += inertia[i] * omega[i] * omega[i];
    momentum += std::pow(inertia[i] * omega[i], 2);
  }
  // About the axis of the largest inertia if momentum > b energy, else the
  // smallest one.
  const double high = momentum - a * energy, low = c * energy - momentum;
  const bool largest = momentum > b * energy;
  const double square = largest ? (b - a) * low / ((c - b) * high)
                                : (c - b) * high / ((b - a) * low);
  const double rate =
      std::sqrt((largest ? (c - b) * high : (b - a) * low) / (a * b * c));
  return 4 * boost::math::ellint_1(std::sqrt(square)) / rate;
}

TEST(FreeRigidBody, FlipsAroundTheMiddleAxisAndKeepsItsMomentum)
{
  const Vector3 omega{.01, 5, 0};
  const double period = compute_period(omega);
  Model model(make_body_device(), make_stub());
  structure::InertialSystem system(*model.structure);
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, false, {});
  set_spin(*model.structure, omega, state);
  const auto& rotation =
      model.structure->nodes()
          .rotations[model.structure->device_nodes().frames.bodies[0].rotation];
  const auto get_omega = [&](const double time, const double* y)
  {
    const auto turning = get_turning(system, time, y, rotation);
    return compute_angular_velocity(turning.q, turning.rate);
  };
  const double energy = .5 * (inertia[0] * 1e-4 + inertia[1] * 25);
  EXPECT_NEAR(system.compute_energies(0, state.data()).kinetic, energy,
              1e-12 * energy);
  double drift = 0, momentum_drift = 0, least = 0;
  time::Observer observer;
  observer.step = [&](const time::Step& step, const auto&)
  {
    const double* y = step.state();
    const Vector3 now = get_omega(step.end(), y);
    const auto turning = get_turning(system, step.end(), y, rotation);
    const Vector3 momentum =
        rotate(turning.q,
               {inertia[0] * now[0], inertia[1] * now[1], inertia[2] * now[2]});
    for (unsigned int c = 0; c < 3; ++c)
      momentum_drift = std::max(momentum_drift,
                                std::abs(momentum[c] - inertia[c] * omega[c]));
    drift = std::max(
        drift,
        std::abs(system.compute_energies(step.end(), y).kinetic - energy));
    least = std::min(least, now[1]);
  };
  // Two flips per period.
  time::Schedule schedule;
  schedule.end = 2 * period;
  integrate(system, state.data(), schedule, make_motion_options(3e-7), {},
            observer);
  EXPECT_NEAR(least, -omega[1], .01 * omega[1]);
  EXPECT_LT(drift, 1e-5 * energy);
  EXPECT_LT(momentum_drift, 1e-5 * inertia[1] * omega[1]);
  const Vector3 last = get_omega(schedule.end, state.data());
  // Errors grow by the ratio of 5 to .01 at every flip.
  for (unsigned int c = 0; c < 3; ++c)
    EXPECT_NEAR(last[c], omega[c], 1e-2 * omega[1]) << c;
}

/// A flexible beam on a pivot that a constant moment spins up from rest.
TEST(SpinningBeam, TurnsMoreThanTwiceAndTakesInTheWorkOfItsMoment)
{
  constexpr double moment = .5, end = 4.5;
  structure::Device device;
  auto section = make_stiffnesses(1e4, 1e4, 100, 100, 100);
  section.mass_per_length = 1;
  section.rotary_inertia = {{2e-3, 1e-3, 1e-3}};
  device.frames = {make_frame("beam", section)};
  device.supports = {make_clamp("root")};
  device.supports[0].held_rotations = {{true, true, false}};
  auto load = make_point_load("root", {0, 0, 0});
  load.moment_direction = {{0, 0, 1}};
  load.moment = Signal::constant(moment);
  device.point_loads = {load};
  auto mesh = make_line_mesh();
  const auto ends =
      add_line(mesh, "beam", 4, make_straight({0, 0, 0}, {1, 0, 0}));
  name_point(mesh, ends[0], "root");
  name_point(mesh, ends[1], "tip");
  fe::add_empty_surface(mesh);
  Model model(device, mesh);
  structure::InertialSystem system(*model.structure);
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, false, {});
  double angle = 0, drift = 0;
  Quaternion last{1, 0, 0, 0};
  time::Observer observer;
  observer.step = [&](const time::Step& step, const auto&)
  {
    const Quaternion q =
        get_frame_rotation(*model.structure, system.history().at(step.end()),
                           step.state(), "root");
    angle += compute_angle(multiply(conjugate(last), q), {0, 0, 1});
    last = q;
    drift = std::max(
        drift, std::abs(compute_balance(system, step.end(), step.state())));
  };
  time::Schedule schedule;
  schedule.end = end;
  integrate(system, state.data(), schedule, make_motion_options(1e-6), {},
            observer);
  // A rigid bar turns by m t^2/(2 J), J = 1/3 + 1e-3; the beam swings around
  // that by its flexibility.
  EXPECT_GT(angle, 4 * boost::math::constants::pi<double>());
  EXPECT_NEAR(angle, .5 * moment * end * end / (1. / 3 + 1e-3), .1);
  const double energy = system.compute_energies(end, state.data()).total();
  EXPECT_NEAR(energy, moment * angle, 1e-4 * energy);
  EXPECT_LT(drift, 1e-4 * energy);
}
} // namespace
} // namespace taut::testing
