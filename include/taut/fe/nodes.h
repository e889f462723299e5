#pragma once

#include <taut/base/rotation.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace taut::fe
{
using GlobalNode = unsigned int;
using LocalNode = unsigned int;
using NodalVector = dealii::LinearAlgebra::distributed::Vector<double>;

/// Entry of a nodal vector by local index, ghosts included. deal.II's own
/// access to ghosts insists that they were imported; here they may also be this
/// rank's share of a sum that is not compressed yet.
inline double entry(const NodalVector& vector, const std::size_t index)
{
  return vector.begin()[index];
}

inline double& entry(NodalVector& vector, const std::size_t index)
{
  return vector.begin()[index];
}

/// A node whose position is the weighted mean of others (hanging).
struct HangingNode
{
  LocalNode node;
  std::vector<std::pair<LocalNode, double>> masters;
};

/// A straight rigid bar: two nodes of its own, the centre c and the director d
/// (m), which starts as the vector from the centre to the bar's end. A film
/// node at the fraction s of the half length moves as
///   x = c + s |d_0| n,  n = d/|d|    in forces,
///   x = c + s d                       in inertia.
/// Forces never stretch d, and a weak spring holds its length, so that the two
/// agree; and the mass matrix is constant, which the integrators need.
struct Bar
{
  LocalNode centre;
  LocalNode director;
  double half_length; ///< |d_0| (m)
  /// Stiffness (N/m) of the spring that holds |d|.
  double length_stiffness;
  double mass;           ///< (kg)
  double rotary_inertia; ///< about an axis across the bar (kg m^2)
};

/// A film node on a bar.
struct BarNode
{
  LocalNode node;
  unsigned int bar;
  double fraction; ///< s, -1 to 1
};

/// A rotation as an unknown: a quaternion Q, stored as l Q (m) in two nodes of
/// its own, `vector` for the vector part and the next for (scalar, -, -), whose
/// last two components are held. Only its direction counts (see BeamElement).
struct Rotation
{
  LocalNode vector;
  double length; ///< l (m): Q in the mesh is (l, 0, 0, 0)

  LocalNode scalar() const
  {
    return vector + 1;
  }
};

/// A node on a rigid arm: x = c + R(Q) arm in forces. Inertia sees x = c: the
/// rotary inertia that this leaves out is lumped in the rotation's.
struct Follower
{
  LocalNode node;
  LocalNode centre;
  unsigned int rotation;
  std::array<double, 3> arm; ///< in the mesh (m)
};

/// The nodes this rank sees: its own first (consecutive in the global
/// numbering), then ghosts. Positions and forces are NodalVectors with entry
/// 3 node + component.
struct Nodes
{
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner;
  LocalNode n_owned = 0;
  LocalNode n_local = 0; ///< with ghosts
  GlobalNode n_global = 0;
  GlobalNode first_owned = 0;
  /// Nodes that are not in the mesh of the film, those of bars, frames and
  /// rigid bodies, are numbered from here to n_global; the last rank owns them
  /// and every rank sees them.
  GlobalNode first_extra = 0;
  std::vector<GlobalNode> ghosts; ///< increasing
  /// Position in the mesh, all local nodes (m).
  std::vector<std::array<double, 3>> mesh_position;
  /// Bit c set: component c is prescribed. All local nodes.
  std::vector<std::uint8_t> held;
  /// Nodes that follow others, and bars; all that this rank's cells touch.
  std::vector<HangingNode> hanging;
  std::vector<BarNode> on_bar;
  std::vector<Bar> bars;
  std::vector<Rotation> rotations;
  std::vector<Follower> followers;
  /// True for nodes that follow others; all local nodes.
  std::vector<bool> dependent;

  GlobalNode global(const LocalNode node) const
  {
    return node < n_owned ? first_owned + node : ghosts[node - n_owned];
  }
  /// Errors: throws std::out_of_range if this rank does not see the node.
  LocalNode local(GlobalNode node) const;
  NodalVector make_vector() const;
};

/// The stored quaternion, scalar part first (m).
Quaternion get_quaternion(const Rotation& rotation, const NodalVector& values);

/// d(R(Q) arm)/dQ at the stored quaternion: by the vector part, 3 x 3
/// row-major, and by the scalar part (dimensionless).
struct ArmDerivative
{
  std::array<double, 9> by_vector;
  std::array<double, 3> by_scalar;
};
ArmDerivative compute_arm_derivative(const Quaternion& q,
                                     const std::array<double, 3>& arm);
/// Second derivative of force . R(Q) arm by (scalar, vector), 4 x 4 (N/m).
std::array<double, 16>
compute_arm_curvature(const Quaternion& q, const std::array<double, 3>& arm,
                      const std::array<double, 3>& force);

/// Fills in the positions of dependent nodes from those they follow. Needs
/// current ghosts.
void distribute_positions(const Nodes& nodes, NodalVector& positions);

/// The same for a small change `dx` at `positions`, or (positions == nullptr)
/// for velocities and accelerations of the inertia, x = c + s d.
void distribute_change(const Nodes& nodes, const NodalVector* positions,
                       NodalVector& dx);

/// Moves the forces on dependent nodes to those they follow (the transpose of
/// distribute_change) and leaves zero on them: hanging nodes first, which may
/// follow nodes of bars or on arms, then those. Local; compress(add) follows.
void collect_hanging_forces(const Nodes& nodes, NodalVector& forces);
void collect_bar_forces(const Nodes& nodes, const NodalVector* positions,
                        NodalVector& forces);
void collect_follower_forces(const Nodes& nodes, const NodalVector* positions,
                             NodalVector& forces);
void collect_forces(const Nodes& nodes, const NodalVector* positions,
                    NodalVector& forces);
} // namespace taut::fe
