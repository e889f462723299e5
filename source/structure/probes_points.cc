#include <taut/base/exceptions.h>
#include <taut/fe/vector3.h>
#include <taut/structure/probes.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::structure
{
namespace
{
using Kind = Probe::Kind;
using fe::Coordinates;

/// The values of all ranks together.
Coordinates sum(const Coordinates& values, const MPI_Comm communicator)
{
  Coordinates total{};
  dealii::Utilities::MPI::sum(
      dealii::ArrayView<const double>(values.data(), values.size()),
      communicator, dealii::ArrayView<double>(total.data(), total.size()));
  return total;
}

/// By local node, whether it has a place in space that a probe can mean: not
/// the directors of bars and the rotations, nor the nodes of a surface that is
/// there only because the triangulation cannot be empty.
std::vector<bool> find_nodes_in_space(const Structure& structure)
{
  const fe::Nodes& nodes = structure.nodes();
  std::vector<bool> in_space(nodes.n_local, true);
  for (const auto& bar : nodes.bars)
    in_space[bar.centre] = in_space[bar.director] = false;
  for (const auto& rotation : nodes.rotations)
    in_space[rotation.vector] = in_space[rotation.scalar()] = false;
  if (structure.mesh().only_lines)
    for (fe::LocalNode i = 0; i < nodes.n_local; ++i)
      in_space[i] = in_space[i] && nodes.global(i) >= nodes.first_extra;
  return in_space;
}
} // namespace

Coordinates Probes::find_place(const Probe& probe,
                               const std::string& group) const
{
  std::vector<Coordinates> points;
  try
  {
    points = fe::get_group_points(system_.structure().mesh(), group);
  }
  catch (const BadInput& error)
  {
    refuse(probe, error.message());
  }
  if (points.size() != 1)
    refuse(probe, "the group '" + group + "' has " +
                      std::to_string(points.size()) +
                      " points; a probe needs one");
  return points.front();
}

Probes::Point Probes::find_point(const Probe& probe,
                                 const std::string& group) const
{
  const Coordinates place =
      group.empty() ? probe.point : find_place(probe, group);
  const fe::Nodes& nodes = system_.structure().nodes();
  const FrameNodes& frames = system_.structure().device_nodes().frames;
  const auto of_frame = frames.mesh.find_place(place);
  if (!of_frame)
    return find_node(probe, place);
  const FrameNode& node = frames.nodes[*of_frame];
  const fe::LocalNode local = nodes.local(node.position);
  Point point{std::nullopt, nodes.mesh_position[local],
              node.rotations.begin()->second};
  if (local < nodes.n_owned)
    point.node = local;
  return point;
}

Probes::Point Probes::find_node(const Probe& probe,
                                const Coordinates& place) const
{
  const Structure& structure = system_.structure();
  const fe::Nodes& nodes = structure.nodes();
  const auto in_space = find_nodes_in_space(structure);
  double nearest = std::numeric_limits<double>::infinity();
  fe::LocalNode node = 0;
  for (fe::LocalNode i = 0; i < nodes.n_owned; ++i)
  {
    const double distance = fe::compute_distance(nodes.mesh_position[i], place);
    if (in_space[i] && distance < nearest)
    {
      nearest = distance;
      node = i;
    }
  }
  const auto all =
      dealii::Utilities::MPI::all_gather(structure.communicator(), nearest);
  const auto owner = std::min_element(all.begin(), all.end());
  if (*owner > 1e-6 * compute_extent(structure.mesh()))
    refuse(probe, "no node of the mesh lies at its point; the nearest is " +
                      std::to_string(*owner) +
                      " m away: put a point of the "
                      "geometry there");
  Point point{std::nullopt, {}, std::nullopt};
  if (owner - all.begin() ==
      dealii::Utilities::MPI::this_mpi_process(structure.communicator()))
    point.node = node;
  if (point.node)
    point.mesh_position = nodes.mesh_position[node];
  point.mesh_position = sum(point.mesh_position, structure.communicator());
  return point;
}

Coordinates Probes::get_vector(const Point& point,
                               const fe::NodalVector& values) const
{
  Coordinates vector{};
  if (point.node)
    for (unsigned int c = 0; c < 3; ++c)
      vector[c] = fe::entry(values, 3 * *point.node + c);
  return sum(vector, system_.structure().communicator());
}

double Probes::evaluate_point(const std::size_t probe,
                              const fe::NodalVector& positions,
                              const fe::NodalVector* velocities) const
{
  const Probe& description = descriptions_[probe];
  const Point& point = points_[probe].front();
  const unsigned int c = description.component;
  if (description.kind == Kind::velocity)
    return get_vector(point, *velocities)[c];
  const Coordinates x = get_vector(point, positions);
  if (description.kind == Kind::distance)
    return fe::compute_distance(x,
                                get_vector(points_[probe].back(), positions));
  return description.kind == Kind::position ? x[c]
                                            : x[c] - point.mesh_position[c];
}

double Probes::evaluate_rotation(const std::size_t probe,
                                 const fe::NodalVector& positions) const
{
  const Probe& description = descriptions_[probe];
  Vector3 axis{};
  axis[description.component] = 1;
  // Every rank sees all rotations.
  const auto get = [&](const Point& point)
  {
    return fe::get_quaternion(
        system_.structure().nodes().rotations[*point.rotation], positions);
  };
  const Quaternion first = get(points_[probe].front());
  if (description.kind == Kind::rotation)
    return compute_angle(first, axis);
  return 0.5 *
         compute_angle(multiply(conjugate(first), get(points_[probe].back())),
                       axis);
}
} // namespace taut::structure
