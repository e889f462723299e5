#include "run_rest_shape.h"

#include <taut/base/exceptions.h>
#include <taut/structure/rest_shape.h>

namespace taut::study
{
namespace
{
structure::RestPathOptions make_options(const ProcedureDescription& procedure)
{
  structure::RestPathOptions options;
  options.direction = procedure.rest_shape.direction;
  options.perturbation = procedure.rest_shape.perturbation;
  options.first_stiffness = procedure.rest_shape.first_stiffness;
  options.steps = procedure.rest_shape.steps;
  options.newton.tolerance = procedure.newton_tolerance;
  return options;
}

void refuse_unstable(const structure::RestShape& shape)
{
  if (shape.negative_eigenvalues > 0)
    throw SolverFailed("the rest shape found is unstable in " +
                       std::to_string(shape.negative_eigenvalues) +
                       " directions: change Direction or Perturbation in Rest "
                       "shape");
}
} // namespace

RestStart start_from_rest_shape(const Case& run_case,
                                structure::StructureSystem& system,
                                FilmRows& rows)
{
  const ProcedureDescription& procedure = run_case.procedure;
  auto options = make_options(procedure);
  structure::RestShape shape;
  const auto find =
      [&](const structure::Networks networks, const double* internal, double* u)
  {
    shape = structure::find_rest_shape(system.structure(), system.history(),
                                       networks, internal, procedure.start_time,
                                       options, u);
  };
  RestStart start;
  start.state =
      system.make_initial_state(procedure.start_time, procedure.start, find);
  refuse_unstable(shape);
  start.counters = {
      {"rest_shape_factorisations", shape.statistics.factorisations},
      {"rest_shape_iterations", shape.statistics.iterations},
      {"rest_shape_negative_eigenvalues", shape.negative_eigenvalues}};
  if (shape.flat_negative_eigenvalues)
    start.counters["flat_negative_eigenvalues"] =
        *shape.flat_negative_eigenvalues;
  if (shape.flat_negative_eigenvalues == 0)
    start.notes.push_back(
        "the flat state is stable: the pull of the film stays below the "
        "threshold at which the frame buckles");
  if (procedure.rest_shape.both_branches)
  {
    for (double& component : options.direction)
      component *= -1;
    const auto other =
        system.make_initial_state(procedure.start_time, procedure.start, find);
    refuse_unstable(shape);
    rows.begin(procedure.start_time, other.data());
    start.other_branch = rows.make_row(procedure.start_time, other.data());
  }
  return start;
}
} // namespace taut::study
