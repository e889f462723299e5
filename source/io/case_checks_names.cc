#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/io/case_checks.h>
#include <taut/material/validate.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taut::io
{
namespace
{
using structure::EventDescription;
using structure::Probe;

template <class Item>
std::vector<std::string> names_in(const std::vector<Item>& items)
{
  std::vector<std::string> names;
  for (const Item& item : items)
    names.push_back(item.name);
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Surfaces that carry a film.
std::vector<std::string> film_surfaces(const structure::Device& device)
{
  std::vector<std::string> all;
  for (const structure::Film& film : device.films)
    all.insert(all.end(), film.groups.begin(), film.groups.end());
  return all;
}

/// Refuses a name that is none of `known`; `what` is "film", "bar", ...
void check_name(const CaseText& text, const SectionPath& section,
                const std::string& key, const std::string& name,
                const std::string& what, const std::vector<std::string>& known)
{
  if (contains(known, name))
    return;
  if (name.empty())
    text.refuse(section, key,
                fmt::format("the name of a {} is needed; {}", what,
                            suggest(name, known)));
  text.refuse(
      section, key,
      fmt::format("there is no {} '{}'; {}", what, name, suggest(name, known)));
}

/// Errors: BadInput at the section of the material.
material::Elastomer make_elastomer(const CaseText& text,
                                   const MaterialDraft& draft)
{
  material::Elastomer elastomer{};
  for (const NamedSpring& spring : draft.springs)
    elastomer.springs.push_back(spring.spring);
  for (const NamedNetwork& network : draft.networks)
    elastomer.networks.push_back(network.network);
  for (const NamedFibreFamily& fibres : draft.fibre_families)
  {
    elastomer.fibres.push_back(fibres.family);
    elastomer.fibres.back().direction = {
        {std::cos(fibres.angle), std::sin(fibres.angle)}};
  }
  elastomer.dielectric = draft.dielectric;
  elastomer.density = draft.density;
  try
  {
    material::validate(elastomer);
  }
  catch (const BadInput& problem)
  {
    text.refuse({"Material " + draft.name}, "", problem.message());
  }
  if (!elastomer.dielectric.breakdown.factors.empty() &&
      !std::isfinite(elastomer.dielectric.breakdown.reference))
    text.refuse({"Material " + draft.name, "Dielectric"}, "Breakdown law",
                "there is no Breakdown strength that it multiplies");
  return elastomer;
}

void resolve_materials(const CaseText& text, CaseDraft& draft)
{
  const std::vector<std::string> known = names_in(draft.materials);
  std::vector<material::Elastomer> elastomers;
  for (const MaterialDraft& material : draft.materials)
    elastomers.push_back(make_elastomer(text, material));
  for (std::size_t i = 0; i < draft.film_materials.size(); ++i)
  {
    structure::Film& film = draft.content.device.films[i];
    const std::string& name = draft.film_materials[i];
    check_name(text, {"Film " + film.name}, "Material", name, "material",
               known);
    const auto position = std::find(known.begin(), known.end(), name);
    film.material = elastomers[position - known.begin()];
    film.thermal = draft.materials[position - known.begin()].thermal;
    film.humidity_laws =
        draft.materials[position - known.begin()].humidity_laws;
  }
}

/// Films carry electrodes and pressures, so their groups are known here.
void check_surfaces(const CaseText& text, const structure::Device& device)
{
  const std::vector<std::string> known = film_surfaces(device);
  for (const auto& electrode : device.electrodes)
    for (const std::string& group : electrode.groups)
      check_name(text, {"Electrode " + electrode.name}, "Surfaces", group,
                 "surface with a film", known);
  for (const auto& pressure : device.pressures)
    for (const std::string& group : pressure.groups)
      check_name(text, {"Pressure " + pressure.name}, "Surfaces", group,
                 "surface with a film", known);
}

std::vector<std::string> films_and_frames(const structure::Device& device)
{
  std::vector<std::string> names = names_in(device.films);
  for (const std::string& name : names_in(device.frames))
    names.push_back(name);
  return names;
}

/// What `Of` of a probe refers to; `known` empty if to a group of the mesh.
struct Referred
{
  std::string what;
  std::vector<std::string> known;
  /// Whether several names are allowed, separated by commas.
  bool is_list = false;
};

Referred referred_by(const Probe::Kind kind, const structure::Device& device)
{
  switch (kind)
  {
  case Probe::Kind::position:
  case Probe::Kind::displacement:
  case Probe::Kind::velocity:
  case Probe::Kind::rotation:
  case Probe::Kind::half_angle:
  case Probe::Kind::distance:
    return {};
  case Probe::Kind::volume:
    return {"surface with a film", film_surfaces(device), true};
  case Probe::Kind::bar_displacement:
  case Probe::Kind::bar_velocity:
  case Probe::Kind::bar_rotation:
    return {"bar", names_in(device.bars)};
  case Probe::Kind::voltage:
  case Probe::Kind::charge:
  case Probe::Kind::current:
  case Probe::Kind::capacitance:
    return {"electrode", names_in(device.electrodes)};
  case Probe::Kind::reaction:
    return {"support", names_in(device.supports)};
  case Probe::Kind::frame_force:
  case Probe::Kind::frame_moment:
  case Probe::Kind::frame_strain:
    return {"frame", names_in(device.frames)};
  case Probe::Kind::temperature:
    return {"film or frame", films_and_frames(device)};
  default:
    return {"film", names_in(device.films)};
  }
}

void check_referred(const CaseText& text, const SectionPath& section,
                    const structure::Device& device, const Probe& probe)
{
  const Referred referred = referred_by(probe.kind, device);
  if (referred.what.empty())
    return;
  for (const std::string& name : referred.is_list
                                     ? split_list(probe.of)
                                     : std::vector<std::string>{probe.of})
  {
    check_name(text, section, "Of", name, referred.what, referred.known);
    if (std::count(referred.known.begin(), referred.known.end(), name) > 1 &&
        probe.kind == Probe::Kind::temperature)
      text.refuse(section, "Of",
                  fmt::format("a film and a frame are both called '{}'", name));
  }
  if (referred.what == "film" && probe.component > 1)
    text.refuse(section, "Component", "a film has the axes first and second");
}

/// Between which points an angle or a distance is.
void check_two_points(const CaseText& text, const SectionPath& section,
                      const Probe& probe)
{
  const std::vector<std::string> points = split_list(probe.of);
  if (points.size() != 2 || points[0].empty() || points[1].empty() ||
      points[0] == points[1])
    text.refuse(section, "Of",
                "the probe needs two physical points of the mesh, separated "
                "by a comma");
}

void resolve_place(const CaseText& text, const SectionPath& section,
                   const ProbePoint& point, Probe& probe)
{
  using Kind = Probe::Kind;
  const bool in_frame =
      probe.kind == Kind::frame_force || probe.kind == Kind::frame_moment;
  const bool of_point =
      probe.kind == Kind::position || probe.kind == Kind::displacement ||
      probe.kind == Kind::velocity || probe.kind == Kind::rotation;
  if (!in_frame && !probe.at.empty())
    text.refuse(section, "At", "only a frame force or frame moment has At");
  const bool needs_point =
      (of_point && probe.of.empty()) || (in_frame && probe.at.empty());
  if (needs_point && !point)
    text.refuse(section, "Point",
                fmt::format("the probe needs a place: give Point, or {} for a "
                            "group of the mesh",
                            in_frame ? "At" : "Of"));
  if (!needs_point && point)
    text.refuse(section, "Point",
                "a probe of a named part has no use for Point, which goes with "
                "position, displacement, velocity and rotation and an empty "
                "Of, or with a frame force or moment and an empty At");
  probe.point = point.value_or(probe.point);
}

void resolve_probe(const CaseText& text, const structure::Device& device,
                   const ProbePoint& point, Probe& probe)
{
  const SectionPath section = {"Probe " + probe.name};
  check_referred(text, section, device, probe);
  if (probe.kind == Probe::Kind::half_angle ||
      probe.kind == Probe::Kind::distance)
    check_two_points(text, section, probe);
  resolve_place(text, section, point, probe);
}

void check_watched(const CaseText& text, const EventDescription& event,
                   const structure::Device& device)
{
  const SectionPath section = {"Event " + event.name};
  using Kind = EventDescription::Kind;
  switch (event.kind)
  {
  case Kind::probe_above:
  case Kind::probe_below:
  case Kind::snap_through:
    return check_name(text, section, "Of", event.of, "probe",
                      names_in(device.probes));
  case Kind::self_contact:
    if (!event.of.empty())
      check_name(text, section, "Of", event.of, "frame",
                 names_in(device.frames));
    return;
  case Kind::pull_in:
    if (!event.of.empty())
      text.refuse(section, "Of",
                  "a pull-in is of the whole device, not of a part");
    return;
  case Kind::tension_loss:
  case Kind::wrinkling:
  case Kind::slackness:
  case Kind::breakdown:
    break;
  }
  if (!event.of.empty())
    check_name(text, section, "Of", event.of, "film", names_in(device.films));
}

/// Keys of the other lumped model.
void check_unused(const CaseText& text, const CaseDraft& draft,
                  const std::vector<std::string>& keys)
{
  for (const std::string& key : keys)
  {
    // An effective case holds all keys.
    const Entry* entry = text.find({"Comparison"}, key);
    if (entry && !entry->value.empty() && entry->value != "none")
      text.refuse({"Comparison"}, key,
                  "the key has no meaning for Model = " +
                      draft.comparison_model);
  }
}

void resolve_comparison_resonator(const CaseText& text, CaseDraft& draft)
{
  const SectionPath section = {"Comparison"};
  check_unused(text, draft,
               {"Film", "Legs", "Left body", "Right body", "Angle probe",
                "Chord probe", "Stretch probe"});
  const structure::Device& device = draft.content.device;
  const study::ComparisonDescription& parts = draft.comparison;
  const std::vector<std::string> films = names_in(device.films);
  check_name(text, section, "Active film", parts.active_film, "film", films);
  check_name(text, section, "Passive film", parts.passive_film, "film", films);
  if (parts.active_film == parts.passive_film)
    text.refuse(section, "Passive film",
                "the active and the passive film must be two");
  check_name(text, section, "Electrode", parts.electrode, "electrode",
             names_in(device.electrodes));
  check_name(text, section, "Bar", parts.bar, "bar", names_in(device.bars));
  draft.content.comparison = parts;
}

void check_demes_probes(const CaseText& text, const structure::Device& device,
                        const study::DemesComparisonDescription& parts)
{
  const std::vector<std::string> probes = names_in(device.probes);
  for (const auto& [key, name] : {std::pair{"Angle probe", parts.angle_probe},
                                  {"Chord probe", parts.chord_probe},
                                  {"Stretch probe", parts.stretch_probe}})
    check_name(text, {"Comparison"}, key, name, "probe", probes);
}

void resolve_comparison_demes(const CaseText& text, CaseDraft& draft)
{
  const SectionPath section = {"Comparison"};
  check_unused(text, draft, {"Active film", "Passive film", "Bar"});
  const structure::Device& device = draft.content.device;
  study::DemesComparisonDescription& parts = draft.demes_comparison;
  parts.electrode = draft.comparison.electrode;
  check_name(text, section, "Film", parts.film, "film", names_in(device.films));
  check_name(text, section, "Electrode", parts.electrode, "electrode",
             names_in(device.electrodes));
  if (parts.legs.empty())
    parts.legs.emplace_back();
  for (const std::string& leg : parts.legs)
    check_name(text, section, "Legs", leg, "frame", names_in(device.frames));
  const std::vector<std::string> bodies = names_in(device.bodies);
  check_name(text, section, "Left body", parts.left_body, "rigid body", bodies);
  check_name(text, section, "Right body", parts.right_body, "rigid body",
             bodies);
  if (parts.left_body == parts.right_body)
    text.refuse(section, "Right body", "both ends must be two bodies");
  check_demes_probes(text, device, parts);
  draft.content.demes_comparison = parts;
}

void resolve_comparison(const CaseText& text, CaseDraft& draft)
{
  if (!text.find({"Comparison"}))
    return;
  if (draft.comparison_model == "demes")
    resolve_comparison_demes(text, draft);
  else
    resolve_comparison_resonator(text, draft);
}
} // namespace

void resolve_names(const CaseText& text, CaseDraft& draft)
{
  structure::Device& device = draft.content.device;
  resolve_materials(text, draft);
  resolve_frames(draft);
  check_surfaces(text, device);
  for (std::size_t i = 0; i < device.probes.size(); ++i)
    resolve_probe(text, device, draft.probe_points[i], device.probes[i]);
  for (const EventDescription& event : device.events)
    check_watched(text, event, device);
  resolve_comparison(text, draft);
}
} // namespace taut::io
