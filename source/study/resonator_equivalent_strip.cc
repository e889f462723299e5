#include "resonator_equivalent_strip.h"

#include <taut/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace taut::study
{
namespace
{
using fe::Coordinates;

std::set<unsigned int> find_ids(const unsigned int dimension,
                                const std::vector<std::string>& groups,
                                const fe::MeshData& mesh)
{
  std::set<unsigned int> ids;
  for (const auto& group : groups)
    if (mesh.groups.has(dimension, group))
      ids.merge(mesh.groups.get_ids(dimension, group));
  return ids;
}

/// Half the length of the cross product of the diagonals (m^2).
double compute_area(const fe::MeshQuad& quad, const fe::MeshData& mesh)
{
  Coordinates d{}, e{};
  for (unsigned int c = 0; c < 3; ++c)
  {
    d[c] =
        mesh.vertices[quad.vertices[2]][c] - mesh.vertices[quad.vertices[0]][c];
    e[c] =
        mesh.vertices[quad.vertices[3]][c] - mesh.vertices[quad.vertices[1]][c];
  }
  return 0.5 * std::hypot(d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2],
                          d[0] * e[1] - d[1] * e[0]);
}

/// The coordinate that the film's first axis follows.
unsigned int find_direction(const structure::Film& film,
                            const std::string& file)
{
  const auto& axis = film.axis;
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  for (unsigned int c = 0; c < 3; ++c)
    if (std::abs(axis[c]) > (1 - 1e-12) * length)
      return c;
  refuse(film, file,
         "the lumped model moves along the first axis of the film, which must "
         "be along x, y or z");
}

/// The coordinate across `along` in which the strip has an extent.
unsigned int find_width_direction(const FilmStrip& strip,
                                  const structure::Film& film,
                                  const std::string& file)
{
  const unsigned int j = (strip.along + 1) % 3, k = (strip.along + 2) % 3;
  const auto is_flat = [&](const unsigned int c)
  { return is_same_length(strip.high[c], strip.low[c], strip.length()); };
  if (is_flat(j) == is_flat(k))
    refuse(film, file,
           "the lumped model needs a film that is flat, in a plane of two "
           "coordinates");
  return is_flat(j) ? k : j;
}
} // namespace

bool is_same_length(const double a, const double b, const double size)
{
  return std::abs(a - b) <= 1e-9 * size;
}

bool lie_at(const std::vector<Coordinates>& points,
            const unsigned int component, const double coordinate,
            const double size)
{
  return !points.empty() &&
         std::all_of(
             points.begin(), points.end(),
             [&](const Coordinates& point)
             { return is_same_length(point[component], coordinate, size); });
}

std::vector<bool> find_quads(const std::vector<std::string>& groups,
                             const fe::MeshData& mesh)
{
  const auto ids = find_ids(2, groups, mesh);
  std::vector<bool> found;
  for (const fe::MeshQuad& quad : mesh.quads)
    found.push_back(ids.count(quad.group_set) > 0);
  return found;
}

std::vector<Coordinates>
find_line_points(const std::vector<std::string>& groups,
                 const fe::MeshData& mesh)
{
  const auto ids = find_ids(1, groups, mesh);
  std::vector<Coordinates> points;
  for (const fe::MeshLine& line : mesh.lines)
    if (ids.count(line.group_set) > 0)
      for (const unsigned int vertex : line.vertices)
        points.push_back(mesh.vertices[vertex]);
  return points;
}

FilmStrip measure_strip(const structure::Film& film, const fe::MeshData& mesh,
                        const std::string& file)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  FilmStrip strip;
  strip.low = {infinity, infinity, infinity};
  strip.high = {-infinity, -infinity, -infinity};
  const auto in_film = find_quads(film.groups, mesh);
  double area = 0;
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
  {
    if (!in_film[i])
      continue;
    area += compute_area(mesh.quads[i], mesh);
    for (const unsigned int vertex : mesh.quads[i].vertices)
      for (unsigned int c = 0; c < 3; ++c)
      {
        strip.low[c] = std::min(strip.low[c], mesh.vertices[vertex][c]);
        strip.high[c] = std::max(strip.high[c], mesh.vertices[vertex][c]);
      }
  }
  if (area == 0)
    refuse(film, file, "the mesh has no surface of this film");
  strip.along = find_direction(film, file);
  strip.across = find_width_direction(strip, film, file);
  const double box = strip.length() * strip.width();
  if (!is_same_length(area, box, box))
    refuse(film, file,
           "the lumped model needs a film that is a rectangle with sides along "
           "its first axis and across");
  return strip;
}
} // namespace taut::study
