#pragma once

#include <taut/fe/beam_element.h>
#include <taut/structure/frame_mesh.h>

#include <map>
#include <vector>

namespace taut::structure
{
/// A node that the mesh of the film does not have.
struct ExtraNode
{
  fe::Coordinates mesh_position;
  std::uint8_t held = 0;
};

/// A node of a frame.
struct FrameNode
{
  fe::GlobalNode position;
  /// By frame: index into Nodes::rotations. The same for all frames that are
  /// joined rigidly here.
  std::map<unsigned int, unsigned int> rotations;
  /// Index of the rigid body it belongs to.
  std::optional<unsigned int> body;
};

/// The reference point of a rigid body.
struct BodyNode
{
  fe::GlobalNode centre;
  unsigned int rotation;
};

struct FrameFollower
{
  fe::GlobalNode node;
  fe::GlobalNode centre;
  unsigned int rotation;
  fe::Coordinates arm;
};

/// Which nodes frames and rigid bodies have, which they share with the film and
/// which film nodes follow them; the same on every rank, in global numbers.
/// Extra nodes are numbered behind the film's.
struct FrameNodes
{
  FrameMesh mesh;
  std::vector<ExtraNode> extras;
  /// Of every rotation, the node of its vector part.
  std::vector<fe::GlobalNode> rotations;
  double rotation_length = 1;   ///< (m)
  std::vector<FrameNode> nodes; ///< by place
  std::vector<BodyNode> bodies;
  std::vector<FrameFollower> followers;

  /// Film nodes that every rank must see.
  std::vector<fe::GlobalNode>
  get_shared_film_nodes(fe::GlobalNode n_film) const;
};

/// Errors: BadInput for groups that do not exist, frames that meet at different
/// offsets, attachments where there is no film, bodies that share nodes.
FrameNodes make_frame_nodes(const Device& device, const fe::MeshData& mesh,
                            const dealii::DoFHandler<2, 3>& dof_handler,
                            const NodePositions& positions);

/// Gives `nodes` the rotations and followers of the frames.
void add_frame_nodes(const FrameNodes& frame_nodes, fe::Nodes& nodes);
} // namespace taut::structure
