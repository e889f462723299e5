#pragma once

#include <taut/study/case.h>

#include "structure/bow.h"

/// A bow between heavy dumb-bells as a case, in the limit where a lumped DEMES
/// is exact: a film of held width, ends without mass, hardly any mass between.
namespace taut::testing
{
constexpr double end_inertia = 1.058738e-5; ///< of each end (kg m^2)

inline structure::Probe make_probe(const std::string& name,
                                   const structure::Probe::Kind kind,
                                   const std::string& of)
{
  structure::Probe probe;
  probe.name = name;
  probe.kind = kind;
  probe.of = of;
  return probe;
}

inline void add_probes(structure::Device& device)
{
  using Kind = structure::Probe::Kind;
  device.probes = {
      make_probe("angle", Kind::half_angle, "beam_west, beam_east"),
      make_probe("chord", Kind::distance, "south_west, south_east"),
      make_probe("stretch", Kind::mean_stretch, "film")};
  device.probes[0].component = 1;
}

/// From rest driven by 5 kV, which come within 20 ms, slowly for the chord's
/// own oscillation.
inline study::Case make_demes_case(const Bow& bow, const double end_time)
{
  study::Case result;
  result.file = "bow.prm";
  structure::Device& device = result.device;
  device = make_bow_device(bow);
  auto& film = device.films[0];
  film.material.networks = {{material::NeoHookean{2.5 * bow.modulus}, 3.82e-4,
                             material::FlowLaw::held_width}};
  film.material.dielectric.permittivity = material::StretchPermittivity{};
  film.material.density = 10;
  film.temperature = Signal::constant(299);
  device.electrodes[0].voltage = Signal::table({0, 0.02}, {0, 5000});
  auto& section = device.frames[0].section;
  section.mass_per_length = 1e-3;
  section.rotary_inertia = {1e-10, 1e-10, 1e-10};
  for (auto& body : device.bodies)
    body.rotary_inertia = {end_inertia, end_inertia, end_inertia};
  add_probes(device);
  result.demes_comparison =
      study::DemesComparisonDescription{"film",
                                        device.electrodes[0].name,
                                        {"frame on beam"},
                                        "west",
                                        "east",
                                        "angle",
                                        "chord",
                                        "stretch"};
  result.procedure.shape = study::Shape::rest;
  result.procedure.end_time = end_time;
  result.procedure.integrator.position_tolerance = 1e-6;
  result.output.history_intervals = 200;
  return result;
}

inline fe::MeshData make_demes_mesh(const Bow& bow,
                                    const unsigned int n_film = 2)
{
  auto mesh = make_bow_mesh(bow, n_film);
  name_point(mesh, n_film, "south_east");
  return mesh;
}
} // namespace taut::testing
