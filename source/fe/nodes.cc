#include <taut/fe/nodes.h>
#include <taut/fe/vector3.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace taut::fe
{
namespace
{
using Vector3 = std::array<double, 3>;

Vector3 get(const NodalVector& vector, const LocalNode node)
{
  return {entry(vector, 3 * node), entry(vector, 3 * node + 1),
          entry(vector, 3 * node + 2)};
}

/// dx = dc + d(R(Q) arm)/dQ dQ; without `positions`, dx = dc.
void distribute_follower_change(const Nodes& nodes, const Follower& follower,
                                const NodalVector* positions, NodalVector& dx)
{
  Vector3 change = get(dx, follower.centre);
  if (positions)
  {
    const Rotation& rotation = nodes.rotations[follower.rotation];
    const ArmDerivative derivative = compute_arm_derivative(
        get_quaternion(rotation, *positions), follower.arm);
    const Quaternion dQ = get_quaternion(rotation, dx);
    for (unsigned int i = 0; i < 3; ++i)
    {
      change[i] += derivative.by_scalar[i] * dQ[0];
      for (unsigned int j = 0; j < 3; ++j)
        change[i] += derivative.by_vector[3 * i + j] * dQ[1 + j];
    }
  }
  for (unsigned int i = 0; i < 3; ++i)
    entry(dx, 3 * follower.node + i) = change[i];
}

/// |d_0| (1 - n n^T)/|d| v: the change of |d_0| n when d changes by v; itself
/// symmetric, so it also moves forces back to d.
Vector3 turn(const Bar& bar, const NodalVector& positions, const Vector3& v)
{
  const Vector3 d = get(positions, bar.director);
  const double length = std::sqrt(dot(d, d));
  const double along = dot(d, v) / (length * length);
  Vector3 result;
  for (unsigned int i = 0; i < 3; ++i)
    result[i] = bar.half_length / length * (v[i] - along * d[i]);
  return result;
}
} // namespace

LocalNode Nodes::local(const GlobalNode node) const
{
  if (node >= first_owned && node < first_owned + n_owned)
    return node - first_owned;
  const auto ghost = std::lower_bound(ghosts.begin(), ghosts.end(), node);
  if (ghost == ghosts.end() || *ghost != node)
    throw std::out_of_range("node not on this rank");
  return n_owned + (ghost - ghosts.begin());
}

NodalVector Nodes::make_vector() const
{
  return NodalVector(partitioner);
}

void distribute_positions(const Nodes& nodes, NodalVector& positions)
{
  // Bars first: a hanging node may lie between nodes of a bar.
  for (const auto& on_bar : nodes.on_bar)
  {
    const Bar& bar = nodes.bars[on_bar.bar];
    const Vector3 c = get(positions, bar.centre);
    const Vector3 d = get(positions, bar.director);
    const double scale =
        on_bar.fraction * bar.half_length / std::sqrt(dot(d, d));
    for (unsigned int i = 0; i < 3; ++i)
      entry(positions, 3 * on_bar.node + i) = c[i] + scale * d[i];
  }
  for (const auto& follower : nodes.followers)
  {
    const Vector3 arm =
        rotate(get_quaternion(nodes.rotations[follower.rotation], positions),
               follower.arm);
    for (unsigned int i = 0; i < 3; ++i)
      entry(positions, 3 * follower.node + i) =
          entry(positions, 3 * follower.centre + i) + arm[i];
  }
  for (const auto& hanging : nodes.hanging)
    for (unsigned int i = 0; i < 3; ++i)
    {
      double x = 0;
      for (const auto& [master, weight] : hanging.masters)
        x += weight * entry(positions, 3 * master + i);
      entry(positions, 3 * hanging.node + i) = x;
    }
}

void distribute_change(const Nodes& nodes, const NodalVector* positions,
                       NodalVector& dx)
{
  for (const auto& on_bar : nodes.on_bar)
  {
    const Bar& bar = nodes.bars[on_bar.bar];
    const Vector3 dc = get(dx, bar.centre);
    const Vector3 dd = get(dx, bar.director);
    const Vector3 turned = positions ? turn(bar, *positions, dd) : dd;
    for (unsigned int i = 0; i < 3; ++i)
      entry(dx, 3 * on_bar.node + i) = dc[i] + on_bar.fraction * turned[i];
  }
  for (const auto& follower : nodes.followers)
    distribute_follower_change(nodes, follower, positions, dx);
  for (const auto& hanging : nodes.hanging)
    for (unsigned int i = 0; i < 3; ++i)
    {
      double x = 0;
      for (const auto& [master, weight] : hanging.masters)
        x += weight * entry(dx, 3 * master + i);
      entry(dx, 3 * hanging.node + i) = x;
    }
}

void collect_hanging_forces(const Nodes& nodes, NodalVector& forces)
{
  for (const auto& hanging : nodes.hanging)
    for (unsigned int i = 0; i < 3; ++i)
    {
      double& force = entry(forces, 3 * hanging.node + i);
      for (const auto& [master, weight] : hanging.masters)
        entry(forces, 3 * master + i) += weight * force;
      force = 0;
    }
}

void collect_bar_forces(const Nodes& nodes, const NodalVector* positions,
                        NodalVector& forces)
{
  for (const auto& on_bar : nodes.on_bar)
  {
    const Bar& bar = nodes.bars[on_bar.bar];
    const Vector3 force = get(forces, on_bar.node);
    const Vector3 turned = positions ? turn(bar, *positions, force) : force;
    for (unsigned int i = 0; i < 3; ++i)
    {
      entry(forces, 3 * bar.centre + i) += force[i];
      entry(forces, 3 * bar.director + i) += on_bar.fraction * turned[i];
      entry(forces, 3 * on_bar.node + i) = 0;
    }
  }
}

void collect_follower_forces(const Nodes& nodes, const NodalVector* positions,
                             NodalVector& forces)
{
  for (const auto& follower : nodes.followers)
  {
    const Vector3 force = get(forces, follower.node);
    for (unsigned int i = 0; i < 3; ++i)
    {
      entry(forces, 3 * follower.centre + i) += force[i];
      entry(forces, 3 * follower.node + i) = 0;
    }
    if (!positions)
      continue;
    const Rotation& rotation = nodes.rotations[follower.rotation];
    const ArmDerivative derivative = compute_arm_derivative(
        get_quaternion(rotation, *positions), follower.arm);
    for (unsigned int i = 0; i < 3; ++i)
    {
      entry(forces, 3 * rotation.scalar()) +=
          derivative.by_scalar[i] * force[i];
      for (unsigned int j = 0; j < 3; ++j)
        entry(forces, 3 * rotation.vector + j) +=
            derivative.by_vector[3 * i + j] * force[i];
    }
  }
}

void collect_forces(const Nodes& nodes, const NodalVector* positions,
                    NodalVector& forces)
{
  collect_hanging_forces(nodes, forces);
  collect_bar_forces(nodes, positions, forces);
  collect_follower_forces(nodes, positions, forces);
}
} // namespace taut::fe
