#include <taut/structure/refinement.h>
#include <taut/study/adaptation.h>

namespace taut::study
{
std::unique_ptr<structure::Structure>
make_adapted_structure(const Case& run_case, const fe::MeshData& mesh,
                       fe::Triangulation& triangulation)
{
  using structure::Structure;
  const ProcedureDescription& procedure = run_case.procedure;
  const structure::MeshDescription& description = run_case.device.mesh;
  auto result =
      std::make_unique<Structure>(run_case.device, mesh, triangulation);
  time::PathOptions options;
  options.newton.tolerance = procedure.newton_tolerance;
  for (unsigned int i = 0; i < description.adaptive_refinements; ++i)
  {
    structure::QuasiStaticSystem system(*result, options);
    const auto state = system.make_initial_state(
        procedure.start_time, procedure.start, true, options);
    structure::refine_worst_cells(
        *result, state.data(),
        system.loads_at(procedure.start_time, state.data()),
        description.refined_share, triangulation);
    result = std::make_unique<Structure>(run_case.device, mesh, triangulation);
  }
  return result;
}
} // namespace taut::study
