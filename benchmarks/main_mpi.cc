// Entry point of the benchmarks that use PETSc and p4est.
#include <deal.II/base/mpi.h>

#include <benchmark/benchmark.h>

#include <vector>

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // One column per counter; an argument given later wins.
  char tabular[] = "--benchmark_counters_tabular=true";
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + 1, tabular);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
}
