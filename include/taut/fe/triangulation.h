#pragma once

#include <taut/fe/mesh_data.h>
#include <taut/fe/reference_positions.h>

#include <deal.II/distributed/tria.h>

namespace taut::fe
{
using Triangulation = dealii::parallel::distributed::Triangulation<2, 3>;

/// Fills the empty `triangulation` with `mesh`, the same on all ranks, and
/// refines it `refinements` times. Free lines are no part of it.
///
/// Cells carry their group set as material id, lines as manifold id (boundary
/// lines also as boundary id), see MeshGroups; all of them survive refinement.
/// The local vertices of a cell run in the sense of its quad in `mesh`, so that
/// the cross product of the two tangents is the normal of the file. The
/// manifolds are flat: curved geometry is in compute_reference_positions.
/// Errors: BadInput if more than two cells meet at an edge, or if the surface
/// is one-sided in a way that has no consistent numbering.
void create_triangulation(const MeshData& mesh, unsigned int refinements,
                          Triangulation& triangulation);
} // namespace taut::fe
