#include <taut/fe/mesh_data.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::fe
{
namespace
{
/// The highest corner of the box around the points, and the box's diagonal.
struct Box
{
  Coordinates highest;
  double diagonal;
};

Box compute_box(const std::vector<Coordinates>& points)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Coordinates lowest{{infinity, infinity, infinity}};
  Box box{{{-infinity, -infinity, -infinity}}, 0};
  for (const Coordinates& point : points)
    for (unsigned int c = 0; c < 3; ++c)
    {
      lowest[c] = std::min(lowest[c], point[c]);
      box.highest[c] = std::max(box.highest[c], point[c]);
    }
  box.diagonal =
      std::hypot(box.highest[0] - lowest[0], box.highest[1] - lowest[1],
                 box.highest[2] - lowest[2]);
  return box;
}

/// The vertices and middles of a square of the plane z = corner[2], in the
/// order of MeshQuad.
constexpr std::array<std::array<double, 2>, 4> square_vertices{
    {{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}}};
constexpr std::array<std::array<double, 2>, 5> square_middles{
    {{{.5, 0}}, {{1, .5}}, {{.5, 1}}, {{0, .5}}, {{.5, .5}}}};

Coordinates place(const Box& box, const std::array<double, 2>& in_square)
{
  // Half a box away from the lines.
  const double side = box.diagonal;
  return {{box.highest[0] + (.5 + in_square[0]) * side,
           box.highest[1] + (.5 + in_square[1]) * side, box.highest[2]}};
}

/// Makes room for `n` vertices in front of the others.
void shift_vertices(MeshData& mesh, const unsigned int n)
{
  for (MeshLine& line : mesh.free_lines)
    for (unsigned int& vertex : line.vertices)
      vertex += n;
  for (MeshPoint& point : mesh.points)
    point.vertex += n;
  mesh.vertices.insert(mesh.vertices.begin(), n, Coordinates{});
}
} // namespace

void add_empty_surface(MeshData& mesh)
{
  const Box box = compute_box(mesh.vertices);
  shift_vertices(mesh, square_vertices.size());
  MeshQuad quad;
  for (unsigned int v = 0; v < square_vertices.size(); ++v)
  {
    quad.vertices[v] = v;
    mesh.vertices[v] = place(box, square_vertices[v]);
  }
  for (unsigned int m = 0; m < square_middles.size() && mesh.order == 2; ++m)
  {
    quad.middles[m] = mesh.middle_points.size();
    mesh.middle_points.push_back(place(box, square_middles[m]));
  }
  mesh.quads = {quad};
  mesh.only_lines = true;
}

std::vector<Coordinates> get_group_points(const MeshData& mesh,
                                          const std::string& group)
{
  const std::set<unsigned int> ids = mesh.groups.get_ids(0, group);
  std::vector<Coordinates> coordinates;
  for (const MeshPoint& point : mesh.points)
    if (ids.count(point.group_set) > 0)
      coordinates.push_back(mesh.vertices[point.vertex]);
  return coordinates;
}
} // namespace taut::fe
