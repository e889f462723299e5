#pragma once

#include <taut/fe/mesh_data.h>

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>

#include <map>

namespace taut::fe
{
/// The curved position (m) of a point of the coarse cell `quad`, whose unit
/// coordinates run from vertex 0 to 1 and from vertex 0 to 3: the sum of its 4
/// or 9 Lagrange polynomials.
dealii::Point<3> compute_position(const MeshData& mesh, const MeshQuad& quad,
                                  const dealii::Point<2>& unit_point);

/// The position (m) of every support point of a scalar Lagrange element on the
/// cells known to this rank (own and ghost), by global dof index. Each active
/// cell is a square in the unit coordinates of its coarse cell, so positions
/// are exact under any refinement, and a hanging node lies on the edge of its
/// neighbour wherever the element has the order of the mesh.
std::map<dealii::types::global_dof_index, dealii::Point<3>>
compute_reference_positions(const dealii::DoFHandler<2, 3>& dof_handler,
                            const MeshData& mesh);
} // namespace taut::fe
