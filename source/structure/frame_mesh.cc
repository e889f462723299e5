#include <taut/base/exceptions.h>
#include <taut/fe/reference_element.h>
#include <taut/fe/vector3.h>
#include <taut/structure/frame_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::structure
{
namespace
{
using fe::Coordinates;
using DoFHandler = dealii::DoFHandler<2, 3>;

/// An edge by the coordinates of its nodes.
struct RawEdge
{
  unsigned int frame = 0;
  unsigned int line_set = 0;
  std::vector<Coordinates> nodes;

  template <typename Archive>
  void serialize(Archive& archive, const unsigned int)
  {
    archive& frame& line_set& nodes;
  }
};

/// Set of line groups -> frame.
std::map<unsigned int, unsigned int> map_lines(const Device& device,
                                               const fe::MeshData& mesh)
{
  std::map<unsigned int, unsigned int> frame_of;
  for (unsigned int f = 0; f < device.frames.size(); ++f)
    for (const auto& group : device.frames[f].groups)
      try
      {
        for (const auto id : mesh.groups.get_ids(1, group))
          if (!frame_of.insert({id, f}).second && frame_of[id] != f)
            throw BadInput("it shares the line '" + group +
                           "' with the frame '" +
                           device.frames[frame_of[id]].name + "'");
      }
      catch (const BadInput& error)
      {
        throw BadInput(error.message(), "", device.frames[f].source_line,
                       "Frame " + device.frames[f].name);
      }
  return frame_of;
}

/// The finest edges of this rank's cells that lie on frames.
std::vector<RawEdge>
collect_film_edges(const std::map<unsigned int, unsigned int>& frame_of,
                   const DoFHandler& dof_handler,
                   const NodePositions& positions)
{
  const fe::ReferenceElement element(dof_handler.get_fe().degree);
  std::vector<dealii::types::global_dof_index> dofs(element.n_nodes);
  std::vector<RawEdge> edges;
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const unsigned int face : cell->face_indices())
      {
        const auto found = frame_of.find(cell->face(face)->manifold_id());
        if (found == frame_of.end() || cell->face(face)->has_children())
          continue;
        cell->get_dof_indices(dofs);
        RawEdge edge{found->second, found->first, {}};
        for (const auto node : element.face_nodes[face])
        {
          const auto& x = positions.at(dofs[node]);
          edge.nodes.push_back({x[0], x[1], x[2]});
        }
        edges.push_back(edge);
      }
  return edges;
}

/// Lines of their own, cut into equal pieces with `degree` + 1 nodes.
void add_free_edges(const std::map<unsigned int, unsigned int>& frame_of,
                    const fe::MeshData& mesh, const unsigned int degree,
                    const unsigned int refinements, std::vector<RawEdge>& edges)
{
  const unsigned int pieces = 1u << refinements;
  for (const auto& line : mesh.free_lines)
  {
    const auto found = frame_of.find(line.group_set);
    if (found == frame_of.end())
      continue;
    std::vector<Coordinates> nodes{mesh.vertices[line.vertices[0]],
                                   mesh.vertices[line.vertices[1]]};
    if (mesh.order == 2)
      nodes.push_back(mesh.middle_points[line.middle]);
    for (unsigned int i = 0; i < pieces; ++i)
    {
      const double begin = double(i) / pieces, end = double(i + 1) / pieces;
      RawEdge edge{found->second, found->first, {}};
      edge.nodes = {interpolate_edge(nodes, begin),
                    interpolate_edge(nodes, end)};
      if (degree == 2)
        edge.nodes.push_back(interpolate_edge(nodes, 0.5 * (begin + end)));
      edges.push_back(edge);
    }
  }
}

/// Orders edges by frame and place, whatever the partition.
void sort_edges(const double unit, std::vector<RawEdge>& edges)
{
  for (auto& edge : edges)
  {
    Coordinates along;
    for (unsigned int c = 0; c < 3; ++c)
      along[c] = edge.nodes[1][c] - edge.nodes[0][c];
    const double* steepest =
        std::max_element(along.begin(), along.end(),
                         [](const double a, const double b)
                         { return std::abs(a) < std::abs(b) * (1 - 1e-6); });
    if (*steepest < 0)
      std::swap(edge.nodes[0], edge.nodes[1]);
  }
  const auto key = [&](const RawEdge& edge)
  {
    std::array<long, 4> result{{static_cast<long>(edge.frame)}};
    for (unsigned int c = 0; c < 3; ++c)
      result[1 + c] = std::lround(
          0.5 * (edge.nodes[0][c] + edge.nodes[1][c]) / unit + 0.123);
    return result;
  };
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const RawEdge& a, const RawEdge& b)
                   { return key(a) < key(b); });
  // An interior line is seen from both of its sides.
  const auto last = std::unique(edges.begin(), edges.end(),
                                [&](const RawEdge& a, const RawEdge& b)
                                { return key(a) == key(b); });
  edges.erase(last, edges.end());
}

