// CPU time of the film's residual and tangent, per cell and per quadrature
// point, without (`kernel`) and with its insertion into the matrix. The goals
// for Q2 in 3-D: tangent with insertion below 8 us per cell, residual below 2.

#include <taut/fe/film_assembly.h>

#include <benchmark/benchmark.h>

#include <random>

#include "square_film.h"

using namespace taut;
using namespace taut::benchmarks;

namespace
{
enum Material
{
  elastic,
  viscous
};

/// The square in a random state near the mesh.
struct Problem
{
  Problem(const benchmark::State& state)
      : square(make_square_film(state)), model(make_model(square)),
        structure(*model->structure), cells(structure.cells()),
        laws(fe::make_laws(cells, {square.voltage})),
        positions(structure.nodes().make_vector()), forces(positions),
        internal(cells.n_internal()), rates(cells.n_internal())
  {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> noise(-1e-5, 1e-5);
    const auto& mesh = structure.nodes().mesh_position;
    for (fe::LocalNode node = 0; node < mesh.size(); ++node)
      for (unsigned int c = 0; c < 3; ++c)
        fe::entry(positions, 3 * node + c) = mesh[node][c] + noise(generator);
    const auto relaxed = material::relaxed(*cells.films()[0].elastomer);
    auto relaxed_laws = laws;
    for (auto& law : relaxed_laws)
      law.elastomer = &relaxed;
    fe::set_relaxed(cells, relaxed_laws, positions, internal.data());
  }

  static SquareFilm make_square_film(const benchmark::State& state)
  {
    SquareFilm square;
    square.width_share = state.range(2) / 100.;
    square.degree = state.range(0);
    square.cells_per_side = 60;
    square.networks = state.range(1) == viscous;
    square.limit = 60;
    return square;
  }

  fe::TangentRequest make_request() const
  {
    fe::TangentRequest request;
    request.positions = &positions;
    request.internal = internal.data();
    request.alpha = 1e3;
    request.inertia = true;
    return request;
  }

  void report(benchmark::State& state, const double bytes_per_cell) const
  {
    using benchmark::Counter;
    const double n = cells.cells().size();
    const auto flags = Counter::kIsIterationInvariantRate | Counter::kInvert;
    state.counters["s_per_cell"] = Counter(n, flags);
    state.counters["s_per_point"] = Counter(n * cells.element().n_nodes, flags);
    state.counters["B_per_cell"] = bytes_per_cell;
  }

  double compute_state_bytes() const
  {
    const double n = cells.element().n_nodes;
    const double networks = cells.n_networks(0);
    return 8 * (2 * n * n + n + 3 * n + 3 * n * networks);
  }

  SquareFilm square;
  std::unique_ptr<testing::Model> model;
  structure::Structure& structure;
  const fe::FilmCells& cells;
  std::vector<fe::BatchLaw> laws;
  fe::NodalVector positions, forces;
  std::vector<double> internal, rates;
};

void residual(benchmark::State& state)
{
  Problem problem(state);
  fe::FilmPowers powers;
  for (auto _ : state)
    fe::add_internal_forces(problem.cells, problem.laws, problem.positions,
                            problem.internal.data(), problem.forces,
                            problem.rates.data(), powers);
  problem.report(state, problem.compute_state_bytes());
}

void tangent_kernel(benchmark::State& state)
{
  const Problem problem(state);
  const auto& cells = problem.cells;
  const auto& element = cells.element();
  dealii::AlignedVector<double> x(cells.nodal_size()), A(cells.internal_size()),
      K(8 * 9 * element.n_nodes * element.n_nodes);
  for (auto _ : state)
    for (unsigned int batch = 0; batch < cells.batches().size(); ++batch)
    {
      cells.gather(batch, problem.positions, x.data());
      cells.gather_internal(batch, problem.internal.data(), A.data());
      fe::compute_stiffness(
          cells.geometry(batch), problem.laws[cells.batches()[batch].slot],
          element.values.data(), 1e6, x.data(), A.data(), 1e3, true, K.data());
      benchmark::DoNotOptimize(K.data());
    }
  problem.report(state, problem.compute_state_bytes());
}

void tangent(benchmark::State& state)
{
  Problem problem(state);
  const auto request = problem.make_request();
  fe::TangentMatrix matrix(problem.structure.nodes(), problem.cells, {},
                           fe::TangentMatrix::Coupling::full);
  for (auto _ : state)
  {
    matrix.begin();
    fe::add_stiffness(problem.cells, problem.laws, {}, request, matrix);
    matrix.end();
  }
  const double n = problem.cells.element().n_nodes;
  problem.report(state, problem.compute_state_bytes() + 8 * 9 * n * n);
}

void arguments(benchmark::internal::Benchmark* run)
{
  // The width is that of the film in percent of the one before: at 50 it is
  // wrinkled everywhere.
  run->ArgNames({"degree", "networks", "width"})
      ->ArgsProduct({{1, 2}, {elastic, viscous}, {100, 50}})
      ->Unit(benchmark::kMillisecond);
}
} // namespace

BENCHMARK(residual)->Apply(arguments);
BENCHMARK(tangent_kernel)->Apply(arguments);
BENCHMARK(tangent)->Apply(arguments);
