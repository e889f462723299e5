#pragma once

#include <algorithm>
#include <cmath>

#include "structure/devices.h"
#include "structure/statics.h"

/// Frames without a film, built in code.
namespace taut::testing
{
/// Adds a line of `n` quadratic pieces along `curve`(s), s from 0 to 1, as free
/// lines in the group `name`. Ends that lie on earlier vertices share them;
/// returns the vertices of both ends.
inline std::array<unsigned int, 2>
add_line(fe::MeshData& mesh, const std::string& name, const unsigned int n,
         const std::function<fe::Coordinates(double)>& curve)
{
  const auto find_or_add = [&](const fe::Coordinates& x)
  {
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      if (std::hypot(mesh.vertices[v][0] - x[0], mesh.vertices[v][1] - x[1],
                     mesh.vertices[v][2] - x[2]) < 1e-9)
        return v;
    mesh.vertices.push_back(x);
    return static_cast<unsigned int>(mesh.vertices.size() - 1);
  };
  const unsigned int set = mesh.groups.add(1, {name});
  std::array<unsigned int, 2> ends{find_or_add(curve(0)), 0};
  unsigned int last = ends[0];
  for (unsigned int i = 0; i < n; ++i)
  {
    fe::MeshLine line;
    line.vertices = {last, find_or_add(curve(double(i + 1) / n))};
    line.middle = mesh.middle_points.size();
    mesh.middle_points.push_back(curve((i + .5) / n));
    line.group_set = set;
    mesh.free_lines.push_back(line);
    last = line.vertices[1];
  }
  ends[1] = last;
  return ends;
}

inline std::function<fe::Coordinates(double)>
make_straight(const fe::Coordinates& a, const fe::Coordinates& b)
{
  return [=](const double s)
  {
    return fe::Coordinates{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]),
                           a[2] + s * (b[2] - a[2])};
  };
}

/// A quadratic mesh of lines only, closed by `finish` after the lines.
inline fe::MeshData make_line_mesh()
{
  fe::MeshData mesh;
  mesh.order = 2;
  return mesh;
}

inline void name_point(fe::MeshData& mesh, const unsigned int vertex,
                       const std::string& name)
{
  mesh.points.push_back({vertex, mesh.groups.add(0, {name})});
}

inline structure::Frame make_frame(const std::string& group,
                                   const structure::BeamSection& section)
{
  structure::Frame frame;
  frame.name = "frame on " + group;
  frame.groups = {group};
  frame.section = section;
  return frame;
}

/// EA, GA (both), GJ, EI about the width and about the thickness.
inline structure::BeamSection
make_stiffnesses(const double axial, const double shear, const double torsion,
                 const double bending, const double edgewise)
{
  structure::BeamSection section;
  section.axial_stiffness = axial;
  section.shear_stiffness = {shear, shear};
  section.torsional_stiffness = torsion;
  section.bending_stiffness = {bending, edgewise};
  return section;
}

/// Nearly inextensible and unshearable, EI = 1.
inline const structure::BeamSection slender_beam =
    make_stiffnesses(1e8, 1e8, 1, 1, 1);

inline structure::Support make_clamp(const std::string& group)
{
  structure::Support support = make_support(group, {{true, true, true}});
  support.held_rotations = {{true, true, true}};
  return support;
}

inline structure::PointLoad make_point_load(const std::string& group,
                                            const std::array<double, 3>& force)
{
  structure::PointLoad load;
  load.name = "load on " + group;
  load.groups = {group};
  load.force_direction = force;
  load.force = Signal::constant(0);
  return load;
}

/// Position of a point of a frame at the unknowns u.
inline fe::Coordinates get_frame_position(structure::Structure& structure,
                                          const structure::LoadState& loads,
                                          const double* u,
                                          const std::string& group)
{
  const auto& frames = structure.device_nodes().frames;
  const auto place =
      *structure::find_group_places({group}, frames.mesh, structure.mesh())
           .begin();
  const auto& x = structure.compute_positions(loads, u);
  const auto node = structure.nodes().local(frames.nodes[place].position);
  return {fe::entry(x, 3 * node), fe::entry(x, 3 * node + 1),
          fe::entry(x, 3 * node + 2)};
}

inline Quaternion get_frame_rotation(structure::Structure& structure,
                                     const structure::LoadState& loads,
                                     const double* u, const std::string& group)
{
  const auto& frames = structure.device_nodes().frames;
  const auto place =
      *structure::find_group_places({group}, frames.mesh, structure.mesh())
           .begin();
  const auto& x = structure.compute_positions(loads, u);
  return fe::get_quaternion(
      structure.nodes()
          .rotations[frames.nodes[place].rotations.begin()->second],
      x);
}
} // namespace taut::testing
