// Factorisations of a minimum-energy structure: from flat to its rest shape,
// and 20 periods after a step of the voltage. Counts, not times, are what is to
// be kept: below 60 at 5,000 cells, below 400.
#include "structure/demes.h"

#include <taut/time/integrate.h>

#include <benchmark/benchmark.h>

namespace taut
{
namespace
{
using testing::Demes;

structure::RestShape find_rest(structure::Structure& structure,
                               structure::LoadHistory& history, double* u)
{
  return structure::find_rest_shape(
      structure, history, structure::Networks::relaxed, nullptr, 0, {}, u);
}

void rest_shape(benchmark::State& state)
{
  Demes demes;
  demes.n_cells = state.range(0);
  testing::Model model(testing::make_demes_device(demes),
                       testing::make_demes_mesh(demes));
  auto& structure = *model.structure;
  for (auto _ : state)
  {
    structure::LoadHistory history(structure.device());
    history.enter_interval(0);
    std::vector<double> u(structure.n_free(), 0.);
    const auto shape = find_rest(structure, history, u.data());
    state.counters["factorisations"] = shape.statistics.factorisations;
  }
  state.counters["cells"] = demes.n_cells * demes.n_cells;
}
BENCHMARK(rest_shape)
    ->Arg(10)
    ->Arg(20)
    ->Arg(70)
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

void motion(benchmark::State& state)
{
  Demes demes;
  demes.n_cells = 10;
  auto device = testing::make_demes_device(demes);
  device.electrodes[0].voltage = Signal::steps({0, 1e-3}, {0, 5000});
  testing::Model model(device, testing::make_demes_mesh(demes));
  for (auto _ : state)
  {
    structure::InertialSystem system(*model.structure);
    auto y = system.make_initial_state(
        0, structure::Start::relaxed,
        [&](const structure::Networks, const double*, double* u)
        { find_rest(*model.structure, system.history(), u); });
    time::Schedule schedule;
    schedule.end = 4.5;
    time::IntegratorOptions options;
    options.position_tolerance = 1e-8;
    const auto run =
        time::integrate(system, y.data(), schedule, options, {}, {});
    state.counters["steps"] = run.statistics.steps;
    state.counters["factorisations"] = run.statistics.factorisations;
  }
}
BENCHMARK(motion)->Iterations(1)->Unit(benchmark::kSecond);
} // namespace
} // namespace taut
