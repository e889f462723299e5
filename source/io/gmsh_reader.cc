#include <taut/base/exceptions.h>
#include <taut/io/gmsh_reader.h>
#include <taut/io/gmsh_session.h>

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cstdlib>
#include <unordered_map>

namespace taut::io
{
namespace
{
using Tag = std::size_t;
using Edge = std::array<unsigned int, 2>;

/// All elements of one type on one geometric entity of gmsh.
struct Block
{
  std::string type;
  unsigned int order = 0;
  unsigned int corners = 0;
  unsigned int nodes_per_element = 0;
  std::vector<Tag> nodes;
  std::set<std::string> groups;

  std::size_t size() const
  {
    return nodes.size() / nodes_per_element;
  }
  const Tag* get_element(const std::size_t i) const
  {
    return nodes.data() + i * nodes_per_element;
  }
};

/// The physical groups of an entity. gmsh keeps the sense in the tag's sign.
std::set<std::string> get_groups(const int dimension, const int entity)
{
  std::vector<int> tags;
  gmsh::model::getPhysicalGroupsForEntity(dimension, entity, tags);
  std::set<std::string> groups;
  for (const int tag : tags)
  {
    std::string name;
    gmsh::model::getPhysicalName(dimension, std::abs(tag), name);
    groups.insert(name.empty() ? std::to_string(std::abs(tag)) : name);
  }
  return groups;
}

Block make_block(const int type, std::vector<Tag> nodes)
{
  Block block;
  int dimension, order, nodes_per_element, corners;
  std::vector<double> coordinates;
  gmsh::model::mesh::getElementProperties(type, block.type, dimension, order,
                                          nodes_per_element, coordinates,
                                          corners);
  block.order = order;
  block.corners = corners;
  block.nodes_per_element = nodes_per_element;
  block.nodes = std::move(nodes);
  return block;
}

std::vector<Block> get_blocks(const int dimension)
{
  std::vector<Block> blocks;
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dimension);
  for (const auto& [unused, entity] : entities)
  {
    std::vector<int> types;
    std::vector<std::vector<Tag>> elements, nodes;
    gmsh::model::mesh::getElements(types, elements, nodes, dimension, entity);
    for (std::size_t i = 0; i < types.size(); ++i)
    {
      blocks.push_back(make_block(types[i], std::move(nodes[i])));
      blocks.back().groups = get_groups(dimension, entity);
    }
  }
  return blocks;
}

std::unordered_map<Tag, fe::Coordinates> get_nodes()
{
  std::vector<Tag> tags;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters, -1, -1, false,
                              false);
  std::unordered_map<Tag, fe::Coordinates> nodes;
  for (std::size_t i = 0; i < tags.size(); ++i)
    nodes[tags[i]] = {coordinates[3 * i], coordinates[3 * i + 1],
                      coordinates[3 * i + 2]};
  return nodes;
}

/// Numbers nodes in the order of their first use.
class Numbering
{
public:
  unsigned int get_or_add(const Tag node)
  {
    const auto [entry, is_new] = numbers_.try_emplace(node, numbers_.size());
    if (is_new)
      nodes_.push_back(node);
    return entry->second;
  }
  bool has(const Tag node) const
  {
    return numbers_.count(node) > 0;
  }
  const std::vector<Tag>& get_nodes() const
  {
    return nodes_;
  }

private:
  std::unordered_map<Tag, unsigned int> numbers_;
  std::vector<Tag> nodes_;
};

template <std::size_t n>
std::array<unsigned int, n> sorted(std::array<unsigned int, n> values)
{
  std::sort(values.begin(), values.end());
  return values;
}

/// Turns the model that gmsh holds into a mesh.
class Builder
{
public:
  explicit Builder(const std::string& file) : file_(file) {}
  fe::MeshData build();

private:
  [[noreturn]] void refuse(const std::string& message) const
  {
    throw BadInput(message, file_, 0, "");
  }
  void check_surfaces(const std::vector<Block>& blocks) const;
  void check_order(const Block& block) const;
  void add_quads(const Block& block);
  void add_lines(const Block& block);
  void add_points(const Block& block);
  void add_edges(const fe::MeshQuad& quad);
  void add_coordinates();
  void join_groups(unsigned int dimension, unsigned int added,
                   unsigned int& group_set);

  std::string file_;
  fe::MeshData mesh_;
  Numbering vertices_;
  Numbering middles_;
  /// Elements by their sorted vertices: msh 2.2 lists an element once for each
  /// of its groups, and merged nodes can bring two lines together.
  std::map<std::array<unsigned int, 4>, std::size_t> known_quads_;
  std::map<Edge, std::size_t> known_lines_;
  std::set<Edge> edges_;
};

fe::MeshData Builder::build()
{
  const std::vector<Block> surfaces = get_blocks(2);
  check_surfaces(surfaces);
  mesh_.order = surfaces.front().order;
  for (const Block& block : surfaces)
    add_quads(block);
  for (const Block& block : get_blocks(1))
    if (!block.groups.empty())
      add_lines(block);
  for (const Block& block : get_blocks(0))
    if (!block.groups.empty())
      add_points(block);
  add_coordinates();
  return std::move(mesh_);
}

