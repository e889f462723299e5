// Viscous films under prescribed stretch in a mesh, without inertia.
#include <gtest/gtest.h>

#include <cmath>

#include "structure/viscous_films.h"
#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace taut
{
namespace
{
/// Nominal stress along x on the east edge, and 1/sqrt(A_xx) of the first
/// point.
struct Reading
{
  double stress, inelastic;
};

std::vector<Reading> run(structure::Structure& structure,
                         const std::vector<double>& times,
                         const double tolerance)
{
  structure::QuasiStaticSystem system(structure, {});
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  std::vector<Reading> readings;
  time::Observer observer;
  observer.output = [&](const double time, const double* y)
  {
    std::vector<double> f(state.size());
    system.evaluate(time, y, f.data());
    readings.push_back({structure.compute_reaction(3)[0],
                        1 / std::sqrt(system.internal(y)[0])});
  };
  time::Schedule schedule;
  schedule.end = times.back();
  schedule.output_times = times;
  integrate(system, state.data(), schedule,
            testing::make_slow_options(tolerance), {}, observer);
  return readings;
}

TEST(StepRelaxation, UniaxialFollowsTheReference)
{
  // One branch G = tau = 1 beside a spring whose stress is known, stretched to
  // 2 at once: the film is mounted so. t, l_i, nominal branch stress.
  constexpr double ground = .5;
  auto device = testing::make_sheet(
      {{material::NeoHookean{ground}}, {{material::NeoHookean{1}, 1}}, {}, 1},
      {testing::make_support("east", {{true, false, false}})});
  device.films[0].pre_stretch = {{2, 1 / std::sqrt(2.)}};
  testing::Model model(device, testing::make_sheet_mesh());
  const auto readings = run(*model.structure, {0, .1, 1, 5}, 1e-9);
  const double inelastic[] = {1, 1.1078746401, 1.6514959692, 1.9936532174};
  const double stress[] = {1.75, 1.3525102852, .3204146520, .0047752567};
  ASSERT_EQ(readings.size(), 4u);
  for (unsigned int i = 0; i < 4; ++i)
  {
    // Local errors of 1e-9 add up over some hundred steps.
    EXPECT_NEAR(readings[i].inelastic, inelastic[i], 2e-7);
    // The edge is 1/sqrt(2) as wide as the film was.
    EXPECT_NEAR(readings[i].stress / std::sqrt(2.), ground * 1.75 + stress[i],
                2e-7);
  }
}

TEST(StepRelaxation, OfANetworkThatStressActivates)
{
  // The same with T = exp(-tau/sigma_0): the elastic square e of the branch,
  // tau = e - e^(-1/2), follows d(ln e)/dt = -(2/3) tau exp(tau/sigma_0).
  constexpr double ground = .5, activation = .9;
  auto device = testing::make_sheet(
      {{material::NeoHookean{ground}},
       {{material::NeoHookean{1}, 1, material::FlowLaw::isotropic,
         material::StressActivatedRelaxation{activation}}},
       {},
       1},
      {testing::make_support("east", {{true, false, false}})});
  device.films[0].pre_stretch = {{2, 1 / std::sqrt(2.)}};
  const auto get_stress = [](const double e) { return e - 1 / std::sqrt(e); };
  const auto find_time = [&](const double end)
  {
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
        [&](const double e) {
          return 1.5 / (e * get_stress(e)) *
                 std::exp(-get_stress(e) / activation);
        },
        end, 4., 15, 1e-12);
  };
  const double squares[] = {4, 3.5, 2, 1.1};
  testing::Model model(device, testing::make_sheet_mesh());
  const auto readings = run(
      *model.structure,
      {0, find_time(squares[1]), find_time(squares[2]), find_time(squares[3])},
      1e-9);
  ASSERT_EQ(readings.size(), 4u);
  for (unsigned int i = 0; i < 4; ++i)
  {
    // The law rounds tau by 1e-4 sigma_0, which changes times, where it is
    // large, by as much.
    EXPECT_NEAR(readings[i].inelastic, 2 / std::sqrt(squares[i]), 1e-4);
    EXPECT_NEAR(readings[i].stress / std::sqrt(2.),
                ground * 1.75 + get_stress(squares[i]) / 2, 1e-4);
  }
}

TEST(LongTime, EndsInTheRelaxedEquilibrium)
{
  // Clamped at both ends, so that every point has its own history.
  structure::Device device;
  device.films = {
      testing::make_film(material::Gent{2e4, 60}, 1e-3, {{1.5, 2}})};
  device.films[0].material.networks = {{material::Gent{1e4, 60}, .01},
                                       {material::NeoHookean{5e3}, .1}};
  device.supports = {testing::make_support("west", {{true, true, true}}),
                     testing::make_support("east", {{true, true, true}},
                                           {{".01", ".004", "0"}},
                                           Signal::table({0, .1}, {0, 1}))};
  testing::Model model(device, testing::make_rectangle(4, 3, 2, .05, .04));
  auto& structure = *model.structure;
  structure::QuasiStaticSystem system(structure, {});
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  time::Schedule schedule;
  schedule.end = 5;
  auto options = testing::make_slow_options(1e-9);
  options.internal_tolerance = 1e-7;
  integrate(system, state.data(), schedule, options, {}, {});

  testing::Statics statics(structure, structure::Networks::relaxed);
  statics.u.assign(state.begin(), state.begin() + structure.n_free());
  statics.set_amplitude(1, 1);
  statics.find(1e-12);
  for (std::size_t i = 0; i < statics.u.size(); ++i)
    EXPECT_NEAR(state[i], statics.u[i], 1e-8);
  // Networks at rest: A = C^-1.
  std::vector<double> relaxed(structure.n_internal());
  fe::set_relaxed(
      structure.cells(),
      structure.make_laws(statics.get_loads(), structure::Networks::relaxed),
      structure.compute_positions(statics.get_loads(), statics.u.data()),
      relaxed.data());
  const double* A = system.internal(state.data());
  for (std::size_t i = 0; i < relaxed.size(); ++i)
    EXPECT_NEAR(A[i], relaxed[i], 1e-6);
}

TEST(Vhb4910, LoadAndUnloadInAMesh)
{
  // Arruda-Boyce ground with the exact inverse Langevin function; rate .01 /s,
  // reversal at the stretch 2.5; nominal stress in Pa.
  const Signal stretching = Signal::table({0, 150, 300}, {0, 1.5, 0});
  const auto device = testing::make_sheet(
      {{material::ArrudaBoyce{15.36e3, 5.99}},
       {{material::NeoHookean{26.06e3}, .6074},
        {material::NeoHookean{26.53e3}, 6.56},
        {material::NeoHookean{10.83e3}, 61.25}},
       {material::ConstantPermittivity{4.8}},
       960},
      {testing::make_support("east", {{true, false, false}}, {{"1", "0", "0"}},
                             stretching)});
  testing::Model model(device, testing::make_rectangle(1, 1, 2, 1, 1));
  const auto readings = run(*model.structure, {56.25, 150, 243.75, 250}, 1e-8);
  const double stress[] = {27.016852e3, 42.121060e3, 11.890059e3};
  // The output starts with the time 0.
  ASSERT_GE(readings.size(), 3u);
  const std::size_t first = readings.size() - 4;
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(readings[first + i].stress, stress[i], 1e-5 * stress[i]);
}
} // namespace
} // namespace taut
