// The phases of a static solve of the square film with Q2 cells, and the share
// that assembly has in the whole. The goals: a share below 30 % at 1e5
// unknowns, 5e5 unknowns in under 3 GB.

#include <taut/structure/systems.h>
#include <taut/time/equilibrium.h>

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <chrono>
#include <ctime>

#include "square_film.h"

using namespace taut;
using namespace taut::benchmarks;

namespace
{
double get_cpu_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double get_peak_gigabytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1048576.;
}

template <typename Function>
double measure(const Function& function)
{
  const double start = get_cpu_seconds();
  function();
  return get_cpu_seconds() - start;
}

void static_solve(benchmark::State& state)
{
  SquareFilm square;
  square.cells_per_side = state.range(0);
  square.networks = false;
  square.limit = 60;
  for (auto _ : state)
  {
    auto& times = state.counters;
    std::unique_ptr<testing::Model> model;
    times["setup"] = measure([&] { model = make_model(square); });
    auto& structure = *model->structure;
    structure::LoadHistory history(structure.device());
    structure::Equilibrium problem(structure, history,
                                   structure::Networks::relaxed, nullptr);
    const std::size_t n = structure.n_free();
    std::vector<double> u(n), residual(n), internal(structure.n_internal());

    // What Structure::factorise does, one phase after the other.
    const auto loads = history.at(0);
    fe::TangentRequest request;
    request.positions = &structure.compute_positions(loads, u.data());
    request.internal = internal.data();
    const auto laws = structure.make_laws(loads, structure::Networks::relaxed);
    {
      std::unique_ptr<fe::TangentMatrix> matrix;
      times["pattern"] = measure(
          [&]
          {
            matrix = std::make_unique<fe::TangentMatrix>(
                structure.nodes(), structure.cells(),
                std::vector<std::vector<fe::LocalNode>>{},
                fe::TangentMatrix::Coupling::full);
          });
      const auto assemble = [&]
      {
        matrix->begin();
        fe::add_stiffness(structure.cells(), laws, {}, request, *matrix);
        matrix->end();
      };
      assemble();
      fe::LinearSolver solver(matrix->get(), fe::LinearSolver::Kind::symmetric);
      times["analyse"] = measure([&] { solver.factorise(); });
      times["tangent"] = measure(assemble);
      times["factorise"] = measure([&] { solver.factorise(); });
      times["analyse"] -= times["factorise"];
      std::vector<double> b(3 * structure.nodes().n_owned, 1.);
      times["solve"] = measure([&] { solver.solve(b.data(), b.data()); });
    }
    problem.compute_residual(0, u.data(), residual.data());
    times["residual"] = measure(
        [&] { problem.compute_residual(0, u.data(), residual.data()); });

    time::EquilibriumStatistics count;
    times["newton"] = measure(
        [&] { count = time::find_equilibrium(problem, 0, u.data(), {}); });
    times["iterations"] = count.factorisations;
    times["assembly_%"] = 100 *
                          (count.residuals * times["residual"] +
                           count.factorisations * times["tangent"]) /
                          times["newton"];
    times["unknowns"] = static_cast<double>(n);
    times["peak_GB"] = get_peak_gigabytes();
  }
}
} // namespace

// 28, 91 and 204 cells per side: 1e4, 1e5 and 5e5 unknowns.
BENCHMARK(static_solve)
    ->ArgName("cells")
    ->Arg(28)
    ->Arg(91)
    ->Arg(204)
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
