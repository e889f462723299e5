// Equibiaxial creep of a neo-Hookean Zener film under constant voltage, in a
// mesh: tau = 1, total modulus 1, of which the share chi is elastic. Pull-in
// is where the tangent of the balance vanishes.
#include <taut/base/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/viscous_films.h"

namespace taut
{
namespace
{
structure::Device make_zener(const double share, const double field)
{
  auto device = testing::make_sheet({{material::NeoHookean{share}},
                                     {{material::NeoHookean{1 - share}, 1}},
                                     {},
                                     1},
                                    {});
  device.electrodes = {testing::make_electrode(
      "film",
      Signal::constant(testing::make_voltage(device.films[0], field, 1)))};
  return device;
}

/// Equibiaxial stretch and d(nominal stress)/d(stretch) at frozen networks, of
/// the first point.
struct Balance
{
  double stretch, tangent;
};

Balance compute_balance(structure::Structure& structure, const double* internal,
                        const double* u)
{
  structure::LoadHistory history(structure.device());
  const auto loads = history.at(0);
  const auto C = fe::compute_metric(structure.cells(),
                                    structure.compute_positions(loads, u))[0];
  const auto law = structure.make_laws(loads, structure::Networks::as_given)[0];
  const material::SymmetricTensor2<double> A = {internal[0], internal[1],
                                                internal[2]};
  material::SymmetricTensor2<double> S;
  material::Matrix3<double> D;
  material::stress_and_stiffness(
      *law.elastomer, material::SymmetricTensor2<double>{C[0], C[1], C[2]}, &A,
      law.field, material::frozen, S, D);
  return {std::sqrt(C[0]), S.xx + C[0] * (D[0][0] + D[0][1])};
}

struct PullIn
{
  double field, time;
};

class Creep : public ::testing::TestWithParam<PullIn>
{
};

TEST_P(Creep, ends_in_pull_in_at_the_reference_time)
{
  const auto [field, time] = GetParam();
  testing::Model model(make_zener(.5, field), testing::make_sheet_mesh());
  structure::QuasiStaticSystem system(*model.structure, {});
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  // The tangent vanishes as the root of the time that is left: of two
  // thresholds, one half the other, the times tell the end to their cube.
  constexpr double threshold = .02;
  std::vector<time::Watch> watches;
  for (const double share : {1., .5})
    watches.push_back({"tangent",
                       [&, share](double, const double* y)
                       {
                         return compute_balance(*model.structure,
                                                system.internal(y), y)
                                    .tangent -
                                share * threshold;
                       },
                       false});
  std::vector<double> passages;
  time::Observer observer;
  observer.event = [&](const time::Event& event, const double*)
  { passages.push_back(event.time); };
  time::Schedule schedule;
  schedule.end = 1.1 * time;
  double reached = 0;
  EXPECT_THROW(integrate(system, state.data(), schedule,
                         testing::make_slow_options(1e-9), watches, observer,
                         &reached),
               SolverFailed);
  ASSERT_EQ(passages.size(), 2u);
  const double end = passages[1] + (passages[1] - passages[0]) / 3;
  EXPECT_NEAR(end, time, 1e-5 * time);
  // The run itself gets as far.
  EXPECT_NEAR(reached, time, 1e-4 * time);
}

INSTANTIATE_TEST_SUITE_P(fields, Creep,
                         ::testing::Values(PullIn{.5, 16.03808464},
                                           PullIn{.6, 1.48996387},
                                           PullIn{.65, .42371682}));

TEST(Creep, OfAStifferFilmEndsInItsRelaxedState)
{
  testing::Model model(make_zener(.8, .5), testing::make_sheet_mesh());
  auto& structure = *model.structure;
  structure::QuasiStaticSystem system(structure, {});
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, true, {});
  time::Schedule schedule;
  schedule.end = 100;
  integrate(system, state.data(), schedule, testing::make_slow_options(1e-9),
            {}, {});
  const double stretch =
      compute_balance(structure, system.internal(state.data()), state.data())
          .stretch;
  EXPECT_NEAR(stretch, 1.07812829, 1e-7);
  // All points, and the relaxed equilibrium that needs no run.
  testing::Statics statics(structure, structure::Networks::relaxed);
  statics.find(1e-10);
  for (std::size_t i = 0; i < statics.u.size(); ++i)
    EXPECT_NEAR(state[i], statics.u[i], 1e-7);
}
} // namespace
} // namespace taut
