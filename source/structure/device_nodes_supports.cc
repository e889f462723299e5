#include "device_nodes_supports.h"

#include <taut/base/exceptions.h>
#include <taut/fe/vector3.h>

#include <deal.II/base/function_parser.h>

#include <algorithm>
#include <cmath>

namespace taut::structure
{
namespace
{
using Vector3 = std::array<double, 3>;
using DoFHandler = dealii::DoFHandler<2, 3>;

class ShapeFunctions
{
public:
  explicit ShapeFunctions(const Support& support)
  {
    try
    {
      const std::vector<std::string> shape(support.shape.begin(),
                                           support.shape.end());
      const std::map<std::string, double> constants{{"pi", M_PI}};
      parser_.initialize("x,y,z", shape, constants);
      parser_.value(dealii::Point<3>(), 0);
    }
    catch (const std::exception&)
    {
      refuse(support, "the displacement cannot be read: write three "
                      "expressions of x, y and z");
    }
  }
  double value(const Vector3& x, const unsigned int component) const
  {
    return parser_.value(dealii::Point<3>(x[0], x[1], x[2]), component);
  }

private:
  dealii::FunctionParser<3> parser_{3};
};

/// Every prescribed component, by 3 node + component.
using Prescribed = std::map<std::size_t, HeldComponent>;

/// Refuses a second support that moves a component in another way.
void check_same_motion(const HeldComponent& first, const HeldComponent& second,
                       const Vector3& x, const Device& device)
{
  const Support& other = device.supports[first.support];
  const Support& support = device.supports[second.support];
  const auto get_shape = [](const HeldComponent& held, const Signal& amplitude)
  {
    const bool rests = amplitude.is_constant() && amplitude.value(0) == 0;
    return rests ? 0. : held.shape;
  };
  const double a = get_shape(first, other.amplitude);
  const double b = get_shape(second, support.amplitude);
  // Round-off of an expression that vanishes here.
  const double tolerance =
      1e-12 * std::max({std::abs(a), std::abs(b), fe::compute_distance(x, {})});
  const bool rests = std::abs(a) <= tolerance && std::abs(b) <= tolerance;
  if (std::abs(a - b) > tolerance ||
      (!rests && support.amplitude.to_text() != other.amplitude.to_text()))
    refuse(support, std::string("it moves component ") +
                        "xyz"[second.component] +
                        " of a node otherwise than '" + other.name +
                        "' does: supports that meet must agree there");
}

/// Notes that a support holds a component of a node.
void hold(const fe::LocalNode node, const unsigned int component,
          const unsigned int support, const double shape, const Device& device,
          Prescribed& prescribed, DeviceNodes& result)
{
  fe::Nodes& nodes = result.nodes;
  const HeldComponent held{node, component, support, shape};
  const auto [first, is_new] =
      prescribed.try_emplace(3 * node + component, held);
  if (!is_new)
  {
    check_same_motion(first->second, held, nodes.mesh_position[node], device);
    return;
  }
  nodes.held[node] |= 1 << component;
  if (shape != 0)
    result.moving.push_back(held);
}

void apply_support(const Support& support, const unsigned int index,
                   const std::vector<fe::GlobalNode>& group,
                   const std::vector<int>& bar_of, const Device& device,
                   Prescribed& prescribed, DeviceNodes& result)
{
  fe::Nodes& nodes = result.nodes;
  const ShapeFunctions shape(support);
  for (const auto global : group)
  {
    const fe::LocalNode node = nodes.local(global);
    // Its frame or body is held in its place.
    if (nodes.dependent[node])
      continue;
    const Vector3& x = nodes.mesh_position[node];
    if (bar_of[node] >= 0)
    {
      const RigidBar& bar = device.bars[bar_of[node]];
      for (unsigned int c = 0; c < 3; ++c)
        if (support.held[c] && (bar.free[c] || bar.rotates))
          refuse(support, std::string("it holds component ") + "xyz"[c] +
                              " of a node of the bar '" + bar.name +
                              "', which is free to move there: end the bar's "
                              "line before the support, or guide the bar");
    }
    for (unsigned int c = 0; c < 3; ++c)
      if (support.held[c])
        hold(node, c, index, shape.value(x, c), device, prescribed, result);
    if (node < nodes.n_owned)
      result.of_support[index].push_back(node);
  }
}

/// Holds a rotation: no component of its vector, or those that are named.
void hold_rotation(const Support& support, const unsigned int index,
                   const fe::Rotation& rotation, const Device& device,
                   Prescribed& prescribed, DeviceNodes& result)
{
  for (unsigned int c = 0; c < 3; ++c)
    if (support.held_rotations[c])
      hold(rotation.vector, c, index, 0, device, prescribed, result);
  if (support.held_rotations == std::array<bool, 3>{{true, true, true}})
    hold(rotation.scalar(), 0, index, 0, device, prescribed, result);
}

/// A support on frames; where a rigid body has a node of the support, its
/// centre is held, which is the same only if it cannot turn.
void apply_frame_support(const Support& support, const unsigned int index,
                         const fe::MeshData& mesh, const Device& device,
                         Prescribed& prescribed, DeviceNodes& result)
{
  fe::Nodes& nodes = result.nodes;
  const FrameNodes& frames = result.frames;
  const ShapeFunctions shape(support);
  const bool turns =
      support.held_rotations != std::array<bool, 3>{{true, true, true}};
  for (const auto place : find_group_places(support.groups, frames.mesh, mesh))
  {
    const FrameNode& frame_node = frames.nodes[place];
    fe::LocalNode node = nodes.local(frame_node.position);
    if (frame_node.body)
    {
      const fe::LocalNode centre =
          nodes.local(frames.bodies[*frame_node.body].centre);
      if (turns && (support.held[0] || support.held[1] || support.held[2]) &&
          fe::compute_distance(nodes.mesh_position[centre],
                               nodes.mesh_position[node]) >
              frames.mesh.tolerance)
        refuse(support, "it holds a point of the rigid body '" +
                            device.bodies[*frame_node.body].name +
                            "', which may turn about it: put the body's centre "
                            "there or hold its rotations");
      node = centre;
    }
    // A node of the film is held with the film.
    if (node >= nodes.n_owned || nodes.global(node) >= nodes.first_extra ||
        support.target == Support::Target::frame)
      for (unsigned int c = 0; c < 3; ++c)
        if (support.held[c])
          hold(node, c, index, shape.value(nodes.mesh_position[node], c),
               device, prescribed, result);
    if (node < nodes.n_owned && nodes.global(node) >= nodes.first_extra)
      result.of_support[index].push_back(node);
    for (const auto& [frame, rotation] : frame_node.rotations)
      hold_rotation(support, index, nodes.rotations[rotation], device,
                    prescribed, result);
  }
}

} // namespace

/// Refuses a support that holds nothing of what it is meant for.
void apply_supports(const Device& device, const fe::MeshData& mesh,
                    const DoFHandler& dof_handler,
                    const std::vector<int>& bar_of, DeviceNodes& result)
{
  Prescribed prescribed;
  result.of_support.resize(device.supports.size());
  for (unsigned int s = 0; s < device.supports.size(); ++s)
  {
    const Support& support = device.supports[s];
    const auto film =
        find_group_nodes(support.groups, mesh, dof_handler, support, "Support");
    if (support.target != Support::Target::frame)
      apply_support(support, s, film, bar_of, device, prescribed, result);
    if (support.target != Support::Target::film)
      apply_frame_support(support, s, mesh, device, prescribed, result);
    if (support.target == Support::Target::frame &&
        find_group_places(support.groups, result.frames.mesh, mesh).empty())
      refuse(support, "no node of a frame is in its groups");
  }
}
} // namespace taut::structure
