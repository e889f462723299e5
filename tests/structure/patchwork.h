#pragma once

#include <taut/fe/mesh_data.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>

/// Curved meshes of second order from several patches, for tests.
namespace taut::testing
{
class Patchwork
{
public:
  using Map = std::function<fe::Coordinates(double, double)>;
  using Selector = std::function<bool(const fe::Coordinates&)>;

  Patchwork()
  {
    mesh.order = 2;
    film_ = mesh.groups.add(2, {"film"});
  }

  /// n by n quads over the unit square, which `map` takes into space; nodes
  /// that fall on those of other patches are the same. Group: `film`.
  void add_patch(const unsigned int n, const Map& map)
  {
    const unsigned int corners[4][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    const unsigned int middles[5][2] = {{1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}};
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
      {
        const auto place = [&](const unsigned int(&shift)[2]) {
          return map((2 * i + shift[0]) / (2. * n),
                     (2 * j + shift[1]) / (2. * n));
        };
        fe::MeshQuad quad;
        for (unsigned int k = 0; k < 4; ++k)
          quad.vertices[k] =
              get_node(place(corners[k]), vertices_, mesh.vertices);
        for (unsigned int k = 0; k < 5; ++k)
          quad.middles[k] =
              get_node(place(middles[k]), middles_, mesh.middle_points);
        quad.group_set = film_;
        mesh.quads.push_back(quad);
      }
  }

  /// Puts the edges into `group` whose two ends and middle are `selected`.
  void add_line(const std::string& group, const Selector& selected)
  {
    const unsigned int set = mesh.groups.add(1, {group});
    for (const fe::MeshQuad& quad : mesh.quads)
      for (unsigned int k = 0; k < 4; ++k)
      {
        const unsigned int a = quad.vertices[k], b = quad.vertices[(k + 1) % 4];
        if (selected(mesh.vertices[a]) && selected(mesh.vertices[b]) &&
            selected(mesh.middle_points[quad.middles[k]]))
          mesh.lines.push_back({{a, b}, quad.middles[k], set});
      }
  }

  fe::MeshData mesh;

private:
  using Numbers = std::map<std::array<long, 3>, unsigned int>;

  static unsigned int get_node(const fe::Coordinates& x, Numbers& numbers,
                               std::vector<fe::Coordinates>& coordinates)
  {
    std::array<long, 3> key;
    for (unsigned int c = 0; c < 3; ++c)
      key[c] = std::lround(x[c] * 1e8);
    const auto [entry, is_new] = numbers.try_emplace(key, numbers.size());
    if (is_new)
      coordinates.push_back(x);
    return entry->second;
  }

  unsigned int film_;
  Numbers vertices_, middles_;
};

/// Selects points whose coordinate is zero.
inline Patchwork::Selector make_plane(const unsigned int component)
{
  return [component](const fe::Coordinates& x)
  { return std::abs(x[component]) < 1e-8; };
}

/// An eighth of the unit sphere, normal outwards: three faces of a cube with n
/// by n quads each, projected. Lines `x0`, `y0` and `z0` on the planes.
inline fe::MeshData make_octant(const unsigned int n)
{
  Patchwork patchwork;
  for (unsigned int face = 0; face < 3; ++face)
    patchwork.add_patch(n,
                        [face](const double s, const double t)
                        {
                          const double a = std::tan(M_PI / 4 * s),
                                       b = std::tan(M_PI / 4 * t);
                          const double size = std::sqrt(1 + a * a + b * b);
                          fe::Coordinates x;
                          x[face] = a / size;
                          x[(face + 1) % 3] = b / size;
                          x[(face + 2) % 3] = 1 / size;
                          return x;
                        });
  patchwork.add_line("x0", make_plane(0));
  patchwork.add_line("y0", make_plane(1));
  patchwork.add_line("z0", make_plane(2));
  return patchwork.mesh;
}

/// A quarter of the unit disc, normal +z: an inner square and two patches that
/// reach the rim, n by n quads each. Lines `x0`, `y0` and `rim`.
inline fe::MeshData make_quarter_disc(const unsigned int n)
{
  constexpr double side = .5, corner = .4;
  Patchwork patchwork;
  const auto add_sector = [&](const fe::Coordinates& a,
                              const fe::Coordinates& b, const double angle)
  {
    patchwork.add_patch(n,
                        [=](const double s, const double t)
                        {
                          const double phi = angle + t * M_PI / 4;
                          const double rim[2] = {std::cos(phi), std::sin(phi)};
                          fe::Coordinates x{};
                          for (unsigned int c = 0; c < 2; ++c)
                            x[c] = (1 - s) * (a[c] + t * (b[c] - a[c])) +
                                   s * rim[c];
                          return x;
                        });
  };
  patchwork.add_patch(n,
                      [=](const double s, const double t)
                      {
                        return fe::Coordinates{s * (side + t * (corner - side)),
                                               t * (side + s * (corner - side)),
                                               0};
                      });
  add_sector({{side, 0, 0}}, {{corner, corner, 0}}, 0);
  add_sector({{corner, corner, 0}}, {{0, side, 0}}, M_PI / 4);
  patchwork.add_line("x0", make_plane(0));
  patchwork.add_line("y0", make_plane(1));
  patchwork.add_line("rim", [](const fe::Coordinates& x)
                     { return std::hypot(x[0], x[1]) > 1 - 1e-8; });
  return patchwork.mesh;
}
} // namespace taut::testing
