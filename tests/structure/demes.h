#pragma once

#include <taut/structure/rest_shape.h>

#include "structure/frames.h"

/// A minimum-energy structure as in prm/demes/dc.prm, built in code.
namespace taut::testing
{
struct Demes
{
  double pre_stretch = 2;
  double film_length = 0.02; ///< L_0 (m)
  double width = 0.04;       ///< W_0 (m)
  double thickness = 5e-4;   ///< of the film and of the legs (m)
  double modulus = 52246.6;  ///< mu (Pa)
  double leg_width = 5.015e-3;
  /// Of the film above the legs (m).
  double offset = 0;
  unsigned int n_cells = 6; ///< along and across the film, even

  double length() const
  {
    return pre_stretch * film_length;
  }
};

/// The film spans the chord between rigid ends; the legs lie beside it and are
/// clamped in their middle.
inline structure::Device make_demes_device(const Demes& demes)
{
  structure::Device device;
  auto film = make_film(material::NeoHookean{demes.modulus}, demes.thickness,
                        {{demes.pre_stretch, 1}});
  film.material.networks = {
      {material::NeoHookean{2.5 * demes.modulus}, 3.82e-4}};
  film.material.density = 960;
  device.films = {film};
  device.electrodes = {make_electrode("film", Signal::constant(0))};
  structure::RectangularSection section;
  section.width = demes.leg_width;
  section.thickness = demes.thickness;
  section.young_modulus = 2e9;
  section.poisson_ratio = 0.35;
  section.density = 1050;
  device.frames = {make_frame("legs", structure::make_section(section))};
  device.frames[0].attachment = structure::Frame::Attachment::nowhere;
  for (const std::string side : {"west", "east"})
  {
    structure::RigidBody body;
    body.name = side;
    body.groups = {side, side + "_legs"};
    const double x = side == "west" ? 0 : demes.length();
    body.centre = {{x, demes.width / 2, -demes.offset}};
    body.mass = 1.0587e-3;
    body.rotary_inertia = {{1.058738e-5, 1.058738e-5, 1e-6}};
    device.bodies.push_back(body);
  }
  device.supports = {make_clamp("middles")};
  device.environment.air_drag = 1e4;
  return device;
}

inline fe::MeshData make_demes_mesh(const Demes& demes)
{
  const unsigned int n = demes.n_cells;
  auto mesh = make_rectangle(n, n, 2, demes.length(), demes.width);
  const double middle = demes.length() / 2, z = -demes.offset;
  for (const double side : {-1., 1.})
  {
    const double y =
        demes.width / 2 + side * (demes.width + demes.leg_width) / 2;
    const auto left =
        add_line(mesh, "legs", n, make_straight({0, y, z}, {middle, y, z}));
    const auto right = add_line(
        mesh, "legs", n, make_straight({middle, y, z}, {demes.length(), y, z}));
    name_point(mesh, left[0], "west_legs");
    name_point(mesh, left[1], "middles");
    name_point(mesh, right[1], "east_legs");
  }
  return mesh;
}

/// End slope (rad, positive if the ends are up) and chord (m).
struct DemesShape
{
  double slope, chord;
};

inline DemesShape measure_demes(structure::Structure& structure,
                                const structure::LoadState& loads,
                                const double* u)
{
  const auto west = get_frame_position(structure, loads, u, "west_legs");
  const auto east = get_frame_position(structure, loads, u, "east_legs");
  const auto turn = get_frame_rotation(structure, loads, u, "east_legs");
  return {-compute_angle(turn, {0, 1, 0}), east[0] - west[0]};
}
} // namespace taut::testing
