#pragma once

#include <taut/fe/nodes.h>
#include <taut/fe/triangulation.h>
#include <taut/structure/description.h>
#include <taut/structure/frame_nodes.h>

#include <vector>

namespace taut::structure
{
/// A prescribed component: displacement = shape * amplitude of the support.
struct HeldComponent
{
  fe::LocalNode node;
  unsigned int component;
  unsigned int support; ///< index in the description
  double shape;         ///< (m)
};

/// The nodes of a device on its mesh: who is free, prescribed, follows others.
struct DeviceNodes
{
  fe::Nodes nodes;
  /// All local nodes whose movement a support prescribes (only those with a
  /// shape other than 0).
  std::vector<HeldComponent> moving;
  /// By support: the owned nodes it holds.
  std::vector<std::vector<fe::LocalNode>> of_support;
  FrameNodes frames;
};

/// Errors: BadInput (with the line of the entry) if a group is missing in the
/// mesh, a bar is not straight, a support holds what a bar leaves free, two
/// supports prescribe different motions, or the expression of a shape is wrong.
DeviceNodes make_device_nodes(const Device& device, const fe::MeshData& mesh,
                              const dealii::DoFHandler<2, 3>& dof_handler);

/// Local nodes (owned and ghost) in any of the named groups of `mesh`, of
/// dimension 0, 1 or 2 each; increasing. `context` prefixes errors.
/// Errors: BadInput if a group does not exist in any dimension.
std::vector<fe::GlobalNode>
find_group_nodes(const std::vector<std::string>& groups,
                 const fe::MeshData& mesh,
                 const dealii::DoFHandler<2, 3>& dof_handler,
                 const Named& entry, const std::string& key);
} // namespace taut::structure
