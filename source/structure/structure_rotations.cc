#include <taut/structure/structure.h>

// What the quaternions of frames and bodies need in time: accelerations instead
// of forces, and vectors that turn with the nodes.
namespace taut::structure
{
std::array<bool, 4>
Structure::get_free_parts(const fe::Rotation& rotation) const
{
  const auto is_free = [&](const fe::LocalNode node, const unsigned int c)
  { return free_index_[3 * node + c] >= 0; };
  return {is_free(rotation.scalar(), 0), is_free(rotation.vector, 0),
          is_free(rotation.vector, 1), is_free(rotation.vector, 2)};
}

Quaternion Structure::get_free_quaternion(const fe::Rotation& rotation,
                                          const double* free) const
{
  const auto get = [&](const fe::LocalNode node, const unsigned int c)
  {
    const int index = free_index_[3 * node + c];
    return index >= 0 ? free[index] : 0.;
  };
  return {get(rotation.scalar(), 0), get(rotation.vector, 0),
          get(rotation.vector, 1), get(rotation.vector, 2)};
}

void Structure::set_free_quaternion(const fe::Rotation& rotation,
                                    const Quaternion& q, double* free) const
{
  const auto set =
      [&](const fe::LocalNode node, const unsigned int c, const double value)
  {
    if (const int index = free_index_[3 * node + c]; index >= 0)
      free[index] = value;
  };
  set(rotation.scalar(), 0, q[0]);
  for (unsigned int c = 0; c < 3; ++c)
    set(rotation.vector, c, q[1 + c]);
}

double Structure::compute_rotary_energy(const double* v) const
{
  double energy = 0;
  for_each_rotation(
      [&](const fe::Rotation& rotation, const RotaryInertia& inertia)
      {
        const Quaternion rate = get_free_quaternion(rotation, v);
        energy += compute_kinetic_energy(
            inertia, fe::get_quaternion(rotation, positions_), rate);
        // The constant mass matrix has counted this instead.
        for (const double component : rate)
          energy -= 0.5 * inertia.mean() * component * component;
      });
  return energy;
}

void Structure::turn_forces_into_accelerations(const double* v,
                                               double* forces) const
{
  for_each_rotation(
      [&](const fe::Rotation& rotation, const RotaryInertia& inertia)
      {
        Quaternion acceleration =
            compute_acceleration(inertia, get_free_parts(rotation),
                                 fe::get_quaternion(rotation, positions_),
                                 get_free_quaternion(rotation, v),
                                 get_free_quaternion(rotation, forces));
        for (double& component : acceleration)
          component *= inertia.mean();
        set_free_quaternion(rotation, acceleration, forces);
      });
}

void Structure::turn_accelerations_into_forces(double* residual) const
{
  for_each_rotation(
      [&](const fe::Rotation& rotation, const RotaryInertia& inertia)
      {
        Quaternion force = multiply_free(
            compute_mass(inertia, fe::get_quaternion(rotation, positions_)),
            get_free_parts(rotation), get_free_quaternion(rotation, residual));
        for (double& component : force)
          component /= inertia.mean();
        set_free_quaternion(rotation, force, residual);
      });
}

void Structure::turn_with_frames(const bool forward, double* vector) const
{
  const auto get_turn = [&](const fe::Rotation& rotation)
  {
    const Quaternion then = fe::get_quaternion(rotation, tangent_positions_);
    const Quaternion now = fe::get_quaternion(rotation, positions_);
    const Quaternion turn = forward ? taut::multiply(now, conjugate(then))
                                    : taut::multiply(then, conjugate(now));
    const double size = length(turn);
    return Quaternion{turn[0] / size, turn[1] / size, turn[2] / size,
                      turn[3] / size};
  };
  const auto turn_node = [&](const fe::LocalNode node, const Quaternion& turn)
  {
    if (node >= nodes().n_owned || nodes().dependent[node])
      return;
    Vector3 value{};
    for (unsigned int c = 0; c < 3; ++c)
      if (const int index = free_index_[3 * node + c]; index >= 0)
        value[c] = vector[index];
    value = rotate(turn, value);
    for (unsigned int c = 0; c < 3; ++c)
      if (const int index = free_index_[3 * node + c]; index >= 0)
        vector[index] = value[c];
  };
  const FrameNodes& frames = device_nodes_.frames;
  for (const auto& node : frames.nodes)
    turn_node(nodes().local(node.position),
              get_turn(nodes().rotations[node.rotations.begin()->second]));
  for (const auto& body : frames.bodies)
    turn_node(nodes().local(body.centre),
              get_turn(nodes().rotations[body.rotation]));
  for_each_rotation(
      [&](const fe::Rotation& rotation, const RotaryInertia&)
      {
        set_free_quaternion(
            rotation,
            taut::multiply(get_turn(rotation),
                           get_free_quaternion(rotation, vector)),
            vector);
      });
}

void Structure::normalise_rotations(double* u) const
{
  for_each_rotation(
      [&](const fe::Rotation& rotation, const RotaryInertia&)
      {
        // Displacements in u: the scalar part starts at the length.
        Quaternion q = get_free_quaternion(rotation, u);
        q[0] += rotation.length;
        const double factor = rotation.length / length(q);
        for (double& component : q)
          component *= factor;
        q[0] -= rotation.length;
        set_free_quaternion(rotation, q, u);
      });
}
} // namespace taut::structure
