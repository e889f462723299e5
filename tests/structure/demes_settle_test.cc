// A film stretched to four times its length in a flat frame: let go, it swings,
// goes slack on the way, and settles in the shape that statics find, whichever
// way they go.
#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include "structure/demes.h"
#include "structure/paths.h"

namespace taut::testing
{
namespace
{
/// Damped so strongly that it settles within 3 s.
Demes make_demes()
{
  Demes demes;
  demes.pre_stretch = 4;
  demes.n_cells = 4;
  // Glued on the face of the legs: the eccentricity starts the motion.
  demes.offset = 2.5e-4;
  return demes;
}

structure::Device make_device(const Demes& demes)
{
  auto device = make_demes_device(demes);
  device.films[0].material.networks[0].relaxation_time = 7e-3;
  device.frames[0].stiffness_damping = 5e-3;
  device.environment.air_drag = 1e5;
  return device;
}

struct Settled
{
  DemesShape shape;
  double highest; ///< slope on the way (rad)
  double rejected_share;
};

Settled let_go(const Demes& demes)
{
  Model model(make_device(demes), make_demes_mesh(demes));
  structure::InertialSystem system(*model.structure);
  auto state =
      system.make_initial_state(0, structure::Start::relaxed, false, {});
  const auto measure = [&](const double time, const double* y)
  { return measure_demes(system.structure(), system.history().at(time), y); };
  Settled settled{};
  time::Observer observer;
  observer.step = [&](const time::Step& step, const auto&)
  {
    settled.highest =
        std::max(settled.highest, measure(step.end(), step.state()).slope);
  };
  time::Schedule schedule;
  schedule.end = 3;
  time::IntegratorOptions options;
  options.position_tolerance = 1e-6;
  options.weight_of_rates = 1;
  const auto statistics =
      time::integrate(system, state.data(), schedule, options, {}, observer)
          .statistics;
  const double rejected =
      statistics.rejected_by_error + statistics.rejected_by_newton;
  settled.shape = measure(schedule.end, state.data());
  settled.rejected_share = rejected / (rejected + statistics.steps);
  return settled;
}

DemesShape find_rest(const Demes& demes)
{
  Model model(make_device(demes), make_demes_mesh(demes));
  auto& structure = *model.structure;
  structure::LoadHistory history(structure.device());
  history.enter_interval(0);
  std::vector<double> u(structure.n_free(), 0.);
  const auto rest = structure::find_rest_shape(structure, history,
                                               structure::Networks::relaxed,
                                               nullptr, 0, {}, u.data());
  EXPECT_EQ(rest.negative_eigenvalues, 0);
  return measure_demes(structure, history.at(0), u.data());
}

/// The frame gives way while the film is stretched in it.
DemesShape stretch_from_flat(const Demes& demes)
{
  auto device = make_device(demes);
  device.films[0].pre_stretch_share = make_slope(1);
  Model model(device, make_demes_mesh(demes));
  Path path(*model.structure);
  path.options.takes_stable_branch = true;
  // Without any tension the film would not keep its place.
  const auto statistics = path.follow(.01, 1);
  EXPECT_EQ(statistics.end, time::CurveEnd::reached);
  EXPECT_EQ(path.points.back().negative_eigenvalues, 0);
  return measure_demes(*model.structure, path.get_loads(1), path.u.data());
}

TEST(Demes, SettlesWhereStaticsFindIt)
{
  const Demes demes = make_demes();
  const Settled settled = let_go(demes);
  const DemesShape rest = find_rest(demes);
  // Motion has died out but for the tolerance of the integrator.
  EXPECT_NEAR(settled.shape.slope, rest.slope, 1e-5 * rest.slope);
  EXPECT_NEAR(settled.shape.chord, rest.chord, 1e-5 * rest.chord);
  // Both are equilibria to a relative residual of 1e-10 and less.
  const DemesShape continued = stretch_from_flat(demes);
  EXPECT_NEAR(continued.slope, rest.slope, 1e-7 * rest.slope);
  EXPECT_NEAR(continued.chord, rest.chord, 1e-7 * rest.chord);
  // It did swing, and the integrator met its slack without losing its way.
  EXPECT_GT(settled.highest, 1.2 * rest.slope);
  EXPECT_LT(settled.rejected_share, .1);
}
} // namespace
} // namespace taut::testing
