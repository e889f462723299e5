#include <taut/base/exceptions.h>
#include <taut/structure/device_nodes.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace taut::structure
{
namespace
{
using Vector3 = std::array<double, 3>;
using Positions = std::map<dealii::types::global_dof_index, dealii::Point<3>>;
using DoFHandler = dealii::DoFHandler<2, 3>;

double distance(const Vector3& a, const Vector3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Numbers the nodes: those of the film, then two of each bar on the last rank.
void number_nodes(const Device& device, const DoFHandler& dof_handler,
                  const Positions& positions, fe::Nodes& nodes)
{
  const MPI_Comm comm = dof_handler.get_communicator();
  const auto& owned = dof_handler.locally_owned_dofs();
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
  const unsigned int n_film = dof_handler.n_dofs();
  const unsigned int n_bars = 2 * device.bars.size();
  nodes.n_global = n_film + n_bars;
  const bool last = dealii::Utilities::MPI::this_mpi_process(comm) + 1 ==
                    dealii::Utilities::MPI::n_mpi_processes(comm);
  nodes.first_owned = owned.n_elements() > 0 ? owned.nth_index_in_set(0)
                      : last                 ? n_film
                                             : 0;
  nodes.n_owned = owned.n_elements() + (last ? n_bars : 0);
  for (const auto node : relevant)
    if (!owned.is_element(node))
      nodes.ghosts.push_back(node);
  if (!last)
    for (unsigned int i = 0; i < n_bars; ++i)
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
  for (const auto& [node, x] : positions)
    nodes.mesh_position[nodes.local(node)] = {x[0], x[1], x[2]};
}

[[noreturn]] void refuse(const Named& entry, const std::string& message)
{
  throw BadInput(message, "", entry.source_line, entry.name);
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
                             [&](const Vector3& a, const Vector3& b)
                             { return distance(a, from) < distance(b, from); });
  };
  Vector3 end = farthest_from(all.front());
  Vector3 begin = farthest_from(end);
  // Which end comes first must not depend on the partition.
  if (end < begin)
    std::swap(begin, end);
  fe::Bar bar;
  bar.half_length = 0.5 * distance(begin, end);
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
    const double off =
        distance(x, {centre[0] + s * director[0], centre[1] + s * director[1],
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
      1e-12 * std::max({std::abs(a), std::abs(b), distance(x, {})});
  const bool rests = std::abs(a) <= tolerance && std::abs(b) <= tolerance;
  if (std::abs(a - b) > tolerance ||
      (!rests && support.amplitude.to_text() != other.amplitude.to_text()))
    refuse(support, std::string("it moves component ") +
                        "xyz"[second.component] +
                        " of a node otherwise than '" + other.name +
                        "' does: supports that meet must agree there");
}

void apply_support(const Support& support, const unsigned int index,
                   const std::vector<fe::GlobalNode>& group,
                   const std::vector<int>& bar_of, const Device& device,
                   Prescribed& prescribed, DeviceNodes& result)
{
  fe::Nodes& nodes = result.nodes;
  const ShapeFunctions shape(support);
  result.of_support.emplace_back();
  for (const auto global : group)
  {
    const fe::LocalNode node = nodes.local(global);
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
      {
        const HeldComponent held{node, c, index, shape.value(x, c)};
        const auto [first, is_new] = prescribed.try_emplace(3 * node + c, held);
        if (!is_new)
        {
          check_same_motion(first->second, held, x, device);
          continue;
        }
        nodes.held[node] |= 1 << c;
        if (held.shape != 0)
          result.moving.push_back(held);
      }
    if (node < nodes.n_owned)
      result.of_support.back().push_back(node);
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
    // A node on a bar or held by a support already has its motion.
    if (bar_of[node] >= 0 || nodes.held[node] == 7)
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
  number_nodes(device, dof_handler,
               fe::compute_reference_positions(dof_handler, mesh), nodes);
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
      bar = b;
    }
  }
  Prescribed prescribed;
  for (unsigned int s = 0; s < device.supports.size(); ++s)
    apply_support(device.supports[s], s,
                  find_group_nodes(device.supports[s].groups, mesh, dof_handler,
                                   device.supports[s], "Support"),
                  bar_of, device, prescribed, result);
  synchronise(nodes, bar_of);
  add_bar_nodes(bar_of, nodes);
  add_hanging_nodes(dof_handler, nodes, bar_of);
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
