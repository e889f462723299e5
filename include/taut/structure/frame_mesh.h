#pragma once

#include <taut/fe/nodes.h>
#include <taut/fe/triangulation.h>
#include <taut/structure/description.h>

#include <deal.II/dofs/dof_handler.h>

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace taut::structure
{
/// An element of a frame: indices of places, the two ends and, for quadratic
/// elements, the middle. It runs towards growing x (or y, z if it is steeper).
struct FrameEdge
{
  unsigned int frame;
  unsigned int line_set; ///< id of its set of line groups
  std::vector<unsigned int> places;
};

/// The lines of all frames of a device: a small mesh of its own, the same on
/// every rank and, up to round-off, for every number of ranks.
struct FrameMesh
{
  /// Where nodes of frames are, at the height of the film (m).
  std::vector<fe::Coordinates> places;
  /// The film's node there, if there is one.
  std::vector<std::optional<fe::GlobalNode>> film_nodes;
  std::vector<FrameEdge> edges;

  /// The place within 1e-7 of the mesh's size of x.
  std::optional<unsigned int> find_place(const fe::Coordinates& x) const;
  double tolerance = 0; ///< (m)
};

using NodePositions =
    std::map<dealii::types::global_dof_index, dealii::Point<3>>;

/// Gathers the lines of the frames: edges of the film's cells as they are
/// refined, and lines of their own, refined as often as the whole film.
/// Errors: BadInput if a group of lines does not exist or belongs to two
/// frames.
FrameMesh make_frame_mesh(const Device& device, const fe::MeshData& mesh,
                          const dealii::DoFHandler<2, 3>& dof_handler,
                          const NodePositions& positions);

/// The places of frames in any of the groups of points or lines.
std::set<unsigned int> find_group_places(const std::vector<std::string>& groups,
                                         const FrameMesh& frame_mesh,
                                         const fe::MeshData& mesh);

/// A point of the parabola (or straight line) through the nodes of an edge, its
/// ends and its middle; s from 0 to 1.
fe::Coordinates interpolate_edge(const std::vector<fe::Coordinates>& nodes,
                                 double s);

/// Largest extent of all points of the mesh along an axis (m).
double compute_extent(const fe::MeshData& mesh);
} // namespace taut::structure
