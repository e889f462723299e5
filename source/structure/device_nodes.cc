#include <taut/base/exceptions.h>
#include <taut/fe/vector3.h>
#include <taut/structure/device_nodes.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "device_nodes_supports.h"

namespace taut::structure
{
namespace
{
using Vector3 = std::array<double, 3>;
using DoFHandler = dealii::DoFHandler<2, 3>;

/// Numbers the nodes: those of the film, then, on the last rank, those of the
/// frames and two of each bar.
void number_nodes(const Device& device, const DoFHandler& dof_handler,
                  const NodePositions& positions, const FrameNodes& frames,
                  fe::Nodes& nodes)
{
  const MPI_Comm comm = dof_handler.get_communicator();
  const auto& owned = dof_handler.locally_owned_dofs();
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
  const unsigned int n_film = dof_handler.n_dofs();
  const auto shared = frames.get_shared_film_nodes(n_film);
  relevant.add_indices(shared.begin(), shared.end());
  const unsigned int n_extra = frames.extras.size() + 2 * device.bars.size();
  nodes.first_extra = n_film;
  nodes.n_global = n_film + n_extra;
  const bool last = dealii::Utilities::MPI::this_mpi_process(comm) + 1 ==
                    dealii::Utilities::MPI::n_mpi_processes(comm);
  nodes.first_owned = owned.n_elements() > 0 ? owned.nth_index_in_set(0)
                      : last                 ? n_film
                                             : 0;
  nodes.n_owned = owned.n_elements() + (last ? n_extra : 0);
  for (const auto node : relevant)
    if (!owned.is_element(node))
      nodes.ghosts.push_back(node);
  if (!last)
    for (unsigned int i = 0; i < n_extra; ++i)
      nodes.ghosts.push_back(n_film + i);
  nodes.n_local = nodes.n_owned + nodes.ghosts.size();

  dealii::IndexSet owned_entries(3 * nodes.n_global),
      ghost_entries(3 * nodes.n_global);
  owned_entries.add_range(3 * nodes.first_owned,
                          3 * (nodes.first_owned + nodes.n_owned));
  for (const auto ghost : nodes.ghosts)
    ghost_entries.add_range(3 * ghost, 3 * ghost + 3);
  nodes.partitioner = std::make_shared<dealii::Utilities::MPI::Partitioner>(
      owned_entries, ghost_entries, comm);

  nodes.mesh_position.assign(nodes.n_local, {});
  nodes.held.assign(nodes.n_local, 0);
  nodes.dependent.assign(nodes.n_local, false);
  for (unsigned int place = 0; place < frames.nodes.size(); ++place)
    if (frames.nodes[place].position < n_film)
      nodes.mesh_position[nodes.local(frames.nodes[place].position)] =
          frames.mesh.places[place];
  for (const auto& [node, x] : positions)
    nodes.mesh_position[nodes.local(node)] = {x[0], x[1], x[2]};
  for (unsigned int i = 0; i < frames.extras.size(); ++i)
  {
    const fe::LocalNode node = nodes.local(n_film + i);
    nodes.mesh_position[node] = frames.extras[i].mesh_position;
    nodes.held[node] = frames.extras[i].held;
  }
}

/// Centre and director of the bar, gathered over all ranks.
fe::Bar make_bar(const RigidBar& description, const double length_stiffness,
                 const std::vector<fe::GlobalNode>& line, const MPI_Comm comm,
                 const unsigned int index, fe::Nodes& nodes)
{
  std::vector<Vector3> points;
  for (const auto node : line)
    points.push_back(nodes.mesh_position[nodes.local(node)]);
  std::vector<Vector3> all;
  for (const auto& part : dealii::Utilities::MPI::all_gather(comm, points))
    all.insert(all.end(), part.begin(), part.end());
  if (all.size() < 2)
    refuse(description, "its line has no length");
  const auto farthest_from = [&](const Vector3& from)
  {
    return *std::max_element(all.begin(), all.end(),
                             [&](const Vector3& a, const Vector3& b) {
                               return fe::compute_distance(a, from) <
                                      fe::compute_distance(b, from);
                             });
  };
  Vector3 end = farthest_from(all.front());
  Vector3 begin = farthest_from(end);
  // Which end comes first must not depend on the partition.
  if (end < begin)
    std::swap(begin, end);
  fe::Bar bar;
  bar.half_length = 0.5 * fe::compute_distance(begin, end);
  bar.centre = nodes.local(nodes.n_global - 2 * (index + 1));
  bar.director = bar.centre + 1;
  Vector3& centre = nodes.mesh_position[bar.centre];
  Vector3& director = nodes.mesh_position[bar.director];
  for (unsigned int i = 0; i < 3; ++i)
  {
    centre[i] = 0.5 * (begin[i] + end[i]);
    director[i] = 0.5 * (end[i] - begin[i]);
  }
  for (const auto& x : all)
  {
    const double s =
        ((x[0] - centre[0]) * director[0] + (x[1] - centre[1]) * director[1] +
         (x[2] - centre[2]) * director[2]) /
        (bar.half_length * bar.half_length);
    const double off = fe::compute_distance(x, {centre[0] + s * director[0],
                                                centre[1] + s * director[1],
                                                centre[2] + s * director[2]});
    if (off > 1e-8 * bar.half_length)
      refuse(description, "a rigid bar must be a straight line; this one is " +
                              std::to_string(off) + " m off");
  }
  bar.length_stiffness = length_stiffness;
  bar.mass = description.mass;
  bar.rotary_inertia = description.rotary_inertia.value_or(
      description.mass * bar.half_length * bar.half_length / 3);
  return bar;
}

/// Stiffness (N/m) that holds the length of directors: well above the film's.
double make_length_stiffness(const Device& device)
{
  double stiffness = 0;
  for (const auto& film : device.films)
    stiffness = std::max(stiffness, material::shear_modulus(film.material) *
                                        film.thickness);
  return 1e4 * stiffness;
}

std::uint8_t make_mask(const std::array<bool, 3>& components)
{
  return components[0] | components[1] << 1 | components[2] << 2;
}

/// What all ranks must agree on about a node, packed into one number.
void synchronise(fe::Nodes& nodes, std::vector<int>& bar_of)
{
  auto packed = nodes.make_vector();
  for (fe::LocalNode node = 0; node < nodes.n_owned; ++node)
    fe::entry(packed, 3 * node) = 8. * (bar_of[node] + 1) + nodes.held[node];
  packed.update_ghost_values();
  for (fe::LocalNode node = nodes.n_owned; node < nodes.n_local; ++node)
  {
    const int value = std::lround(fe::entry(packed, 3 * node));
    nodes.held[node] = value % 8;
    bar_of[node] = value / 8 - 1;
  }
}

void add_hanging_nodes(const DoFHandler& dof_handler, fe::Nodes& nodes,
                       const std::vector<int>& bar_of)
{
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
  dealii::AffineConstraints<double> constraints(relevant);
  dealii::DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  constraints.close();
  for (const auto& line : constraints.get_lines())
  {
    const fe::LocalNode node = nodes.local(line.index);
    // A node on a bar, on an arm or held by a support already has its motion.
    if (bar_of[node] >= 0 || nodes.held[node] == 7 || nodes.dependent[node])
      continue;
    fe::HangingNode hanging{node, {}};
    // An element below the order of the mesh has straighter edges than it: the
    // node starts on the edge of its neighbour, or the film would be strained.
    Vector3 start{};
    for (const auto& [master, weight] : line.entries)
    {
      hanging.masters.push_back({nodes.local(master), weight});
      for (unsigned int c = 0; c < 3; ++c)
        start[c] += weight * nodes.mesh_position[nodes.local(master)][c];
    }
    nodes.mesh_position[node] = start;
    nodes.hanging.push_back(hanging);
    nodes.dependent[node] = true;
  }
}

/// Refuses frames whose film is refined on one side only: a beam cannot follow
/// a node that lies between others.
void refuse_hanging_frames(const Device& device, const FrameNodes& frames,
                           const fe::Nodes& nodes)
{
  std::set<fe::GlobalNode> hanging;
  for (const auto& node : nodes.hanging)
    hanging.insert(nodes.global(node.node));
  int wrong = -1;
  for (const auto& node : frames.nodes)
    if (hanging.count(node.position) > 0)
      wrong = node.rotations.begin()->first;
  wrong = dealii::Utilities::MPI::max(
      wrong, nodes.partitioner->get_mpi_communicator());
  if (wrong >= 0)
    refuse(device.frames[wrong],
           "the film is refined on one side of the frame only: refine both "
           "sides, or all cells by Mesh/Refinements");
}

void add_bar_nodes(const std::vector<int>& bar_of, fe::Nodes& nodes)
{
  for (fe::LocalNode node = 0; node < nodes.n_local; ++node)
    if (bar_of[node] >= 0)
    {
      const fe::Bar& bar = nodes.bars[bar_of[node]];
      const Vector3& c = nodes.mesh_position[bar.centre];
      const Vector3& d = nodes.mesh_position[bar.director];
      const Vector3& x = nodes.mesh_position[node];
      double s = 0;
      for (unsigned int i = 0; i < 3; ++i)
        s += (x[i] - c[i]) * d[i] / (bar.half_length * bar.half_length);
      nodes.on_bar.push_back({node, unsigned(bar_of[node]), s});
      nodes.dependent[node] = true;
      nodes.held[node] = 0;
    }
}
} // namespace

DeviceNodes make_device_nodes(const Device& device, const fe::MeshData& mesh,
                              const DoFHandler& dof_handler)
{
  DeviceNodes result;
  fe::Nodes& nodes = result.nodes;
  const auto positions = fe::compute_reference_positions(dof_handler, mesh);
  result.frames = make_frame_nodes(device, mesh, dof_handler, positions);
  number_nodes(device, dof_handler, positions, result.frames, nodes);
  add_frame_nodes(result.frames, nodes);
  std::vector<int> bar_of(nodes.n_local, -1);
  const double length_stiffness = make_length_stiffness(device);
  for (unsigned int b = 0; b < device.bars.size(); ++b)
  {
    const auto line = find_group_nodes(device.bars[b].groups, mesh, dof_handler,
                                       device.bars[b], "Bar");
    nodes.bars.push_back(make_bar(device.bars[b], length_stiffness, line,
                                  dof_handler.get_communicator(), b, nodes));
    for (const auto node : line)
    {
      int& bar = bar_of[nodes.local(node)];
      if (bar >= 0)
        refuse(device.bars[b],
               "it shares a node with the bar '" + device.bars[bar].name + "'");
      if (nodes.dependent[nodes.local(node)])
        refuse(device.bars[b], "it shares a node with a frame or rigid body "
                               "that moves the film on an arm");
      bar = b;
    }
  }
  if (mesh.only_lines)
    for (fe::LocalNode node = 0; node < nodes.n_local; ++node)
      if (nodes.global(node) < nodes.first_extra)
        nodes.held[node] = 7;
  apply_supports(device, mesh, dof_handler, bar_of, result);
  synchronise(nodes, bar_of);
  add_bar_nodes(bar_of, nodes);
  add_hanging_nodes(dof_handler, nodes, bar_of);
  refuse_hanging_frames(device, result.frames, nodes);
  for (unsigned int b = 0; b < device.bars.size(); ++b)
  {
    auto fixed = device.bars[b].free;
    for (auto& component : fixed)
      component = !component;
    nodes.held[nodes.bars[b].centre] = make_mask(fixed);
    nodes.held[nodes.bars[b].director] = device.bars[b].rotates ? 0 : 7;
  }
  return result;
}
} // namespace taut::structure