void Builder::check_surfaces(const std::vector<Block>& blocks) const
{
  std::size_t triangles = 0, others = 0, without_group = 0;
  for (const Block& block : blocks)
  {
    triangles += block.corners == 3 ? block.size() : 0;
    others += block.corners != 3 ? block.size() : 0;
    without_group += block.groups.empty() ? block.size() : 0;
  }
  if (triangles + others == 0)
    refuse("the mesh has no surface elements");
  if (triangles > 0)
    refuse(fmt::format(
        "{} of the {} surface elements are triangles, but a film needs "
        "quadrilaterals: end the .geo with 'Recombine Surface {{:}};', "
        "'Mesh.RecombinationAlgorithm = 1;' and 'Mesh.Algorithm = 6;', or set "
        "'Mesh.RecombineAll = 1;'; if a few triangles remain, add "
        "'Mesh.SubdivisionAlgorithm = 1;', which splits every cell",
        triangles, triangles + others));
  if (without_group > 0)
    refuse(fmt::format("{} of the {} surface elements lie in no physical "
                       "group: name them with Physical Surface(\"name\")",
                       without_group, others));
}

void Builder::check_order(const Block& block) const
{
  const bool is_complete =
      block.nodes_per_element == (block.corners == 4 ? 9u : 3u);
  if (block.order > 2 || (block.order == 2 && !is_complete))
    refuse("the mesh holds elements of the kind '" + block.type +
           "'; elements have order 1 or, complete with the centre point, 2 "
           "(Mesh.ElementOrder, Mesh.SecondOrderIncomplete = 0)");
  if (block.order != mesh_.order)
    refuse("the mesh mixes elements of order 1 and 2");
}

void Builder::add_quads(const Block& block)
{
  check_order(block);
  const unsigned int group_set = mesh_.groups.add(2, block.groups);
  for (std::size_t i = 0; i < block.size(); ++i)
  {
    const Tag* nodes = block.get_element(i);
    fe::MeshQuad quad;
    quad.group_set = group_set;
    for (unsigned int v = 0; v < 4; ++v)
      quad.vertices[v] = vertices_.get_or_add(nodes[v]);
    for (unsigned int m = 0; m < 5 && mesh_.order == 2; ++m)
      quad.middles[m] = middles_.get_or_add(nodes[4 + m]);
    add_edges(quad);
    const auto [known, is_new] =
        known_quads_.try_emplace(sorted(quad.vertices), mesh_.quads.size());
    if (is_new)
      mesh_.quads.push_back(quad);
    else
      join_groups(2, group_set, mesh_.quads[known->second].group_set);
  }
}

void Builder::add_edges(const fe::MeshQuad& quad)
{
  for (unsigned int v = 0; v < 4; ++v)
  {
    const Edge edge{{quad.vertices[v], quad.vertices[(v + 1) % 4]}};
    if (edge[0] == edge[1])
      refuse("the mesh has a quadrilateral with an edge of no length");
    edges_.insert(sorted(edge));
  }
}

void Builder::add_lines(const Block& block)
{
  check_order(block);
  const unsigned int group_set = mesh_.groups.add(1, block.groups);
  for (std::size_t i = 0; i < block.size(); ++i)
  {
    const Tag* nodes = block.get_element(i);
    const bool has_vertices =
        vertices_.has(nodes[0]) && vertices_.has(nodes[1]);
    fe::MeshLine line;
    line.group_set = group_set;
    for (unsigned int v = 0; v < 2 && has_vertices; ++v)
      line.vertices[v] = vertices_.get_or_add(nodes[v]);
    if (!has_vertices || edges_.count(sorted(line.vertices)) == 0)
      refuse(fmt::format("a line of the group '{}' is no edge of a surface "
                         "element; lines without a film beside them are not "
                         "supported",
                         fmt::join(block.groups, "', '")));
    if (mesh_.order == 2)
      line.middle = middles_.get_or_add(nodes[2]);
    const auto [known, is_new] =
        known_lines_.try_emplace(sorted(line.vertices), mesh_.lines.size());
    if (is_new)
      mesh_.lines.push_back(line);
    else
      join_groups(1, group_set, mesh_.lines[known->second].group_set);
  }
}

void Builder::add_points(const Block& block)
{
  const unsigned int group_set = mesh_.groups.add(0, block.groups);
  for (const Tag node : block.nodes)
  {
    if (!vertices_.has(node))
      refuse(fmt::format("the point of the group '{}' is no corner of a "
                         "surface element; embed it in the surface",
                         fmt::join(block.groups, "', '")));
    const fe::MeshPoint point{vertices_.get_or_add(node), group_set};
    mesh_.points.push_back(point);
  }
}

void Builder::join_groups(const unsigned int dimension,
                          const unsigned int added, unsigned int& group_set)
{
  std::set<std::string> groups = mesh_.groups.get_set(dimension, group_set);
  groups.merge(std::set<std::string>(mesh_.groups.get_set(dimension, added)));
  group_set = mesh_.groups.add(dimension, groups);
}

void Builder::add_coordinates()
{
  const auto coordinates = get_nodes();
  for (const Tag node : vertices_.get_nodes())
    mesh_.vertices.push_back(coordinates.at(node));
  for (const Tag node : middles_.get_nodes())
    mesh_.middle_points.push_back(coordinates.at(node));
}
} // namespace

fe::MeshData read_mesh(const std::string& file,
                       const std::map<std::string, double>& geo_parameters)
{
  const GmshSession session(file, geo_parameters);
  return Builder(file).build();
}
} // namespace taut::io
