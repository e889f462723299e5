// Areas and lengths of a mesh as it was read.
#pragma once

#include <taut/fe/reference_positions.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <string>

namespace taut::io
{
inline dealii::Point<3> to_point(const fe::Coordinates& x)
{
  return {x[0], x[1], x[2]};
}

/// Integral of the normal over a group; its first entry is the area, then the
/// three components of the normal integrated.
inline std::array<double, 4> integrate_normal(const fe::MeshData& mesh,
                                              const std::string& group)
{
  const auto ids = mesh.groups.get_ids(2, group);
  const dealii::QGauss<2> quadrature(4);
  // Central differences are exact for the quadratic positions.
  const double step = .05;
  std::array<double, 4> integral{};
  for (const fe::MeshQuad& quad : mesh.quads)
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      dealii::Tensor<1, 3> tangents[2];
      for (unsigned int d = 0; d < 2; ++d)
      {
        dealii::Point<2> shift;
        shift[d] = step;
        const dealii::Point<2> x = quadrature.point(q);
        tangents[d] =
            (fe::compute_position(mesh, quad, x + shift) -
             fe::compute_position(mesh, quad, dealii::Point<2>(x - shift))) /
            (2 * step);
      }
      const auto normal = dealii::cross_product_3d(tangents[0], tangents[1]);
      if (ids.count(quad.group_set) == 0)
        continue;
      integral[0] += quadrature.weight(q) * normal.norm();
      for (unsigned int d = 0; d < 3; ++d)
        integral[1 + d] += quadrature.weight(q) * normal[d];
    }
  return integral;
}

inline double compute_area(const fe::MeshData& mesh, const std::string& group)
{
  return integrate_normal(mesh, group)[0];
}

/// Sum of the distances between the ends of those of `lines` that lie in a
/// group.
inline double sum_chords(const fe::MeshData& mesh,
                         const std::vector<fe::MeshLine>& lines,
                         const std::string& group)
{
  const auto ids = mesh.groups.get_ids(1, group);
  double length = 0;
  for (const fe::MeshLine& line : lines)
    if (ids.count(line.group_set) > 0)
      length += to_point(mesh.vertices[line.vertices[0]])
                    .distance(to_point(mesh.vertices[line.vertices[1]]));
  return length;
}

/// Of the edges of cells.
inline double sum_chords(const fe::MeshData& mesh, const std::string& group)
{
  return sum_chords(mesh, mesh.lines, group);
}
} // namespace taut::io
