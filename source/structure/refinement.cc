#include <taut/structure/refinement.h>

#include <deal.II/distributed/grid_refinement.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/numerics/error_estimator.h>

namespace taut::structure
{
namespace
{
/// One component of the displacement on the film's nodes, in the numbering of
/// the DoF handler.
fe::NodalVector make_component(const Structure& structure,
                               const fe::NodalVector& positions,
                               const unsigned int component)
{
  const auto& dof_handler = structure.dof_handler();
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
  fe::NodalVector values(dof_handler.locally_owned_dofs(), relevant,
                         structure.communicator());
  for (const auto node : dof_handler.locally_owned_dofs())
  {
    const fe::LocalNode local = structure.nodes().local(node);
    values(node) = fe::entry(positions, 3 * local + component) -
                   structure.nodes().mesh_position[local][component];
  }
  values.update_ghost_values();
  return values;
}
} // namespace

void refine_worst_cells(Structure& structure, const double* u,
                        const LoadState& loads, const double share,
                        fe::Triangulation& triangulation)
{
  const auto& dof_handler = structure.dof_handler();
  const auto& positions = structure.compute_positions(loads, u);
  dealii::Vector<float> total(triangulation.n_active_cells());
  for (unsigned int component = 0; component < 3; ++component)
  {
    dealii::Vector<float> indicator(triangulation.n_active_cells());
    dealii::KellyErrorEstimator<2, 3>::estimate(
        dof_handler, dealii::QGauss<1>(structure.device().mesh.degree + 1), {},
        make_component(structure, positions, component), indicator,
        dealii::ComponentMask(), nullptr, dealii::numbers::invalid_unsigned_int,
        triangulation.locally_owned_subdomain());
    for (unsigned int cell = 0; cell < total.size(); ++cell)
      total[cell] += indicator[cell] * indicator[cell];
  }
  dealii::parallel::distributed::GridRefinement::
      refine_and_coarsen_fixed_number(triangulation, total, share, 0.);
  triangulation.execute_coarsening_and_refinement();
}
} // namespace taut::structure
