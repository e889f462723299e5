// Work-precision of the integrators on the square film with three networks
// (0.01, 1, 100 s), relaxed and flat when the pressure begins to act.
//   periods  20 undamped periods of the lowest frequency
//   stiff    the same with a row of cells 1e4 times stiffer
//   creep    100 s with air drag, in percent of the critical one
// `error`: largest difference of the centre's deflection from a run with a much
// tighter tolerance, relative to the largest deflection. The goals: an error of
// 1e-3 with under 120 factorisations; creep with 2 % in under 320 steps.

#include <taut/base/exceptions.h>
#include <taut/time/integrate.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>

#include "square_film.h"

using namespace taut;
using namespace taut::benchmarks;

namespace
{
enum Case
{
  periods,
  stiff,
  creep_2,
  creep_5
};

enum Choice
{
  esdirk4,
  esdirk3,
  bdf_2
};

bool is_creep(const Case which)
{
  return which == creep_2 || which == creep_5;
}

SquareFilm make_case(const Case which)
{
  SquareFilm square;
  square.stiff_row = which == stiff;
  square.damping = which == creep_2 ? 0.02 : which == creep_5 ? 0.05 : 0;
  return square;
}

time::Schedule make_schedule(const Case which)
{
  time::Schedule schedule;
  schedule.end = is_creep(which) ? 100 : 20 / frequency;
  for (unsigned int i = 1; i <= 400; ++i)
    schedule.output_times.push_back(is_creep(which)
                                        ? 1e-6 * std::pow(1e8, i / 400.)
                                        : schedule.end * i / 400);
  return schedule;
}

time::IntegratorOptions make_options(const Choice choice,
                                     const double tolerance)
{
  time::IntegratorOptions options;
  options.position_tolerance = tolerance;
  options.method = choice == esdirk4   ? time::Method::esdirk4
                   : choice == esdirk3 ? time::Method::esdirk3
                                       : time::Method::bdf;
  if (choice == bdf_2)
    options.max_order = 2;
  return options;
}

/// The free unknown that is the height of the film's centre.
std::size_t find_centre(const structure::Structure& structure)
{
  const auto& nodes = structure.nodes().mesh_position;
  for (std::size_t i = 0; i < structure.n_free(); ++i)
  {
    const unsigned int entry = structure.free_unknowns()[i];
    const auto& x = nodes[entry / 3];
    if (entry % 3 == 2 &&
        std::hypot(x[0] - side / 2, x[1] - side / 2) < 1e-9 * side)
      return i;
  }
  throw SolverFailed("the mesh has no node in its centre");
}

struct History
{
  std::vector<double> heights;
  time::IntegratorStatistics statistics;
};

History run(const Case which, const time::IntegratorOptions& options)
{
  const auto model = make_model(make_case(which));
  structure::InertialSystem system(*model->structure);
  auto state =
      system.make_initial_state(0, structure::Start::relaxed, false, {});
  const std::size_t centre = find_centre(*model->structure);
  History history;
  time::Observer observer;
  observer.output = [&](double, const double* y)
  { history.heights.push_back(y[centre]); };
  history.statistics =
      time::integrate(system, state.data(), make_schedule(which), options, {},
                      observer)
          .statistics;
  return history;
}

const History& get_reference(const Case which)
{
  static std::map<Case, History> references;
  const auto found = references.find(which);
  if (found != references.end())
    return found->second;
  const double tolerance = is_creep(which) ? 1e-9 : 1e-12;
  return references[which] = run(which, make_options(esdirk4, tolerance));
}

double compute_error(const History& history, const History& reference)
{
  double error = 0, largest = 0;
  for (std::size_t i = 0; i < reference.heights.size(); ++i)
  {
    error =
        std::max(error, std::abs(history.heights[i] - reference.heights[i]));
    largest = std::max(largest, std::abs(reference.heights[i]));
  }
  return error / largest;
}

void integrate(benchmark::State& state)
{
  const auto which = static_cast<Case>(state.range(0));
  const History& reference = get_reference(which);
  const auto options =
      make_options(static_cast<Choice>(state.range(1)),
                   std::pow(10., -0.5 * static_cast<double>(state.range(2))));
  History history;
  for (auto _ : state)
    history = run(which, options);
  state.counters["tolerance"] = options.position_tolerance;
  state.counters["error"] = compute_error(history, reference);
  state.counters["steps"] = history.statistics.steps;
  state.counters["rejected"] = history.statistics.rejected_by_error +
                               history.statistics.rejected_by_newton;
  state.counters["factorisations"] = history.statistics.factorisations;
  state.counters["solves"] = history.statistics.solves;
}

/// Tolerances as halves of powers of ten.
void register_runs(const char* name, const Case which,
                   const std::vector<std::pair<Choice, std::vector<int>>>& runs)
{
  for (const auto& [choice, tolerances] : runs)
  {
    const char* methods[] = {"/esdirk4", "/esdirk3", "/bdf(2)"};
    auto* benchmark = benchmark::RegisterBenchmark(
        (std::string(name) + methods[choice]).c_str(), integrate);
    for (const int tolerance : tolerances)
      benchmark->Args({which, choice, tolerance});
    benchmark->ArgNames({"", "", "-2lg"})
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
}

const bool registered = []
{
  for (const auto& [name, which] :
       {std::pair("periods", periods), std::pair("stiff", stiff)})
    register_runs(
        name, which,
        {{esdirk4, {18, 19, 20, 21}}, {esdirk3, {20, 22}}, {bdf_2, {20, 22}}});
  for (const auto& [name, which] :
       {std::pair("creep_2%", creep_2), std::pair("creep_5%", creep_5)})
    register_runs(
        name, which,
        {{esdirk4, {14, 15, 16}}, {esdirk3, {14, 16}}, {bdf_2, {14, 16}}});
  return true;
}();
} // namespace
