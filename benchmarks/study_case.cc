// What one short lumped case of a study costs apart from its process: making
// the case from the text of its file, with and without the effective
// parameters, and running it in memory. The rate of the whole program is
// measured by study_rate.py.

#include <taut/io/parameters.h>
#include <taut/io/run_results.h>
#include <taut/study/run_demes.h>

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

using namespace taut;

namespace
{
const char* const short_case = R"(set Model = demes
subsection Lumped DEMES
  set Film length = 0.02
  set Film width = 0.04
  set Film thickness = 5e-4
  set Shear modulus = 52246.6
  set Viscosity = 49.9
  set Frame modulus = 2e9
  set Frame width = 0.010032
  set Frame thickness = 5e-4
  set Inertia = 2.117476e-5
  set Source = 5000
end
subsection Procedure
  set End time = 0.5
end
subsection Output
  set History intervals = 50
end
)";

const std::vector<std::string> overrides = {"Lumped DEMES/Pre-stretch = 2.5"};

void make_case(benchmark::State& state)
{
  const auto text = io::CaseText::parse(short_case, "short.prm");
  for (auto _ : state)
    benchmark::DoNotOptimize(
        io::make_case_file(text, overrides, state.range(0) != 0));
}

void run_case(benchmark::State& state)
{
  const auto text = io::CaseText::parse(short_case, "short.prm");
  const auto case_file = io::make_case_file(text, overrides, false);
  for (auto _ : state)
  {
    io::RecordedRun run;
    io::RecordingOutput output(run);
    study::run_demes(case_file.content, output);
    benchmark::DoNotOptimize(run);
  }
}
} // namespace

BENCHMARK(make_case)
    ->ArgName("effective_parameters")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(run_case)->Unit(benchmark::kMicrosecond);
