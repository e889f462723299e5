#pragma once

#include <taut/study/case.h>

#include <structure/devices.h>

#include <limits>
#include <string>

/// A resonator in the limit where the lumped model is exact.
namespace taut::testing
{
using study::Case;

constexpr double shear_modulus = 40e3;
constexpr double length = 0.02; ///< undeformed, of each strip (m)
constexpr double stretch_1 = 2, stretch_2 = 4;

inline material::Elastomer make_elastomer()
{
  material::Elastomer elastomer;
  elastomer.springs = {material::Gent{0.5 * shear_modulus, 67}};
  for (const double relaxation_time : {0.01, 1., 100.})
    elastomer.networks.push_back(
        {material::Gent{shear_modulus / 6, 67}, relaxation_time});
  elastomer.dielectric.permittivity = material::ConstantPermittivity{4.7};
  elastomer.dielectric.breakdown.reference = 155e6;
  elastomer.density = 960;
  return elastomer;
}

inline structure::Film make_strip(const std::string& group)
{
  structure::Film film;
  film.name = film.groups.emplace_back(group);
  film.material = make_elastomer();
  film.thickness = 1e-3;
  film.pre_stretch = {stretch_1, stretch_2};
  // The lumped strips carry compression, too.
  film.tension_field = false;
  return film;
}

inline structure::EventDescription
make_event(const std::string& name, structure::EventDescription::Kind kind)
{
  structure::EventDescription event;
  event.name = name;
  event.kind = kind;
  event.fatal = true;
  return event;
}

/// The limit R0 of the resonator: rollers at the sides, a guided bar.
inline Case make_case()
{
  Case result;
  result.file = "resonator.prm";
  auto& device = result.device;
  device.mesh.degree = 1;
  device.films = {make_strip("left"), make_strip("right")};
  device.electrodes = {make_electrode(
      "left", Signal::ramp(9300, 0, std::numeric_limits<double>::infinity()))};
  device.electrodes.back().name = "high voltage";
  device.supports = {make_support("west", {true, true, true}),
                     make_support("east", {true, true, true}),
                     make_support("south", {false, true, false}),
                     make_support("north", {false, true, false}),
                     make_support("film", {false, false, true})};
  structure::RigidBar bar;
  bar.name = "rod";
  bar.groups = {"middle"};
  bar.mass = 0.02;
  bar.free = {true, false, false};
  bar.rotates = false;
  device.bars = {bar};
  device.events = {
      make_event("slack", structure::EventDescription::Kind::tension_loss),
      make_event("spark", structure::EventDescription::Kind::breakdown)};
  result.comparison =
      study::ComparisonDescription{"left", "right", "high voltage", "rod"};
  result.procedure.analysis = structure::Analysis::quasi_static;
  result.procedure.start = structure::Start::unrelaxed;
  result.procedure.end_time = 2;
  result.procedure.integrator.method = time::Method::bdf;
  result.procedure.integrator.internal_tolerance = 1e-9;
  result.output.history_intervals = 100;
  return result;
}

/// The strips behind one another along x, framed, the left one `ratio` times as
/// long as the right.
inline fe::MeshData make_mesh(const unsigned int n = 2, const double ratio = 1)
{
  const double right = stretch_1 * length, left = ratio * right;
  return make_grid(n, n / 2, 1,
                   [=](const double xi, const double eta)
                   {
                     const double x =
                         xi < 0.5 ? 2 * xi * left : left + (2 * xi - 1) * right;
                     return fe::Coordinates{x, eta * stretch_2 * length, 0.};
                   });
}
} // namespace taut::testing
