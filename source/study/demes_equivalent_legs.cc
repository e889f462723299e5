#include "demes_equivalent_legs.h"

#include <taut/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "comparison_checks.h"
#include "demes_equivalent_film.h"

namespace taut::study
{
namespace
{
using fe::Coordinates;
using structure::Frame;

/// The lines of a leg, edges of the film or free.
std::vector<std::array<Coordinates, 2>> find_lines(const Frame& leg,
                                                   const fe::MeshData& mesh)
{
  std::set<unsigned int> ids;
  for (const std::string& group : leg.groups)
    ids.merge(mesh.groups.get_ids(1, group));
  std::vector<std::array<Coordinates, 2>> found;
  for (const auto* lines : {&mesh.lines, &mesh.free_lines})
    for (const fe::MeshLine& line : *lines)
      if (ids.count(line.group_set) > 0)
        found.push_back(
            {mesh.vertices[line.vertices[0]], mesh.vertices[line.vertices[1]]});
  return found;
}

/// The coordinate across the film's plane.
unsigned int get_normal(const FilmStrip& strip)
{
  return 3 - strip.along - strip.across;
}

bool lies_along(const std::array<Coordinates, 2>& line, const FilmStrip& strip)
{
  for (unsigned int c = 0; c < 3; ++c)
    if (c != strip.along &&
        !is_same_length(line[0][c], line[1][c], strip.length()))
      return false;
  return std::all_of(line.begin(), line.end(),
                     [&](const Coordinates& end)
                     {
                       const double margin = 1e-9 * strip.length();
                       const double x = end[strip.along];
                       return x >= strip.low[strip.along] - margin &&
                              x <= strip.high[strip.along] + margin;
                     });
}

/// How many legs a frame consists of.
double count_legs(const Case& film_case, const Frame& frame,
                  const std::vector<std::array<Coordinates, 2>>& lines,
                  const FilmStrip& strip)
{
  double length = 0;
  bool straight = true;
  for (const auto& line : lines)
  {
    length += std::abs(line[1][strip.along] - line[0][strip.along]);
    straight = straight && lies_along(line, strip);
  }
  const double number = std::round(length / strip.length());
  if (!straight || number < 1 ||
      !is_same_length(length, number * strip.length(), length))
    refuse(film_case, "Frame", frame,
           "the legs of the lumped DEMES are straight and as long as the film "
           "from end to end");
  return number;
}

/// +1 or -1 for a section whose thickness lies across the film.
double get_side(const Case& film_case, const Frame& frame,
                const unsigned int normal)
{
  const auto& direction = frame.normal;
  const double size = std::hypot(direction[0], direction[1], direction[2]);
  if (std::abs(direction[normal]) < (1 - 1e-12) * size)
    refuse(film_case, "Frame", frame,
           "the legs of the lumped DEMES bend out of the film's plane: their "
           "Normal must be that of the film");
  return direction[normal] > 0 ? 1 : -1;
}

double compute_stiffness(const Case& film_case, const Frame& frame)
{
  const double temperature = read_constant(film_case, "Frame", frame,
                                           frame.temperature, "temperature");
  const double humidity =
      read_constant(film_case, "Frame", frame, frame.humidity, "humidity");
  try
  {
    return frame.section.bending_stiffness[0] *
           material::compute_factor(frame.modulus_law, temperature) *
           material::compute_factor(frame.humidity_law, humidity);
  }
  catch (const StepRejected& rejection)
  {
    refuse(film_case, "Frame", frame, rejection.what());
  }
}
} // namespace

LegMeasures measure_legs(const Case& film_case, const FilmStrip& strip,
                         const fe::MeshData& mesh)
{
  const unsigned int normal = get_normal(strip);
  LegMeasures legs;
  std::optional<double> height;
  for (const std::string& name : film_case.demes_comparison->legs)
  {
    const Frame& frame =
        find(film_case, film_case.device.frames, name, "frame");
    const double side = get_side(film_case, frame, normal);
    const auto lines = find_lines(frame, mesh);
    legs.bending_stiffness += count_legs(film_case, frame, lines, strip) *
                              compute_stiffness(film_case, frame);
    for (const auto& line : lines)
    {
      const double axis = line[0][normal] - side * frame.offset;
      if (!is_same_length(height.value_or(axis), axis, strip.length()))
        refuse(film_case, "Frame", frame,
               "the legs of the lumped DEMES have one distance from the film");
      height = axis;
    }
  }
  if (!height)
    refuse(film_case, "the lumped DEMES needs Legs");
  legs.offset = std::abs(strip.low[normal] - *height);
  return legs;
}
} // namespace taut::study
