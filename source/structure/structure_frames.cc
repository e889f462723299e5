#include <taut/base/exceptions.h>
#include <taut/fe/vector3.h>
#include <taut/structure/structure.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::structure
{
namespace
{
/// m (|X|^2 1 - X X^T): what a mass on an arm adds to a rotary inertia.
void add_arm_inertia(const double mass, const std::array<double, 3>& arm,
                     Tensor3& inertia)
{
  const double square = fe::dot(arm, arm);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      inertia[3 * i + j] += mass * ((i == j) * square - arm[i] * arm[j]);
}

void add_diagonal(const std::array<double, 3>& diagonal, Tensor3& inertia)
{
  for (unsigned int i = 0; i < 3; ++i)
    inertia[4 * i] += diagonal[i];
}
} // namespace

void Structure::make_frames()
{
  frames_ = std::make_unique<Frames>(device_, device_nodes_.frames, nodes());
  point_forces_ = std::make_unique<PointForces>(device_, mesh_, dof_handler_,
                                                device_nodes_);
  const std::size_t n = nodes().rotations.size();
  std::vector<Tensor3> inertia(n, Tensor3{}), damping(n, Tensor3{});
  frames_->add_rotary_inertia(inertia, damping);
  rotary_.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    rotary_[i] = {inertia[i], damping[i], nodes().rotations[i].length};
  for (unsigned int i = 0; i < device_.masses.size(); ++i)
    for (const auto& node :
         find_loaded_nodes(device_.masses[i].groups, i, device_.masses[i],
                           "Point mass", mesh_, dof_handler_, device_nodes_))
    {
      masses_.push_back(node);
      if (node.rotation)
        add_diagonal(device_.masses[i].rotary_inertia,
                     rotary_[*node.rotation].inertia);
    }
  const bool first =
      dealii::Utilities::MPI::this_mpi_process(communicator()) == 0;
  for (unsigned int b = 0; b < device_.bodies.size() && first; ++b)
    add_diagonal(device_.bodies[b].rotary_inertia,
                 rotary_[device_nodes_.frames.bodies[b].rotation].inertia);
  add_lumped_film_inertia();
  gauge_.assign(n, 0.);
  frames_->add_rotation_stiffness(gauge_);
  double film_stiffness = 0;
  for (const auto& film : device_.films)
    film_stiffness =
        std::max(film_stiffness,
                 film.thickness * material::shear_modulus(film.material));
  for (std::size_t i = 0; i < n; ++i)
  {
    for (auto* tensor : {&rotary_[i].inertia, &rotary_[i].damping})
      for (double& entry : *tensor)
        entry = sum(entry);
    gauge_[i] = sum(gauge_[i]) + film_stiffness;
  }
}

void Structure::add_lumped_film_inertia()
{
  // Inertia sees followers at their centres; the rest of theirs is lumped.
  auto ones = nodes().make_vector(), masses = nodes().make_vector();
  for (std::size_t i = 0; i < 3 * nodes().n_local; ++i)
    fe::entry(ones, i) = 1;
  fe::add_mass_product(*cells_, get_densities(), ones, masses);
  frames_->add_mass_product(false, ones, masses);
  for (const auto& follower : nodes().followers)
    add_arm_inertia(fe::entry(masses, 3 * follower.node), follower.arm,
                    rotary_[follower.rotation].inertia);
}

void Structure::add_frame_weight(const fe::NodalVector& gravity,
                                 fe::NodalVector& weight) const
{
  frames_->add_mass_product(false, gravity, weight);
  const auto add = [&](const fe::LocalNode node, const double mass)
  {
    for (unsigned int c = 0; c < 3; ++c)
      fe::entry(weight, 3 * node + c) +=
          mass * fe::entry(gravity, 3 * node + c);
  };
  for (unsigned int b = 0; b < device_.bodies.size(); ++b)
    if (const auto centre =
            nodes().local(device_nodes_.frames.bodies[b].centre);
        centre < nodes().n_owned)
      add(centre, device_.bodies[b].mass);
  for (const auto& loaded : masses_)
    add(loaded.node, device_.masses[loaded.entry].mass);
}

double Structure::compute_round_off_force() const
{
  // Ten units in the last place of each position.
  constexpr double relative = 10 * std::numeric_limits<double>::epsilon();
  return relative * compute_extent(mesh_) *
         std::sqrt(sum(frames_->compute_axial_spring_square()));
}

std::vector<std::vector<fe::LocalNode>> Structure::get_frame_elements() const
{
  std::vector<std::vector<fe::LocalNode>> elements;
  for (const auto& element : frames_->elements())
    if (element.assembled_here)
      elements.push_back(element.get_nodes(nodes()));
  return elements;
}

void Structure::add_point_masses(const double factor,
                                 fe::TangentMatrix& matrix) const
{
  const auto add = [&](const fe::LocalNode node, const double mass)
  {
    const double entry = factor * mass;
    const std::array<double, 9> block{entry, 0, 0, 0, entry, 0, 0, 0, entry};
    matrix.add_element({node}, block.data(), nullptr);
  };
  for (const auto& loaded : masses_)
    add(loaded.node, device_.masses[loaded.entry].mass);
  for (unsigned int b = 0; b < device_.bodies.size(); ++b)
    if (const auto centre =
            nodes().local(device_nodes_.frames.bodies[b].centre);
        centre < nodes().n_owned)
      add(centre, device_.bodies[b].mass);
}

void Structure::add_frame_masses(const bool damping,
                                 fe::TangentMatrix& matrix) const
{
  frames_->add_mass(damping, matrix);
  if (damping)
    return;
  add_point_masses(1, matrix);
  for_each_rotation(
      [&](const fe::Rotation& rotation, const RotaryInertia& inertia)
      {
        const double mean = inertia.mean();
        if (mean <= 0)
          throw BadInput("a frame without rotary inertia cannot move in time: "
                         "give its sections a density or a rotary inertia");
        std::array<double, 16> block{};
        for (unsigned int i = 0; i < 4; ++i)
          block[5 * i] = mean;
        add_rotation_block(rotation, block, matrix);
      });
}

void Structure::add_frame_tangent(const fe::TangentRequest& request)
{
  const double alpha = request.inertia ? request.alpha : 0.;
  frames_->add_stiffness(tangent_loads_, tangent_positions_, alpha,
                         alpha * alpha, !request.inertia && !request.exact,
                         *tangent_);
  point_forces_->add_stiffness(tangent_loads_, tangent_positions_, *tangent_);
  add_point_masses(alpha * alpha, *tangent_);
  for_each_rotation(
      [&](const fe::Rotation& rotation, const RotaryInertia& inertia)
      {
        const Quaternion q = fe::get_quaternion(rotation, tangent_positions_);
        Matrix4 block{};
        if (request.inertia)
          block = compute_mass_tangent(inertia, q, alpha);
        else
        {
          const double square =
              q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
          const double gauge = gauge_[&inertia - rotary_.data()] / square;
          for (unsigned int i = 0; i < 4; ++i)
            for (unsigned int j = 0; j < 4; ++j)
              block[4 * i + j] = gauge * q[i] * q[j];
        }
        add_rotation_block(rotation, block, *tangent_);
      });
}

void Structure::add_follower_tangent(fe::TangentMatrix& matrix) const
{
  for (const auto& follower : nodes().followers)
  {
    const fe::Rotation& rotation = nodes().rotations[follower.rotation];
    std::array<double, 3> force;
    for (unsigned int c = 0; c < 3; ++c)
      force[c] = -turned_forces_[3 * follower.node + c];
    add_rotation_block(rotation,
                       fe::compute_arm_curvature(
                           fe::get_quaternion(rotation, tangent_positions_),
                           follower.arm, force),
                       matrix);
  }
}

bool Structure::has_drag() const
{
  return device_.environment.air_drag > 0 ||
         std::any_of(device_.frames.begin(), device_.frames.end(),
                     [](const Frame& frame) { return frame.mass_damping > 0; });
}

bool Structure::has_frame_damping() const
{
  return std::any_of(device_.frames.begin(), device_.frames.end(),
                     [](const Frame& frame) {
                       return frame.mass_damping > 0 ||
                              frame.stiffness_damping > 0;
                     });
}

Structure::Damping Structure::compute_frame_damping(const LoadState& loads,
                                                    const double* v)
{
  auto resisting = nodes().make_vector();
  frames_->add_damping(loads, positions_, compute_velocities(loads, v),
                       resisting);
  fe::collect_forces(nodes(), &positions_, resisting);
  resisting.compress(dealii::VectorOperation::add);
  Damping damping{std::vector<double>(n_free()), 0.};
  restrict(resisting, damping.forces.data());
  for_each_rotation(
      [&](const fe::Rotation& rotation, const RotaryInertia& inertia)
      {
        const Quaternion torque = multiply_free(
            compute_tangential(inertia.damping,
                               fe::get_quaternion(rotation, positions_)),
            get_free_parts(rotation), get_free_quaternion(rotation, v));
        Quaternion force = get_free_quaternion(rotation, damping.forces.data());
        for (unsigned int i = 0; i < 4; ++i)
          force[i] += torque[i];
        set_free_quaternion(rotation, force, damping.forces.data());
      });
  for (std::size_t i = 0; i < n_free(); ++i)
    damping.power += damping.forces[i] * v[i];
  return damping;
}

void Structure::add_frame_damping_product(const double* rates, double* result)
{
  auto nodal = nodes().make_vector(), resisting = nodes().make_vector();
  prolong(rates, nodal);
  nodal.update_ghost_values();
  fe::distribute_change(nodes(), &tangent_positions_, nodal);
  frames_->add_damping(tangent_loads_, tangent_positions_, nodal, resisting);
  fe::collect_forces(nodes(), &tangent_positions_, resisting);
  resisting.compress(dealii::VectorOperation::add);
  for (std::size_t i = 0; i < free_.size(); ++i)
    result[i] += fe::entry(resisting, free_[i]);
  for_each_rotation(
      [&](const fe::Rotation& rotation, const RotaryInertia& inertia)
      {
        const Quaternion torque = multiply_free(
            compute_tangential(
                inertia.damping,
                fe::get_quaternion(rotation, tangent_positions_)),
            get_free_parts(rotation), get_free_quaternion(rotation, rates));
        Quaternion sum = get_free_quaternion(rotation, result);
        for (unsigned int i = 0; i < 4; ++i)
          sum[i] += torque[i];
        set_free_quaternion(rotation, sum, result);
      });
}

void Structure::forget_linearisation()
{
  frames_->forget_linearisation();
}

void Structure::set_rest_path(const double stiffening,
                              const std::array<double, 3>& load)
{
  frames_->set_stiffening(stiffening);
  rest_load_ = load;
}

} // namespace taut::structure
