#pragma once

#include <taut/fe/mesh_data.h>

#include <deal.II/base/point.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>

#include <map>

namespace taut::fe
{
using Triangulation = dealii::parallel::distributed::Triangulation<2, 3>;

/// Fills the empty `triangulation` with `mesh`, the same on all ranks, and
/// refines it `refinements` times.
///
/// Cells carry their group set as material id, lines as manifold id (boundary
/// lines also as boundary id), see MeshGroups; all of them survive refinement.
/// The local vertices of a cell run in the sense of its quad in `mesh`, so that
/// the cross product of the two tangents is the normal of the file. The
/// manifolds are flat: curved geometry is in `compute_reference_positions`.
/// Errors: BadInput if more than two cells meet at an edge, or if the surface
/// is one-sided in a way that has no consistent numbering.
void create_triangulation(const MeshData& mesh, unsigned int refinements,
                          Triangulation& triangulation);

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
