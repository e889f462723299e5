// CPU time of one ramp of the lumped resonator to its failure, three networks
// (0.01, 1, 100 s), chi = 0.5, V* = 0.3 t: the goal is 3 ms with an error of
// the failure voltage and stretch below 1e-8. The counters hold these errors
// against an integration by another program (error 1e-12).

#include <taut/lumped/resonator_critical.h>

#include <benchmark/benchmark.h>

#include <cmath>

using namespace taut;
using namespace taut::lumped;

namespace
{
constexpr double failure_voltage = 0.26269346351831;
constexpr double failure_stretch = 3.3756034986885;

void ramp_to_failure(benchmark::State& state)
{
  Resonator resonator;
  resonator.networks = make_networks(0.5, {1, 1, 1}, {0.01, 1, 100});
  ResonatorRamp ramp;
  ramp.rate = 0.3;
  ramp.start = ResonatorStart::unrelaxed;
  ramp.ode.method = static_cast<time::OdeMethod>(state.range(0));
  ramp.ode.relative_tolerance = std::pow(10., -state.range(1));
  ramp.ode.absolute_tolerance = 0.01 * ramp.ode.relative_tolerance;
  ResonatorEvent failure;
  for (auto _ : state)
    benchmark::DoNotOptimize(failure = find_ramp_failure(resonator, ramp));
  state.counters["voltage_error"] =
      std::abs(failure.row.voltage / failure_voltage - 1);
  state.counters["stretch_error"] =
      std::abs(failure.row.stretch_1a / failure_stretch - 1);
}
} // namespace

BENCHMARK(ramp_to_failure)
    ->ArgNames({"method", "digits"})
    ->ArgsProduct({{static_cast<int>(time::OdeMethod::automatic),
                    static_cast<int>(time::OdeMethod::explicit_runge_kutta),
                    static_cast<int>(time::OdeMethod::implicit_bdf)},
                   {8, 10}})
    ->Unit(benchmark::kMillisecond);
