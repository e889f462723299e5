#include <taut/base/exceptions.h>
#include <taut/study/demes_equivalent.h>

#include <algorithm>
#include <cmath>

#include "comparison_checks.h"
#include "demes_equivalent_film.h"
#include "demes_equivalent_legs.h"
#include "resonator_equivalent_strip.h"

namespace taut::study
{
namespace
{
using structure::Film;
using structure::Probe;
using structure::RigidBody;

void check_procedure(const Case& film_case)
{
  const ProcedureDescription& procedure = film_case.procedure;
  const auto refuse_key = [&](const char* key, const char* message)
  {
    throw BadInput(message, film_case.file, 0, std::string("Procedure/") + key);
  };
  if (procedure.analysis != structure::Analysis::transient)
    refuse_key("Analysis", "the lumped DEMES has the analysis 'transient' "
                           "only");
  if (procedure.shape == Shape::meshed)
    refuse_key("Start shape", "both models start at rest: 'rest' and "
                              "'equilibrium' are allowed, 'meshed' is not");
  if (procedure.start != structure::Start::relaxed)
    refuse_key("Start", "the lumped DEMES starts 'relaxed'");
}

void check_parts(const Case& film_case)
{
  const structure::Device& device = film_case.device;
  const DemesComparisonDescription& parts = *film_case.demes_comparison;
  check_no_others(film_case, "Film", device.films, {parts.film});
  check_no_others(film_case, "Electrode", device.electrodes, {parts.electrode});
  check_no_others(film_case, "Rigid body", device.bodies,
                  {parts.left_body, parts.right_body});
  check_no_others(film_case, "Bar", device.bars, {});
  check_no_others(film_case, "Hinge", device.hinges, {});
  check_no_others(film_case, "Point load", device.point_loads, {});
}

/// Frames beside the legs must be part of the rigid ends.
void check_frames(const Case& film_case)
{
  const DemesComparisonDescription& parts = *film_case.demes_comparison;
  const auto is_rigid = [&](const std::string& group)
  {
    const auto& bodies = film_case.device.bodies;
    return std::any_of(bodies.begin(), bodies.end(),
                       [&](const RigidBody& body)
                       {
                         return std::find(body.groups.begin(),
                                          body.groups.end(),
                                          group) != body.groups.end();
                       });
  };
  for (const structure::Frame& frame : film_case.device.frames)
    if (std::find(parts.legs.begin(), parts.legs.end(), frame.name) ==
            parts.legs.end() &&
        !std::all_of(frame.groups.begin(), frame.groups.end(), is_rigid))
      refuse(film_case, "Frame", frame,
             "the lumped DEMES has legs that bend and rigid ends: this frame "
             "is neither one of the Legs, nor in the rigid bodies with all of "
             "its lines");
}

void check_probe(const Case& film_case, const std::string& name,
                 const std::vector<Probe::Kind>& kinds, const std::string& what)
{
  const Probe& probe = find(film_case, film_case.device.probes, name, "probe");
  if (std::find(kinds.begin(), kinds.end(), probe.kind) == kinds.end())
    refuse(film_case, "Probe", probe, "the comparison needs " + what);
}

void check_probes(const Case& film_case)
{
  using Kind = Probe::Kind;
  const DemesComparisonDescription& parts = *film_case.demes_comparison;
  // The rotation of an end is half of the arc's angle if the middle is held.
  check_probe(film_case, parts.angle_probe, {Kind::half_angle, Kind::rotation},
              "a half angle, or the rotation of an end, as Angle probe");
  check_probe(film_case, parts.chord_probe, {Kind::distance},
              "a distance as Chord probe");
  check_probe(film_case, parts.stretch_probe, {Kind::mean_stretch},
              "a mean stretch as Stretch probe");
}

double read_inertia(const Case& film_case, const std::string& name,
                    const unsigned int across)
{
  const RigidBody& body =
      find(film_case, film_case.device.bodies, name, "rigid body");
  if (!(body.rotary_inertia[across] > 0))
    refuse(film_case, "Rigid body", body,
           "the lumped DEMES needs the rotary inertia of its ends about the "
           "direction across the film");
  return body.rotary_inertia[across];
}

bool is_width_held(const structure::Device& device, const Film& film,
                   const unsigned int across)
{
  if (film.fibre_modulus > 0)
    return true;
  return std::any_of(device.supports.begin(), device.supports.end(),
                     [&](const structure::Support& support)
                     {
                       return support.held[across] &&
                              std::find(
                                  support.groups.begin(), support.groups.end(),
                                  film.groups.front()) != support.groups.end();
                     });
}

std::vector<std::string> list_ignored_of_film(const Case& film_case,
                                              const Film& film,
                                              const unsigned int across)
{
  std::vector<std::string> ignored;
  if (!is_width_held(film_case.device, film, across))
    ignored.push_back("the width of the film is free, theirs is held");
  for (const auto& network : film.material.networks)
    if (network.flow == material::FlowLaw::isotropic)
      ignored.push_back("the film's network flows in all directions, theirs "
                        "along the film only");
  if (film.tension_field)
    ignored.push_back("the film wrinkles and goes slack, theirs can push");
  if (film.material.density > 0)
    ignored.push_back("the film has mass: it lags, and waves run along it");
  if (film_case.device.environment.air_drag > 0)
    ignored.push_back("the air drags");
  return ignored;
}

void list_ignored_of_frame(const Case& film_case,
                           std::vector<std::string>& ignored)
{
  const structure::Device& device = film_case.device;
  const auto any = [&](const auto& has)
  { return std::any_of(device.frames.begin(), device.frames.end(), has); };
  using structure::Frame;
  if (any([](const Frame& frame) { return frame.section.mass_per_length > 0; }))
    ignored.push_back("the frame has mass");
  if (any([](const Frame& frame)
          { return frame.mass_damping > 0 || frame.stiffness_damping > 0; }))
    ignored.push_back("the frame is damped");
  if (any([](const Frame& frame)
          { return frame.attachment != Frame::Attachment::nowhere; }))
    ignored.push_back("a frame carries the film along its lines, theirs at the "
                      "ends only");
  if (!device.masses.empty())
    ignored.push_back("there are point masses");
  const bool heavy =
      std::any_of(device.bodies.begin(), device.bodies.end(),
                  [](const RigidBody& body) { return body.mass > 0; });
  if (heavy)
    ignored.push_back("the ends have mass and move, theirs only turn with "
                      "their rotary inertia");
}
} // namespace

void check_comparable_demes(const Case& film_case)
{
  check_procedure(film_case);
  check_parts(film_case);
  check_frames(film_case);
  check_loads(film_case);
  check_probes(film_case);
}

lumped::Demes DemesEquivalent::make_arc() const
{
  return lumped::make_demes(device);
}

lumped::DemesElastica DemesEquivalent::make_elastica() const
{
  lumped::DemesElastica elastica;
  elastica.demes = make_arc();
  elastica.demes.eccentricity = 0;
  elastica.standoff = device.film_offset / leg_length;
  return elastica;
}

DemesEquivalent make_demes_equivalent(const Case& film_case,
                                      const fe::MeshData& mesh)
{
  check_comparable_demes(film_case);
  const structure::Device& parts = film_case.device;
  const DemesComparisonDescription& names = *film_case.demes_comparison;
  const Film& film = find(film_case, parts.films, names.film, "film");
  const auto& electrode =
      find(film_case, parts.electrodes, names.electrode, "electrode");
  if (find_quads(electrode.groups, mesh) != find_quads(film.groups, mesh))
    refuse(film_case, "Electrode", electrode,
           "the electrode of the lumped DEMES covers the whole film");
  if (electrode.control != structure::Electrode::Control::voltage)
    refuse(film_case, "Electrode", electrode,
           "the models are compared at equal voltage: it needs Control = "
           "voltage");
  const FilmStrip strip = measure_strip(film, mesh, film_case.file);
  const LegMeasures legs = measure_legs(film_case, strip, mesh);
  DemesEquivalent result;
  lumped::DemesSI& device = result.device;
  read_demes_film(film_case, film, device);
  device.film_length = strip.length() / film.pre_stretch[0];
  device.film_width = strip.width();
  device.film_offset = legs.offset;
  device.frame_modulus = legs.bending_stiffness;
  device.frame_width = 12;
  device.frame_thickness = 1;
  device.inertia = read_inertia(film_case, names.left_body, strip.across) +
                   read_inertia(film_case, names.right_body, strip.across);
  device.source = electrode.voltage;
  result.bending_stiffness = legs.bending_stiffness;
  result.leg_length = strip.length();
  result.ignored = list_ignored_of_film(film_case, film, strip.across);
  list_ignored_of_frame(film_case, result.ignored);
  return result;
}
} // namespace taut::study
