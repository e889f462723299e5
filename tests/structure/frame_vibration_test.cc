#include <gtest/gtest.h>

#include <cmath>

#include "structure/frame_motion.h"
#include <boost/math/constants/constants.hpp>

// Free vibrations of a slender cantilever, EI = rho A = L = 1, and damping.
namespace taut::testing
{
namespace
{
constexpr double pi = boost::math::constants::pi<double>();
/// First root of cos b cosh b = -1; omega = b^2.
constexpr double root = 1.8751040687;

/// The first mode of a cantilever at x.
double compute_mode(const double x)
{
  const double ratio =
      (std::cosh(root) + std::cos(root)) / (std::sinh(root) + std::sin(root));
  return std::cosh(root * x) - std::cos(root * x) -
         ratio * (std::sinh(root * x) - std::sin(root * x));
}

/// A cantilever bent by a tip load that goes by t = .6: in a third of the first
/// period, softly, to leave the higher modes alone.
class Cantilever
{
public:
  Cantilever(const double mass_damping, const double stiffness_damping)
      : model_(make_device(mass_damping, stiffness_damping), make_mesh()),
        system_(*model_.structure)
  {
  }

  struct Crossing
  {
    double time, deflection;
  };

  /// Times at which the part of the first mode is largest, from one period to
  /// the next, with that part.
  std::vector<Crossing> run(const unsigned int n_periods)
  {
    auto state =
        system_.make_initial_state(0, structure::Start::unrelaxed, true, {});
    const double start = compute_balance(system_, 0, state.data());
    time::Schedule schedule;
    schedule.end = n_periods * 2 * pi / (root * root);
    const time::Watch watch{"velocity",
                            [&](const double time, const double* y)
                            { return project(time, y, true); },
                            false};
    std::vector<Crossing> crossings;
    time::Observer observer;
    observer.event = [&](const time::Event& event, const double* y)
    {
      if (event.time > .6)
        crossings.push_back({event.time, project(event.time, y, false)});
    };
    observer.step = [&](const time::Step& step, const auto&)
    {
      drift_ = std::max(
          drift_,
          std::abs(compute_balance(system_, step.end(), step.state()) - start));
      // After the release nothing works.
      if (step.start() >= .6 && first_energy_ == 0)
        first_energy_ =
            system_.compute_energies(step.start(), step.state()).total();
      last_energy_ = system_.compute_energies(step.end(), step.state()).total();
    };
    integrate(system_, state.data(), schedule, make_motion_options(2e-10),
              {watch}, observer);
    return crossings;
  }
  /// Of the balance over the energy after the release.
  double relative_drift() const
  {
    return drift_ / first_energy_;
  }
  double remaining_energy() const
  {
    return last_energy_ / first_energy_;
  }

private:
  static constexpr unsigned int n = 16;

  static structure::Device make_device(const double mass_damping,
                                       const double stiffness_damping)
  {
    structure::Device device;
    auto section = make_stiffnesses(1e6, 1e6, 1, 1, 1);
    section.mass_per_length = 1;
    section.rotary_inertia = {{2e-6, 1e-6, 1e-6}};
    device.frames = {make_frame("beam", section)};
    device.frames[0].mass_damping = mass_damping;
    device.frames[0].stiffness_damping = stiffness_damping;
    device.supports = {make_clamp("root")};
    device.point_loads = {make_point_load("tip", {0, 0, 1})};
    // Displacements of 1e-3: the square does not matter.
    device.point_loads[0].force =
        Signal::expression("t < .6 ? 1.5e-3*(1 + cos(pi*t/.6)) : 0", {.6});
    return device;
  }
  static fe::MeshData make_mesh()
  {
    auto mesh = make_line_mesh();
    const auto ends =
        add_line(mesh, "beam", n, make_straight({0, 0, 0}, {1, 0, 0}));
    name_point(mesh, ends[0], "root");
    name_point(mesh, ends[1], "tip");
    fe::add_empty_surface(mesh);
    return mesh;
  }
  /// The integral of mode times deflection (or its velocity) by Simpson's rule
  /// over the nodes, which the other modes do not reach.
  double project(const double time, const double* y, const bool rate)
  {
    auto& structure = *model_.structure;
    const auto loads = system_.history().at(time);
    fe::NodalVector values = structure.compute_positions(loads, y);
    if (rate)
      values = structure.compute_velocities(loads, system_.velocities(y));
    double sum = 0;
    for (const auto& element : structure.frames().elements())
      for (unsigned int a = 0; a < 3; ++a)
      {
        const auto node = element.positions[a];
        sum += (a < 2 ? 1 : 4) / (6. * n) *
               compute_mode(structure.nodes().mesh_position[node][0]) *
               fe::entry(values, 3 * node + 2);
      }
    return sum;
  }

  Model model_;
  structure::InertialSystem system_;
  double drift_ = 0, first_energy_ = 0, last_energy_ = 0;
};

TEST(FrameVibration, CantileverHasItsFirstFrequency)
{
  Cantilever beam(0, 0);
  const auto crossings = beam.run(6);
  ASSERT_GE(crossings.size(), 4u);
  const double period =
      (crossings.back().time - crossings.front().time) / (crossings.size() - 1);
  // Shear and rotary inertia lower it by 1e-5.
  EXPECT_NEAR(2 * pi / period / (root * root), 1, 1e-4);
  EXPECT_NEAR(crossings.back().deflection / crossings.front().deflection, 1,
              1e-3);
  EXPECT_LT(beam.relative_drift(), 1e-4);
}

class DampedVibration
    : public ::testing::TestWithParam<std::pair<double, double>>
{
};

TEST_P(DampedVibration, DecaysAsRayleighDampingSays)
{
  const auto [mass_damping, stiffness_damping] = GetParam();
  Cantilever beam(mass_damping, stiffness_damping);
  const auto crossings = beam.run(6);
  ASSERT_GE(crossings.size(), 4u);
  const double omega = root * root;
  const double zeta = .5 * (mass_damping / omega + stiffness_damping * omega);
  const double decrement =
      std::log(crossings.front().deflection / crossings.back().deflection) /
      (crossings.size() - 1);
  EXPECT_NEAR(decrement * std::sqrt(1 - zeta * zeta) / (2 * pi), zeta,
              1e-3 * zeta);
  EXPECT_LT(beam.remaining_energy(), .5);
  // Without dampers for strains the integrator's own damping of the highest
  // modes shows.
  EXPECT_LT(beam.relative_drift(), stiffness_damping > 0 ? 1e-5 : 1e-4);
}

INSTANTIATE_TEST_SUITE_P(mass_and_stiffness, DampedVibration,
                         ::testing::Values(std::pair(.2, 0.),
                                           std::pair(0., .02),
                                           std::pair(.1, .01)));
} // namespace
} // namespace taut::testing
