// CPU time of one trajectory of the lumped DEMES over tau = 500 with 1000 rows:
// the goal is 5 ms with an error of angle and inner stretch below 1e-7. The
// counter holds the largest difference of a row from a run at the tolerance
// 1e-13. Then the wall time of a sweep of 800 such trajectories on all cores.

#include <taut/lumped/demes_run.h>
#include <taut/lumped/run_all.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <thread>

using namespace taut;
using namespace taut::lumped;

namespace
{
constexpr double end = 500;
constexpr int rows = 1000;

struct Problem
{
  Demes demes;
  DemesRunOptions options;
};

Problem make_problem(const double pre_stretch, const double relaxation)
{
  Problem problem;
  problem.demes.pre_stretch = pre_stretch;
  problem.demes.relaxation = relaxation;
  problem.options.start = make_flat_start(problem.demes, 0.01);
  problem.options.end_time = end;
  for (int i = 1; i <= rows; ++i)
    problem.options.output_times.push_back(end * i / rows);
  return problem;
}

/// From the straight frame through take-off, overshoot and decay.
Problem make_free(const double pre_stretch, const double relaxation)
{
  return make_problem(pre_stretch, relaxation);
}

/// From rest, driven by 1 kV and 5 kV sin(w tau).
Problem make_driven(const double pre_stretch, const double frequency)
{
  Problem problem = make_problem(pre_stretch, 0.03);
  problem.options.start = make_rest_start(problem.demes);
  problem.demes.drive = make_drive(0.3, 5, 1, 5, frequency);
  return problem;
}

double compute_error(const DemesRun& run, Problem problem)
{
  problem.options.tolerance = 1e-13;
  const auto exact = run_demes(problem.demes, problem.options);
  double error = 0;
  for (std::size_t i = 0; i < run.rows.size(); ++i)
    error = std::max(
        {error, std::abs(run.rows[i].angle - exact.rows[i].angle),
         std::abs(run.rows[i].inner_stretch - exact.rows[i].inner_stretch)});
  return error;
}

void follow(benchmark::State& state, const Problem& problem)
{
  DemesRun run;
  for (auto _ : state)
    benchmark::DoNotOptimize(run = run_demes(problem.demes, problem.options));
  state.counters["error"] = compute_error(run, problem);
  state.counters["steps"] = double(run.statistics.steps);
}

/// 20 pre-stretches by 40 frequencies.
void sweep(benchmark::State& state)
{
  constexpr std::size_t n_frequencies = 40, n = 20 * n_frequencies;
  std::vector<double> peaks(n);
  const auto compute = [&](const std::size_t i)
  {
    const double pre_stretch = 2 + 0.15 * double(i / n_frequencies);
    const double frequency = 0.1 * double(1 + i % n_frequencies);
    const auto problem = make_driven(pre_stretch, frequency);
    for (const auto& row : run_demes(problem.demes, problem.options).rows)
      peaks[i] = std::max(peaks[i], row.angle);
  };
  for (auto _ : state)
    run_all(n, compute);
  state.counters["threads"] = double(std::thread::hardware_concurrency());
  state.counters["per_trajectory"] = benchmark::Counter(
      double(n), benchmark::Counter::kIsIterationInvariantRate |
                     benchmark::Counter::kInvert);
}
} // namespace

BENCHMARK_CAPTURE(follow, free_lp2, make_free(2, 0.03))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(follow, free_lp3, make_free(3, 0.03))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(follow, free_lp5, make_free(5, 0.03))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(follow, free_lp3_fast_dashpot, make_free(3, 0.0039))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(follow, driven_lp3_w1, make_driven(3, 1))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(follow, driven_lp5_w4, make_driven(5, 4))
    ->Unit(benchmark::kMillisecond);
BENCHMARK(sweep)->Unit(benchmark::kMillisecond)->UseRealTime();
