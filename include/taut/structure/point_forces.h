#pragma once

#include <taut/fe/tangent_matrix.h>
#include <taut/structure/device_nodes.h>
#include <taut/structure/loads.h>

#include <optional>
#include <vector>

namespace taut::structure
{
/// A node of this rank that a point load or a point mass acts on.
struct LoadedNode
{
  unsigned int entry; ///< index in the description's list
  fe::LocalNode node;
  /// Of the frame or body, in Nodes::rotations.
  std::optional<unsigned int> rotation;
};

/// The owned nodes at the points of an entry: those of frames where there are
/// any, else those of films. Errors: BadInput if the groups have no node.
std::vector<LoadedNode>
find_loaded_nodes(const std::vector<std::string>& groups, unsigned int entry,
                  const Named& description, const std::string& kind,
                  const fe::MeshData& mesh,
                  const dealii::DoFHandler<2, 3>& dof_handler,
                  const DeviceNodes& device_nodes);

/// Forces and moments at points, dead or turning with the frame.
class PointForces
{
public:
  /// Errors: BadInput for moments and follower forces where no frame is.
  PointForces(const Device& device, const fe::MeshData& mesh,
              const dealii::DoFHandler<2, 3>& dof_handler,
              const DeviceNodes& device_nodes);

  /// True if the forces have no potential: the tangent is not symmetric then.
  bool follow() const;
  /// forces += the loads; `dead`: only those of a potential, `following`: only
  /// the others.
  void add_forces(const LoadState& loads, const fe::NodalVector& positions,
                  bool dead, bool following, fe::NodalVector& forces) const;
  /// - d forces/d positions.
  void add_stiffness(const LoadState& loads, const fe::NodalVector& positions,
                     fe::TangentMatrix& matrix) const;
  /// forces += d(dead loads)/dt.
  void add_force_rates(const LoadState& loads, fe::NodalVector& rates) const;

private:
  bool follows(const PointLoad& load) const;

  const Device& device_;
  const fe::Nodes& nodes_;
  std::vector<LoadedNode> loaded_;
};

/// Adds a 4 x 4 matrix in (scalar, vector) of a stored quaternion.
void add_rotation_block(const fe::Rotation& rotation,
                        const std::array<double, 16>& block,
                        fe::TangentMatrix& matrix);
} // namespace taut::structure
