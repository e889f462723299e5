#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/structure/probes.h>

#include <algorithm>
#include <cmath>

#include "entry_names.h"

namespace taut::structure
{
namespace
{
using Kind = Probe::Kind;

bool is_point(const Kind kind)
{
  return kind == Kind::position || kind == Kind::displacement ||
         kind == Kind::velocity;
}

bool is_rotation(const Kind kind)
{
  return kind == Kind::rotation || kind == Kind::half_angle;
}

bool has_points(const Kind kind)
{
  return is_point(kind) || is_rotation(kind) || kind == Kind::distance;
}

bool is_at_section(const Kind kind)
{
  return kind == Kind::frame_force || kind == Kind::frame_moment;
}

bool needs_frame_fields(const Kind kind)
{
  return is_at_section(kind) || kind == Kind::frame_strain;
}

bool is_bar(const Kind kind)
{
  return kind == Kind::bar_displacement || kind == Kind::bar_velocity ||
         kind == Kind::bar_rotation;
}

bool needs_velocity(const Kind kind)
{
  return kind == Kind::velocity || kind == Kind::bar_velocity;
}

bool needs_film_cells(const Kind kind)
{
  return kind == Kind::mean_stretch || kind == Kind::mean_stress ||
         kind == Kind::min_principal_stress || kind == Kind::max_true_field;
}

bool needs_forces(const Kind kind)
{
  return kind == Kind::charge || kind == Kind::capacitance ||
         kind == Kind::reaction;
}

/// "a, b" to {"a", "b"}.
std::vector<std::string> split(const std::string& list)
{
  std::vector<std::string> parts(1);
  for (const char c : list)
    if (c == ',')
      parts.emplace_back();
    else if (c != ' ')
      parts.back() += c;
  return parts;
}
} // namespace

void Probes::refuse(const Probe& probe, const std::string& message)
{
  throw BadInput(message, "", probe.source_line, "Probe " + probe.name);
}

std::string Probes::get_unit(const Kind kind)
{
  switch (kind)
  {
  case Kind::position:
  case Kind::displacement:
  case Kind::bar_displacement:
  case Kind::distance:
    return "m";
  case Kind::rotation:
  case Kind::half_angle:
    return "rad";
  case Kind::velocity:
  case Kind::bar_velocity:
    return "m/s";
  case Kind::voltage:
    return "V";
  case Kind::charge:
    return "C";
  case Kind::current:
    return "A";
  case Kind::capacitance:
    return "F";
  case Kind::reaction:
  case Kind::frame_force:
    return "N";
  case Kind::frame_moment:
    return "N m";
  case Kind::temperature:
    return "K";
  case Kind::mean_stress:
  case Kind::min_principal_stress:
    return "Pa";
  case Kind::max_true_field:
    return "V/m";
  case Kind::volume:
    return "m^3";
  case Kind::bar_rotation:
  case Kind::mean_stretch:
  case Kind::frame_strain:
    break;
  }
  return "1";
}

Probes::Probes(StructureSystem& system)
    : system_(system), descriptions_(system.structure().device().probes)
{
  for (const auto& probe : descriptions_)
  {
    if (needs_velocity(probe.kind) && !system_.has_inertia())
      refuse(probe, "a run without inertia has no velocities");
    points_.push_back(find_points(probe));
    targets_.push_back(find_target(probe));
    sections_.push_back(is_at_section(probe.kind)
                            ? find_sections(probe, targets_.back())
                            : std::vector<Section>());
    groups_.emplace_back();
    if (probe.kind == Kind::volume)
      for (const auto& group : split(probe.of))
      {
        system_.structure().mesh().groups.get_ids(2, group);
        groups_.back().push_back(group);
      }
  }
}

std::size_t Probes::find_target(const Probe& probe) const
{
  const Device& device = system_.structure().device();
  const auto find = [&](const std::vector<std::string>& names,
                        const std::string& what) -> std::size_t
  {
    const auto found = std::find(names.begin(), names.end(), probe.of);
    if (found == names.end())
      refuse(probe, "there is no " + what + " '" + probe.of + "'; " +
                        suggest(probe.of, names));
    return found - names.begin();
  };
  if (has_points(probe.kind) || probe.kind == Kind::volume)
    return 0;
  if (is_bar(probe.kind))
    return find(get_names(device.bars), "bar");
  if (probe.kind == Kind::reaction)
    return find(get_names(device.supports), "support");
  if (probe.kind == Kind::voltage || probe.kind == Kind::current ||
      needs_forces(probe.kind))
  {
    const std::size_t electrode =
        find(get_names(device.electrodes), "electrode");
    if (probe.kind == Kind::current &&
        device.electrodes[electrode].control == Electrode::Control::voltage)
      refuse(probe, "electrode '" + probe.of +
                        "' is held at its voltage, whatever the current: only "
                        "Control = charge or circuit has one to show");
    return electrode;
  }
  if (needs_frame_fields(probe.kind))
    return find(get_names(device.frames), "frame");
  auto films = get_names(device.films);
  if (probe.kind != Kind::temperature)
    return find(films, "film");
  const auto frames = get_names(device.frames);
  films.insert(films.end(), frames.begin(), frames.end());
  return find(films, "film or frame");
}

std::vector<Probes::Point> Probes::find_points(const Probe& probe) const
{
  std::vector<Point> points;
  if (!has_points(probe.kind))
    return points;
  const bool is_between =
      probe.kind == Kind::half_angle || probe.kind == Kind::distance;
  for (const auto& group :
       is_between ? split(probe.of) : std::vector<std::string>{probe.of})
    points.push_back(find_point(probe, group));
  if (is_between && points.size() != 2)
    refuse(probe, "it needs two physical points, not " +
                      std::to_string(points.size()));
  for (const auto& point : points)
    if (is_rotation(probe.kind) && !point.rotation)
      refuse(probe, "no node of a frame lies at its point: films have no "
                    "rotations");
  return points;
}

std::vector<double> Probes::evaluate(const double time, const double* state)
{
  Structure& structure = system_.structure();
  const LoadState loads = system_.loads_at(time, state);
  const bool forces =
      std::any_of(descriptions_.begin(), descriptions_.end(),
                  [](const Probe& probe) { return needs_forces(probe.kind); });
  if (forces)
  {
    std::vector<double> unused(structure.n_free());
    structure.compute_forces(loads, state, system_.internal(state),
                             Networks::as_given, unused.data(), nullptr);
  }
  // Not a copy, which would lose the values at ghosts.
  const fe::NodalVector& positions = structure.compute_positions(loads, state);
  fe::NodalVector velocities;
  const double* v = system_.velocities(state);
  if (v)
    velocities = structure.compute_velocities(loads, v);
  std::vector<FrameElementFields> fields;
  if (std::any_of(descriptions_.begin(), descriptions_.end(),
                  [](const Probe& probe)
                  { return needs_frame_fields(probe.kind); }))
    fields = compute_frame_fields(structure, loads, state);
  std::vector<double> values;
  for (std::size_t i = 0; i < descriptions_.size(); ++i)
  {
    const Kind kind = descriptions_[i].kind;
    if (is_point(kind) || kind == Kind::distance)
      values.push_back(evaluate_point(i, positions, v ? &velocities : nullptr));
    else if (is_bar(kind))
      values.push_back(evaluate_bar(i, positions, v ? &velocities : nullptr));
    else if (is_rotation(kind))
      values.push_back(evaluate_rotation(i, positions));
    else if (needs_frame_fields(kind))
      values.push_back(evaluate_frame(i, fields));
    else if (needs_film_cells(kind))
      values.push_back(evaluate_film(i, loads, state, system_.internal(state)));
    else
      values.push_back(evaluate_device(i, loads));
  }
  return values;
}

double Probes::evaluate_bar(const std::size_t probe,
                            const fe::NodalVector& positions,
                            const fe::NodalVector* velocities) const
{
  const Structure& structure = system_.structure();
  const fe::Nodes& nodes = structure.nodes();
  const Probe& description = descriptions_[probe];
  const fe::Bar& bar = nodes.bars[targets_[probe]];
  const unsigned int c = description.component;
  double value = 0;
  if (bar.centre < nodes.n_owned)
  {
    if (description.kind == Kind::bar_velocity)
      value = fe::entry(*velocities, 3 * bar.centre + c);
    else if (description.kind == Kind::bar_displacement)
      value = fe::entry(positions, 3 * bar.centre + c) -
              nodes.mesh_position[bar.centre][c];
    else
    {
      double square = 0;
      for (unsigned int i = 0; i < 3; ++i)
        square += std::pow(fe::entry(positions, 3 * bar.director + i), 2);
      value = fe::entry(positions, 3 * bar.director + c) / std::sqrt(square) -
              nodes.mesh_position[bar.director][c] / bar.half_length;
    }
  }
  return dealii::Utilities::MPI::sum(value, structure.communicator());
}

double Probes::evaluate_temperature(const std::size_t probe,
                                    const LoadState& loads) const
{
  const std::size_t target = targets_[probe];
  const std::size_t n_films = loads.film_temperatures.size();
  return target < n_films ? loads.film_temperatures[target]
                          : loads.frame_temperatures[target - n_films];
}

double Probes::evaluate_current(const std::size_t electrode,
                                const LoadState& loads) const
{
  const Electrode& description =
      system_.structure().device().electrodes[electrode];
  return description.control == Electrode::Control::circuit
             ? compute_currents(description, loads.source_voltages[electrode],
                                loads.voltages[electrode])
                   .source
             : loads.charge_rates[electrode];
}

double Probes::evaluate_device(const std::size_t probe,
                               const LoadState& loads) const
{
  const Structure& structure = system_.structure();
  const Probe& description = descriptions_[probe];
  const std::size_t target = targets_[probe];
  switch (description.kind)
  {
  case Kind::voltage:
    return loads.voltages[target];
  case Kind::current:
    return evaluate_current(target, loads);
  case Kind::charge:
    return structure.compute_charges(loads)[target];
  case Kind::capacitance:
    return structure.compute_capacitances()[target];
  case Kind::temperature:
    return evaluate_temperature(probe, loads);
  case Kind::reaction:
    return structure.compute_reaction(target)[description.component];
  default:
    return structure.compute_volume(groups_[probe]);
  }
}
} // namespace taut::structure
