#pragma once

#include <taut/fe/triangulation.h>
#include <taut/structure/systems.h>

#include <cmath>
#include <functional>
#include <memory>

/// Meshes and devices built in code, for tests.
namespace taut::testing
{
/// A grid of n_x by n_y quads of the given order over the unit square, moved by
/// `shape` from (xi, eta) into space. Groups: surfaces `left` and `right` (by
/// the half of the square, `film` both), lines `west`, `east`, `south`,
/// `north` and, if n_x is even, `middle` between the halves; points
/// `south_west` and `north_east`.
inline fe::MeshData
make_grid(const unsigned int n_x, const unsigned int n_y,
          const unsigned int order,
          const std::function<fe::Coordinates(double, double)>& shape)
{
  fe::MeshData mesh;
  mesh.order = order;
  const auto vertex = [&](unsigned int i, unsigned int j)
  { return j * (n_x + 1) + i; };
  for (unsigned int j = 0; j <= n_y; ++j)
    for (unsigned int i = 0; i <= n_x; ++i)
      mesh.vertices.push_back(shape(double(i) / n_x, double(j) / n_y));
  const auto add_middle = [&](const double i, const double j)
  {
    mesh.middle_points.push_back(shape(i / n_x, j / n_y));
    return static_cast<unsigned int>(mesh.middle_points.size() - 1);
  };
  const unsigned int left = mesh.groups.add(2, {"left", "film"});
  const unsigned int right = mesh.groups.add(2, {"right", "film"});
  for (unsigned int j = 0; j < n_y; ++j)
    for (unsigned int i = 0; i < n_x; ++i)
    {
      fe::MeshQuad quad;
      quad.vertices = {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1),
                       vertex(i, j + 1)};
      if (order == 2)
        quad.middles = {add_middle(i + .5, j), add_middle(i + 1, j + .5),
                        add_middle(i + .5, j + 1), add_middle(i, j + .5),
                        add_middle(i + .5, j + .5)};
      quad.group_set = 2 * i < n_x ? left : right;
      mesh.quads.push_back(quad);
    }
  const auto add_line = [&](const unsigned int a, const unsigned int b,
                            const double i, const double j, const char* name)
  {
    fe::MeshLine line;
    line.vertices = {a, b};
    if (order == 2)
      line.middle = add_middle(i, j);
    line.group_set = mesh.groups.add(1, {name});
    mesh.lines.push_back(line);
  };
  for (unsigned int i = 0; i < n_x; ++i)
  {
    add_line(vertex(i, 0), vertex(i + 1, 0), i + .5, 0, "south");
    add_line(vertex(i, n_y), vertex(i + 1, n_y), i + .5, n_y, "north");
  }
  for (unsigned int j = 0; j < n_y; ++j)
  {
    add_line(vertex(0, j), vertex(0, j + 1), 0, j + .5, "west");
    add_line(vertex(n_x, j), vertex(n_x, j + 1), n_x, j + .5, "east");
    if (n_x % 2 == 0)
      add_line(vertex(n_x / 2, j), vertex(n_x / 2, j + 1), n_x / 2., j + .5,
               "middle");
  }
  mesh.points.push_back({vertex(0, 0), mesh.groups.add(0, {"south_west"})});
  mesh.points.push_back({vertex(n_x, n_y), mesh.groups.add(0, {"north_east"})});
  return mesh;
}

/// The unit square, two by two distorted cells of the second order.
inline fe::MeshData make_sheet_mesh()
{
  return make_grid(2, 2, 2,
                   [](const double xi, const double eta)
                   {
                     const double bubble = 16 * xi * (1 - xi) * eta * (1 - eta);
                     return fe::Coordinates{
                         xi + .06 * bubble * std::sin(5 * eta),
                         eta - .06 * bubble * std::cos(5 * xi), 0.};
                   });
}

inline fe::MeshData make_rectangle(const unsigned int n_x,
                                   const unsigned int n_y,
                                   const unsigned int order,
                                   const double length, const double width)
{
  return make_grid(n_x, n_y, order,
                   [=](const double xi, const double eta) {
                     return fe::Coordinates{xi * length, eta * width, 0.};
                   });
}

inline structure::Support
make_support(const std::string& group, const std::array<bool, 3>& held,
             const std::array<std::string, 3>& shape = {{"0", "0", "0"}},
             const Signal& amplitude = Signal())
{
  structure::Support support;
  support.name = "support of " + group;
  support.groups = {group};
  support.held = held;
  support.shape = shape;
  support.amplitude = amplitude;
  return support;
}

/// A film of one spring on the group `film`.
inline structure::Film make_film(const material::Spring& spring,
                                 const double thickness,
                                 const std::array<double, 2>& pre_stretch)
{
  structure::Film film;
  film.name = "film";
  film.groups = {"film"};
  film.material.springs = {spring};
  film.material.density = 1000;
  film.thickness = thickness;
  film.pre_stretch = pre_stretch;
  return film;
}

inline structure::Electrode make_electrode(const std::string& group,
                                           const Signal& voltage)
{
  structure::Electrode electrode;
  electrode.name = "electrode of " + group;
  electrode.groups = {group};
  electrode.voltage = voltage;
  return electrode;
}

/// The voltage (V) of the dimensionless field Et = (V/H) sqrt(eps/mu).
inline double make_voltage(const structure::Film& film, const double field,
                           const double modulus)
{
  const double permittivity =
      material::vacuum_permittivity * std::get<material::ConstantPermittivity>(
                                          film.material.dielectric.permittivity)
                                          .relative;
  return field * film.thickness * std::sqrt(modulus / permittivity);
}

inline structure::Pressure make_pressure(const std::string& group,
                                         const Signal& signal)
{
  structure::Pressure pressure;
  pressure.name = "pressure on " + group;
  pressure.groups = {group};
  pressure.pressure = signal;
  return pressure;
}

/// A bar that is free to move and to turn.
inline structure::RigidBar make_bar(const std::string& group, const double mass)
{
  structure::RigidBar bar;
  bar.name = "bar on " + group;
  bar.groups = {group};
  bar.mass = mass;
  return bar;
}

/// 4 by 3 cells, 40 mm by 30 mm, bent out of its plane but for the line
/// `middle`, where a bar may lie.
inline fe::MeshData make_bent_sheet(const unsigned int order)
{
  return make_grid(4, 3, order,
                   [](const double xi, const double eta)
                   {
                     const double bulge = (xi - .5) * (eta - .3);
                     return fe::Coordinates{.04 * xi + .003 * bulge, .03 * eta,
                                            .004 * bulge * (1 + xi)};
                   });
}

/// A device with its mesh, triangulation and structure.
struct Model
{
  Model(const structure::Device& device, const fe::MeshData& mesh_data,
        const unsigned int refinements = 0,
        const std::function<void(fe::Triangulation&)>& refine = {},
        const MPI_Comm communicator = MPI_COMM_WORLD)
      : mesh(mesh_data), triangulation(communicator)
  {
    fe::create_triangulation(mesh, refinements, triangulation);
    if (refine)
      refine(triangulation);
    structure =
        std::make_unique<structure::Structure>(device, mesh, triangulation);
  }

  fe::MeshData mesh;
  fe::Triangulation triangulation;
  std::unique_ptr<structure::Structure> structure;
};
} // namespace taut::testing
