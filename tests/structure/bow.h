#pragma once

#include <taut/structure/rest_shape.h>

#include "structure/frames.h"

/// The bow: a straight beam whose ends a film pulls together. The film is a
/// strip of neo-Hookean rubber in pure shear, its width is held.
namespace taut::testing
{
struct Bow
{
  double pre_stretch = 2;
  double modulus = 52246.6;    ///< mu (Pa)
  double thickness = 5e-4;     ///< t_0 (m)
  double width = 0.04;         ///< W_0 (m)
  double film_length = 0.02;   ///< L_0 (m)
  double stand_off = 0;        ///< of the film above the beam (m)
  double stiffness_number = 1; ///< K_bb = 4 EI/(L_1 L_0 S)
  unsigned int n_elements = 40;
  /// EA and GA over EI/L_1^2: the axial strain is 1e-7 of the curvature's.
  double inextensibility = 1e7;

  double length() const
  {
    return pre_stretch * film_length;
  }
  double film_force() const
  {
    return modulus * width * thickness;
  }
  double bending_stiffness() const
  {
    return stiffness_number * length() * film_length * film_force() / 4;
  }
};

inline structure::Device make_bow_device(const Bow& bow)
{
  structure::Device device;
  auto film = make_film(material::NeoHookean{bow.modulus}, bow.thickness,
                        {{bow.pre_stretch, 1}});
  film.tension_field = false;
  device.films = {film};
  device.electrodes = {make_electrode("film", Signal::constant(0))};
  const double EI = bow.bending_stiffness();
  const double axial = bow.inextensibility * EI / (bow.length() * bow.length());
  device.frames = {
      make_frame("beam", make_stiffnesses(axial, axial, EI, EI, EI))};
  device.frames[0].attachment = structure::Frame::Attachment::nowhere;
  for (const char* side : {"west", "east"})
  {
    structure::RigidBody body;
    body.name = side;
    body.groups = {side, std::string("beam_") + side};
    const double x = side == std::string("west") ? 0 : bow.length();
    body.centre = {{x, -bow.width, -bow.stand_off}};
    device.bodies.push_back(body);
  }
  auto plane = make_support("beam", {{false, true, false}});
  plane.held_rotations = {{true, false, true}};
  // The film stays flat, as it would by itself: under voltage its held width
  // is compressed, and nothing else keeps a thin film from wrinkling.
  auto middle = make_clamp("beam_middle");
  middle.held = {{true, true, false}};
  device.supports = {make_support("film", {{false, true, true}}), plane,
                     middle};
  return device;
}

inline fe::MeshData make_bow_mesh(const Bow& bow, const unsigned int n_film = 4)
{
  auto mesh = make_rectangle(n_film, 1, 2, bow.length(), bow.width);
  const double y = -bow.width, z = -bow.stand_off, middle = bow.length() / 2;
  const auto left = add_line(mesh, "beam", bow.n_elements / 2,
                             make_straight({0, y, z}, {middle, y, z}));
  const auto right =
      add_line(mesh, "beam", bow.n_elements / 2,
               make_straight({middle, y, z}, {bow.length(), y, z}));
  name_point(mesh, left[0], "beam_west");
  name_point(mesh, left[1], "beam_middle");
  name_point(mesh, right[1], "beam_east");
  return mesh;
}

/// End slope (rad) and chord (m) of a bow.
struct BowShape
{
  double slope, chord, middle;
};

inline BowShape measure_bow(structure::Structure& structure,
                            const structure::LoadState& loads, const double* u)
{
  const auto west = get_frame_position(structure, loads, u, "beam_west");
  const auto east = get_frame_position(structure, loads, u, "beam_east");
  const auto middle = get_frame_position(structure, loads, u, "beam_middle");
  const double slope = compute_angle(
      get_frame_rotation(structure, loads, u, "beam_east"), {0, 1, 0});
  return {std::abs(slope), east[0] - west[0], std::abs(east[2] - middle[2])};
}
} // namespace taut::testing
