#pragma once

#include "structure/balance.h"
#include "structure/frames.h"

/// Runs of frames in time.
namespace taut::testing
{
/// total + lost - work, which a motion keeps.
inline double compute_balance(structure::StructureSystem& system,
                              const double time, const double* state)
{
  const auto s = get_scalars(system, state);
  return system.compute_energies(time, state).total() +
         s[structure::Scalar::lost] - s[structure::Scalar::work];
}

/// Options for devices whose lengths and times are of the order of 1.
inline time::IntegratorOptions make_motion_options(const double tolerance)
{
  time::IntegratorOptions options;
  options.position_tolerance = tolerance;
  options.velocity_time = 1;
  options.first_step = 1e-3;
  return options;
}

/// Index among the free unknowns of component `c` of a node, or -1.
inline std::vector<int> index_unknowns(const structure::Structure& structure)
{
  std::vector<int> index(3 * structure.nodes().n_local, -1);
  const auto& free = structure.free_unknowns();
  for (std::size_t i = 0; i < free.size(); ++i)
    index[free[i]] = i;
  return index;
}

/// Gives every node of the frames and bodies the velocity omega x x and every
/// rotation the angular velocity omega, in the reference state.
inline void set_spin(const structure::Structure& structure,
                     const Vector3& omega, std::vector<double>& state)
{
  const auto index = index_unknowns(structure);
  double* v = state.data() + structure.n_free();
  const auto set = [&](const std::size_t entry, const double value)
  {
    if (index[entry] >= 0)
      v[index[entry]] = value;
  };
  const auto& nodes = structure.nodes();
  const auto set_node = [&](const fe::LocalNode node)
  {
    const auto& x = nodes.mesh_position[node];
    const Vector3 velocity{omega[1] * x[2] - omega[2] * x[1],
                           omega[2] * x[0] - omega[0] * x[2],
                           omega[0] * x[1] - omega[1] * x[0]};
    for (unsigned int c = 0; c < 3; ++c)
      set(3 * node + c, velocity[c]);
  };
  for (const auto& node : structure.device_nodes().frames.nodes)
    set_node(nodes.local(node.position));
  for (const auto& body : structure.device_nodes().frames.bodies)
    set_node(nodes.local(body.centre));
  for (const auto& rotation : nodes.rotations)
    for (unsigned int c = 0; c < 3; ++c)
      set(3 * rotation.vector + c, .5 * rotation.length * omega[c]);
}

/// The quaternion of a rotation and its rate, at a state in time.
struct Turning
{
  Quaternion q, rate;
};

inline Turning get_turning(structure::StructureSystem& system,
                           const double time, const double* state,
                           const fe::Rotation& rotation)
{
  auto& structure = system.structure();
  const auto loads = system.history().at(time);
  const Quaternion q =
      fe::get_quaternion(rotation, structure.compute_positions(loads, state));
  return {q,
          fe::get_quaternion(rotation, structure.compute_velocities(
                                           loads, system.velocities(state)))};
}
} // namespace taut::testing
