#pragma once

#include <cmath>
#include <memory>

#include "structure/devices.h"

/// The film of all benchmarks: a square of 50 mm, stretched by 1.5 in both
/// directions, clamped at its edges, with an electrode in its middle and a
/// pressure on the whole of it.
namespace taut::benchmarks
{
constexpr double side = 0.05;        ///< (m)
constexpr double thickness = 0.5e-3; ///< undeformed (m)
constexpr double pre_stretch = 1.5;
constexpr double shear_modulus = 20e3; ///< of the spring (Pa)
constexpr double density = 1000;       ///< (kg/m^3)
/// Tension (N/m) and lowest frequency (Hz) of the relaxed film.
const double tension =
    thickness * shear_modulus * (1 - std::pow(pre_stretch, -6));
const double frequency =
    std::sqrt(2 * tension * pre_stretch * pre_stretch / (density * thickness)) /
    (2 * side);

struct SquareFilm
{
  unsigned int degree = 2;
  unsigned int cells_per_side = 8;
  bool networks = true;   ///< 0.01, 1 and 100 s
  double limit = 0;       ///< J_lim of Gent springs; 0: neo-Hookean
  bool stiff_row = false; ///< a row of cells 1e4 times stiffer
  double pressure = 2;    ///< (Pa)
  double voltage = 1100;  ///< of the electrode (V)
  double damping = 0;     ///< air drag, relative to the critical one
  double width_share = 1; ///< of the pre-stretch, across
};

inline material::Spring make_spring(const SquareFilm& square,
                                    const double modulus)
{
  if (square.limit > 0)
    return material::Gent{modulus, square.limit};
  return material::NeoHookean{modulus};
}

/// The film's material, its moduli multiplied by `factor`.
inline structure::Film make_film(const SquareFilm& square,
                                 const std::string& group, const double factor)
{
  auto film =
      testing::make_film(make_spring(square, factor * shear_modulus), thickness,
                         {{pre_stretch, square.width_share * pre_stretch}});
  film.name = group;
  film.groups = {group};
  film.material.density = density;
  film.material.dielectric.permittivity = material::ConstantPermittivity{4.7};
  if (square.networks)
    film.material.networks = {{make_spring(square, factor * 10e3), 0.01},
                              {make_spring(square, factor * 5e3), 1},
                              {make_spring(square, factor * 5e3), 100}};
  return film;
}

/// A film 1e4 times stiffer with the same tension and mass per area.
inline structure::Film make_stiff_film(const SquareFilm& square)
{
  constexpr double stiffness = 1e4;
  const double area_stretch = pre_stretch * pre_stretch;
  auto film = make_film(square, "stiff", stiffness * area_stretch);
  film.thickness = thickness / area_stretch;
  const double stretch =
      std::pow(1 - (1 - std::pow(pre_stretch, -6)) / stiffness, -1. / 6);
  film.pre_stretch = {{stretch, stretch}};
  return film;
}

/// Groups `soft` and, one row across the film, `stiff`; `electrode` on the
/// middle quarter; `film` on all.
inline fe::MeshData make_square(const SquareFilm& square)
{
  const unsigned int n = square.cells_per_side;
  auto mesh = testing::make_rectangle(n, n, square.degree, side, side);
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
    {
      const auto is_middle = [n](const unsigned int k)
      { return 4 * k >= n && 4 * k < 3 * n; };
      std::set<std::string> names{"film", "soft"};
      if (square.stiff_row && j == n / 8)
        names = {"film", "stiff"};
      else if (is_middle(i) && is_middle(j))
        names.insert("electrode");
      mesh.quads[j * n + i].group_set = mesh.groups.add(2, names);
    }
  return mesh;
}

inline structure::Device make_device(const SquareFilm& square)
{
  structure::Device device;
  device.mesh.degree = square.degree;
  device.films = {make_film(square, "soft", 1)};
  if (square.stiff_row)
    device.films.push_back(make_stiff_film(square));
  device.electrodes = {
      testing::make_electrode("electrode", Signal::constant(square.voltage))};
  for (const auto* edge : {"west", "east", "south", "north"})
    device.supports.push_back(
        testing::make_support(edge, {{true, true, true}}));
  structure::Pressure pressure;
  pressure.name = "pressure";
  pressure.groups = {"film"};
  pressure.pressure = Signal::constant(square.pressure);
  device.pressures = {pressure};
  device.environment.air_drag =
      2 * square.damping * density * 2 * std::acos(-1.) * frequency;
  return device;
}

inline std::unique_ptr<testing::Model> make_model(const SquareFilm& square)
{
  return std::make_unique<testing::Model>(make_device(square),
                                          make_square(square));
}
} // namespace taut::benchmarks
