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

/// Those in a physical group.
std::vector<Block> get_named_blocks(const int dimension)
{
  std::vector<Block> blocks = get_blocks(dimension);
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                              [](const Block& block)
                              { return block.groups.empty(); }),
               blocks.end());
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
  void check_not_empty(const std::vector<Block>& surfaces,
                       const std::vector<Block>& lines) const;
  void check_order(const Block& block) const;
  void add_quads(const Block& block);
  void add_lines(const Block& block);
  void add_line(const fe::MeshLine& line);
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
  std::map<Edge, std::size_t> known_lines_; ///< in lines or free_lines
  std::set<Edge> edges_;
};

fe::MeshData Builder::build()
{
  const std::vector<Block> surfaces = get_blocks(2);
  const std::vector<Block> lines = get_named_blocks(1);
  check_surfaces(surfaces);
  check_not_empty(surfaces, lines);
  mesh_.order = surfaces.empty() ? lines.front().order : surfaces.front().order;
  for (const Block& block : surfaces)
    add_quads(block);
  for (const Block& block : lines)
    add_lines(block);
  for (const Block& block : get_named_blocks(0))
    add_points(block);
  add_coordinates();
  if (surfaces.empty())
    fe::add_empty_surface(mesh_);
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

void Builder::check_not_empty(const std::vector<Block>& surfaces,
                              const std::vector<Block>& lines) const
{
  if (surfaces.empty() && lines.empty())
    refuse("the mesh has no surface elements, and no lines in a physical "
           "group: name surfaces of films with Physical Surface(\"name\"), "
           "lines of frames with Physical Curve(\"name\")");
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
    fe::MeshLine line;
    line.group_set = group_set;
    for (unsigned int v = 0; v < 2; ++v)
      line.vertices[v] = vertices_.get_or_add(nodes[v]);
    if (line.vertices[0] == line.vertices[1])
      refuse(fmt::format("a line of the group '{}' has no length",
                         fmt::join(block.groups, "', '")));
    if (mesh_.order == 2)
      line.middle = middles_.get_or_add(nodes[2]);
    add_line(line);
  }
}

/// Lines that are no edge of a film are those of frames beside it.
void Builder::add_line(const fe::MeshLine& line)
{
  const Edge edge = sorted(line.vertices);
  auto& lines = edges_.count(edge) > 0 ? mesh_.lines : mesh_.free_lines;
  const auto [known, is_new] = known_lines_.try_emplace(edge, lines.size());
  if (is_new)
    lines.push_back(line);
  else
    join_groups(1, line.group_set, lines[known->second].group_set);
}

void Builder::add_points(const Block& block)
{
  const unsigned int group_set = mesh_.groups.add(0, block.groups);
  for (const Tag node : block.nodes)
  {
    if (!vertices_.has(node))
      refuse(fmt::format("the point of the group '{}' is neither a corner "
                         "of a surface element nor an end of a line element "
                         "in a physical group; embed it in the surface",
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
