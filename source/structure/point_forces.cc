#include <taut/base/exceptions.h>
#include <taut/fe/vector3.h>
#include <taut/structure/point_forces.h>

#include <cmath>

namespace taut::structure
{
namespace
{
Vector3 make_unit(const Vector3& direction, const double length)
{
  const double norm = std::sqrt(fe::dot(direction, direction));
  if (norm == 0)
    return {};
  return {length * direction[0] / norm, length * direction[1] / norm,
          length * direction[2] / norm};
}

double dot(const Quaternion& a, const Quaternion& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// The force on Q of a moment m: 2 m Q/|Q|^2, or 2 Q m/|Q|^2 if m turns with
/// the body.
Quaternion apply_moment(const Vector3& moment, const Quaternion& q,
                        const bool follows)
{
  const Quaternion m{0, moment[0], moment[1], moment[2]};
  Quaternion force = follows ? multiply(q, m) : multiply(m, q);
  const double factor = 2 / dot(q, q);
  for (double& component : force)
    component *= factor;
  return force;
}
} // namespace

std::vector<LoadedNode>
find_loaded_nodes(const std::vector<std::string>& groups,
                  const unsigned int entry, const Named& description,
                  const std::string& kind, const fe::MeshData& mesh,
                  const dealii::DoFHandler<2, 3>& dof_handler,
                  const DeviceNodes& device_nodes)
{
  const fe::Nodes& nodes = device_nodes.nodes;
  const auto film =
      find_group_nodes(groups, mesh, dof_handler, description, kind);
  std::vector<LoadedNode> loaded;
  const auto places = find_group_places(groups, device_nodes.frames.mesh, mesh);
  for (const auto place : places)
  {
    const FrameNode& frame_node = device_nodes.frames.nodes[place];
    const fe::LocalNode node = nodes.local(frame_node.position);
    if (node < nodes.n_owned)
      loaded.push_back({entry, node, frame_node.rotations.begin()->second});
  }
  if (places.empty())
    for (const auto global : film)
      if (const auto node = nodes.local(global); node < nodes.n_owned)
        loaded.push_back({entry, node, std::nullopt});
  if (dealii::Utilities::MPI::sum(
          loaded.size(), nodes.partitioner->get_mpi_communicator()) == 0)
    throw BadInput("its groups have no nodes", "", description.source_line,
                   kind + " " + description.name);
  return loaded;
}

PointForces::PointForces(const Device& device, const fe::MeshData& mesh,
                         const dealii::DoFHandler<2, 3>& dof_handler,
                         const DeviceNodes& device_nodes)
    : device_(device), nodes_(device_nodes.nodes)
{
  for (unsigned int i = 0; i < device.point_loads.size(); ++i)
  {
    const PointLoad& load = device.point_loads[i];
    for (const auto& node :
         find_loaded_nodes(load.groups, i, load, "Point load", mesh,
                           dof_handler, device_nodes))
    {
      if (!node.rotation && follows(load))
        throw BadInput("moments and follower forces act on frames; no frame "
                       "has a node there",
                       "", load.source_line, "Point load " + load.name);
      loaded_.push_back(node);
    }
  }
}

bool PointForces::follows(const PointLoad& load) const
{
  const bool has_moment =
      load.moment_direction != Vector3{} &&
      !(load.moment.is_constant() && load.moment.value(0) == 0);
  return load.follower || has_moment;
}

bool PointForces::follow() const
{
  for (const auto& load : device_.point_loads)
    if (follows(load))
      return true;
  return false;
}

void PointForces::add_forces(const LoadState& loads,
                             const fe::NodalVector& positions, const bool dead,
                             const bool following,
                             fe::NodalVector& forces) const
{
  for (const auto& [entry, node, rotation] : loaded_)
  {
    const PointLoad& load = device_.point_loads[entry];
    if (load.follower ? following : dead)
    {
      Vector3 force =
          make_unit(load.force_direction, loads.point_forces[entry]);
      if (load.follower)
        force = rotate(
            fe::get_quaternion(nodes_.rotations[*rotation], positions), force);
      for (unsigned int c = 0; c < 3; ++c)
        fe::entry(forces, 3 * node + c) += force[c];
    }
    if (!following || !rotation)
      continue;
    const fe::Rotation& turning = nodes_.rotations[*rotation];
    const Quaternion moment = apply_moment(
        make_unit(load.moment_direction, loads.point_moments[entry]),
        fe::get_quaternion(turning, positions), load.follower);
    fe::entry(forces, 3 * turning.scalar()) += moment[0];
    for (unsigned int c = 0; c < 3; ++c)
      fe::entry(forces, 3 * turning.vector + c) += moment[1 + c];
  }
}

void PointForces::add_force_rates(const LoadState& loads,
                                  fe::NodalVector& rates) const
{
  for (const auto& [entry, node, rotation] : loaded_)
  {
    const PointLoad& load = device_.point_loads[entry];
    if (load.follower)
      continue;
    const Vector3 rate =
        make_unit(load.force_direction, loads.point_force_rates[entry]);
    for (unsigned int c = 0; c < 3; ++c)
      fe::entry(rates, 3 * node + c) += rate[c];
  }
}

void PointForces::add_stiffness(const LoadState& loads,
                                const fe::NodalVector& positions,
                                fe::TangentMatrix& matrix) const
{
  for (const auto& [entry, node, rotation] : loaded_)
  {
    const PointLoad& load = device_.point_loads[entry];
    if (!rotation || !follows(load))
      continue;
    const fe::Rotation& turning = nodes_.rotations[*rotation];
    const Quaternion q = fe::get_quaternion(turning, positions);
    const double square = dot(q, q);
    const Vector3 moment =
        make_unit(load.moment_direction, loads.point_moments[entry]);
    // The force is linear in Q over |Q|^2.
    const Quaternion force = apply_moment(moment, q, load.follower);
    std::array<double, 16> block;
    for (unsigned int j = 0; j < 4; ++j)
    {
      Quaternion unit{};
      unit[j] = 1;
      const Quaternion column = apply_moment(moment, unit, load.follower);
      for (unsigned int i = 0; i < 4; ++i)
        block[4 * i + j] = -(column[i] / square - 2 * force[i] * q[j] / square);
    }
    add_rotation_block(turning, block, matrix);
    if (!load.follower)
      continue;
    const auto derivative = fe::compute_arm_derivative(
        q, make_unit(load.force_direction, loads.point_forces[entry]));
    std::array<double, 9> by_vector, by_scalar{};
    for (unsigned int i = 0; i < 9; ++i)
      by_vector[i] = -derivative.by_vector[i];
    for (unsigned int i = 0; i < 3; ++i)
      by_scalar[3 * i] = -derivative.by_scalar[i];
    matrix.add_block(node, turning.vector, by_vector.data());
    matrix.add_block(node, turning.scalar(), by_scalar.data());
  }
}

void add_rotation_block(const fe::Rotation& rotation,
                        const std::array<double, 16>& block,
                        fe::TangentMatrix& matrix)
{
  std::array<double, 9> vector, row{}, column{}, scalar{};
  scalar[0] = block[0];
  for (unsigned int i = 0; i < 3; ++i)
  {
    row[i] = block[1 + i];
    column[3 * i] = block[4 * (1 + i)];
    for (unsigned int j = 0; j < 3; ++j)
      vector[3 * i + j] = block[4 * (1 + i) + 1 + j];
  }
  matrix.add_block(rotation.vector, rotation.vector, vector.data());
  matrix.add_block(rotation.scalar(), rotation.vector, row.data());
  matrix.add_block(rotation.vector, rotation.scalar(), column.data());
  matrix.add_block(rotation.scalar(), rotation.scalar(), scalar.data());
}
} // namespace taut::structure