/// Finds the film's nodes at the places, on all ranks.
void find_film_nodes(const DoFHandler& dof_handler,
                     const NodePositions& positions, FrameMesh& frame_mesh)
{
  using Found = std::pair<unsigned int, fe::GlobalNode>;
  std::vector<Found> own;
  const auto& owned = dof_handler.locally_owned_dofs();
  if (!frame_mesh.places.empty())
    for (const auto& [dof, x] : positions)
      if (owned.is_element(dof))
        if (const auto place = frame_mesh.find_place({x[0], x[1], x[2]}))
          own.push_back({*place, dof});
  frame_mesh.film_nodes.resize(frame_mesh.places.size());
  for (const auto& part :
       dealii::Utilities::MPI::all_gather(dof_handler.get_communicator(), own))
    for (const auto& [place, node] : part)
      frame_mesh.film_nodes[place] = node;
}
} // namespace

fe::Coordinates interpolate_edge(const std::vector<fe::Coordinates>& nodes,
                                 const double s)
{
  Coordinates x{};
  for (unsigned int c = 0; c < 3; ++c)
    x[c] = nodes.size() == 2 ? (1 - s) * nodes[0][c] + s * nodes[1][c]
                             : (1 - s) * (1 - 2 * s) * nodes[0][c] +
                                   s * (2 * s - 1) * nodes[1][c] +
                                   4 * s * (1 - s) * nodes[2][c];
  return x;
}

double compute_extent(const fe::MeshData& mesh)
{
  double extent = 0;
  for (unsigned int c = 0; c < 3; ++c)
  {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& x : mesh.vertices)
    {
      low = std::min(low, x[c]);
      high = std::max(high, x[c]);
    }
    extent = std::max(extent, high - low);
  }
  return extent;
}

std::optional<unsigned int> FrameMesh::find_place(const Coordinates& x) const
{
  for (unsigned int i = 0; i < places.size(); ++i)
    if (std::abs(places[i][0] - x[0]) < tolerance &&
        fe::compute_distance(places[i], x) < tolerance)
      return i;
  return std::nullopt;
}

FrameMesh make_frame_mesh(const Device& device, const fe::MeshData& mesh,
                          const DoFHandler& dof_handler,
                          const NodePositions& positions)
{
  FrameMesh result;
  if (device.frames.empty())
    return result;
  const auto frame_of = map_lines(device, mesh);
  std::vector<RawEdge> edges;
  if (!mesh.only_lines)
    for (auto& part : dealii::Utilities::MPI::all_gather(
             dof_handler.get_communicator(),
             collect_film_edges(frame_of, dof_handler, positions)))
      std::move(part.begin(), part.end(), std::back_inserter(edges));
  add_free_edges(frame_of, mesh, dof_handler.get_fe().degree,
                 device.mesh.refinements, edges);
  result.tolerance = 1e-7 * compute_extent(mesh);
  sort_edges(10 * result.tolerance, edges);
  for (const auto& raw : edges)
  {
    FrameEdge edge{raw.frame, raw.line_set, {}};
    for (const auto& x : raw.nodes)
    {
      auto place = result.find_place(x);
      if (!place)
      {
        place = result.places.size();
        result.places.push_back(x);
      }
      edge.places.push_back(*place);
    }
    result.edges.push_back(edge);
  }
  find_film_nodes(dof_handler, positions, result);
  return result;
}

std::set<unsigned int> find_group_places(const std::vector<std::string>& groups,
                                         const FrameMesh& frame_mesh,
                                         const fe::MeshData& mesh)
{
  std::set<unsigned int> places;
  for (const auto& group : groups)
    if (mesh.groups.has(0, group))
    {
      for (const auto& x : fe::get_group_points(mesh, group))
        if (const auto place = frame_mesh.find_place(x))
          places.insert(*place);
    }
    else if (mesh.groups.has(1, group))
    {
      const auto ids = mesh.groups.get_ids(1, group);
      for (const auto& edge : frame_mesh.edges)
        if (ids.count(edge.line_set) > 0)
          places.insert(edge.places.begin(), edge.places.end());
    }
  return places;
}
} // namespace taut::structure
