#pragma once

#include <taut/base/exceptions.h>
#include <taut/fe/mesh_data.h>
#include <taut/structure/description.h>

#include <array>
#include <string>
#include <vector>

namespace taut::study
{
/// Throws BadInput at the film's line in `file`.
[[noreturn]] inline void refuse(const structure::Film& film,
                                const std::string& file,
                                const std::string& message)
{
  throw BadInput(message, file, film.source_line, "Film " + film.name);
}

/// A film that is a flat rectangle of the mesh with sides along coordinates.
struct FilmStrip
{
  std::array<double, 3> low{}, high{}; ///< (m)
  /// Coordinates along the first axis of the film and across it, in its plane.
  unsigned int along = 0, across = 1;

  double length() const
  {
    return high[along] - low[along];
  }
  double width() const
  {
    return high[across] - low[across];
  }
};

/// Errors: BadInput with the line of the film in `file` if it is none.
FilmStrip measure_strip(const structure::Film& film, const fe::MeshData& mesh,
                        const std::string& file);

/// Whether each quad of the mesh lies in any of the groups.
std::vector<bool> find_quads(const std::vector<std::string>& groups,
                             const fe::MeshData& mesh);

/// The vertices of all lines in any of the groups; groups of points and
/// surfaces have none.
std::vector<fe::Coordinates>
find_line_points(const std::vector<std::string>& groups,
                 const fe::MeshData& mesh);

/// Whether two lengths of a strip's size are the same but for round-off.
bool is_same_length(double a, double b, double size);

/// Whether all points have the given coordinate; false if there are none.
bool lie_at(const std::vector<fe::Coordinates>& points, unsigned int component,
            double coordinate, double size);
} // namespace taut::study
