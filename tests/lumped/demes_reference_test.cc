#include <taut/lumped/demes_run.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "demes_reference_driven.h"
#include "demes_reference_free.h"
#include "demes_reference_heated.h"

using namespace taut;
using namespace taut::lumped;
using demes_reference::Row;
using demes_reference::Trajectory;

namespace
{
// What a local tolerance of 1e-13 leaves of these runs (1e-12 leaves ten times
// as much); the film's force multiplies the error of the stretches by its
// stiffness, which is above 100 where the film is short.
constexpr double integration_error = 1e-12;
constexpr double force_error = 5e-12;

// The unstable straight state magnifies errors e-fold in 1 / sigma while an
// orbit lingers near it. Only the undamped orbit comes back there (it never
// loses the energy of its start); its rows end before |theta| falls below 0.1
// again, at tau = 7.1. The driven orbit through theta = 0 does so while the
// voltage holds the straight state stable.
DemesRunOptions make_options(const Trajectory& trajectory)
{
  DemesRunOptions options;
  options.start = trajectory.start;
  for (const Row& row : trajectory.rows)
    options.output_times.push_back(row[0]);
  options.end_time = trajectory.rows.back()[0];
  return options;
}

Row flatten(const DemesRow& row)
{
  return {row.time,           row.angle,
          row.velocity,       row.inner_stretch,
          row.stretch,        row.drive * row.drive,
          row.membrane_force, row.kinetic_energy + row.free_energy};
}

std::vector<Trajectory> get_all()
{
  auto all = demes_reference::get_free_trajectories();
  for (const auto& more : {demes_reference::get_driven_trajectories(),
                           demes_reference::get_heated_trajectories()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}
} // namespace

class DemesReference : public testing::TestWithParam<Trajectory>
{
};

TEST_P(DemesReference, TrajectoryIsReproduced)
{
  const auto& trajectory = GetParam();
  auto options = make_options(trajectory);
  options.tolerance = 1e-13;
  const auto run = run_demes(demes_reference::make_demes(trajectory), options);
  // The first row is the start.
  ASSERT_EQ(run.rows.size(), trajectory.rows.size() + 1);
  for (std::size_t i = 0; i < trajectory.rows.size(); ++i)
  {
    const Row row = flatten(run.rows[i + 1]), &expected = trajectory.rows[i];
    for (std::size_t j = 0; j < row.size(); ++j)
      EXPECT_NEAR(
          row[j], expected[j],
          (trajectory.error + (j == 6 ? force_error : integration_error)) *
              std::max(1., std::abs(expected[j])))
          << "column " << j << " at tau = " << expected[0];
  }
}

TEST_P(DemesReference, DefaultToleranceLeavesLessThanOneInTenMillion)
{
  const auto& trajectory = GetParam();
  const auto run = run_demes(demes_reference::make_demes(trajectory),
                             make_options(trajectory));
  for (std::size_t i = 0; i < trajectory.rows.size(); ++i)
    for (const std::size_t j : {1, 2, 3, 4})
      EXPECT_NEAR(flatten(run.rows[i + 1])[j], trajectory.rows[i][j], 1e-7)
          << "column " << j << " at tau = " << trajectory.rows[i][0];
}

INSTANTIATE_TEST_SUITE_P(All, DemesReference, testing::ValuesIn(get_all()),
                         [](const testing::TestParamInfo<Trajectory>& info)
                         {
                           std::string name = info.param.name;
                           std::replace_if(
                               name.begin(), name.end(),
                               [](const char c) { return !isalnum(c); }, '_');
                           return name;
                         });
