#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/structure/probes.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

bool is_bar(const Kind kind)
{
  return kind == Kind::bar_displacement || kind == Kind::bar_velocity ||
         kind == Kind::bar_rotation;
}

bool needs_velocity(const Kind kind)
{
  return kind == Kind::velocity || kind == Kind::bar_velocity;
}

bool needs_forces(const Kind kind)
{
  return kind == Kind::charge || kind == Kind::capacitance ||
         kind == Kind::reaction;
}

[[noreturn]] void refuse(const Probe& probe, const std::string& message)
{
  throw BadInput(message, "", probe.source_line, "Probe " + probe.name);
}

template <typename Entry>
std::size_t find_entry(const std::vector<Entry>& entries, const Probe& probe,
                       const std::string& what)
{
  std::vector<std::string> names;
  for (const auto& entry : entries)
    names.push_back(entry.name);
  const auto found = std::find(names.begin(), names.end(), probe.of);
  if (found == names.end())
    refuse(probe, "there is no " + what + " '" + probe.of + "'; " +
                      suggest(probe.of, names));
  return found - names.begin();
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
    points_.push_back(is_point(probe.kind) ? find_point(probe) : Point());
    targets_.push_back(find_target(probe));
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
  if (is_point(probe.kind) || probe.kind == Kind::volume)
    return 0;
  if (is_bar(probe.kind))
    return find_entry(device.bars, probe, "bar");
  if (probe.kind == Kind::reaction)
    return find_entry(device.supports, probe, "support");
  if (probe.kind == Kind::voltage || needs_forces(probe.kind))
    return find_entry(device.electrodes, probe, "electrode");
  return find_entry(device.films, probe, "film");
}

Probes::Point Probes::find_point(const Probe& probe) const
{
  const Structure& structure = system_.structure();
  const fe::Nodes& nodes = structure.nodes();
  std::array<double, 3> target = probe.point;
  if (!probe.of.empty())
  {
    const auto points = fe::get_group_points(structure.mesh(), probe.of);
    if (points.size() != 1)
      refuse(probe, "the group '" + probe.of + "' has " +
                        std::to_string(points.size()) +
                        " points; a probe needs one");
    target = points.front();
  }
  // The nearest node of the film, and whether it is near enough.
  double nearest = std::numeric_limits<double>::infinity();
  fe::LocalNode node = 0;
  for (fe::LocalNode i = 0; i < nodes.n_owned; ++i)
  {
    const bool of_bar =
        std::any_of(nodes.bars.begin(), nodes.bars.end(),
                    [&](const fe::Bar& bar)
                    { return i == bar.centre || i == bar.director; });
    const auto& x = nodes.mesh_position[i];
    const double distance =
        std::hypot(x[0] - target[0], x[1] - target[1], x[2] - target[2]);
    if (!of_bar && distance < nearest)
    {
      nearest = distance;
      node = i;
    }
  }
  const auto all =
      dealii::Utilities::MPI::all_gather(structure.communicator(), nearest);
  const auto owner = std::min_element(all.begin(), all.end());
  if (*owner > 1e-6 * compute_extent(structure.mesh()))
    refuse(probe, "no node of the mesh lies at its point; the nearest is " +
                      std::to_string(*owner) +
                      " m away: put a point of the "
                      "geometry there");
  const bool mine =
      owner - all.begin() ==
      dealii::Utilities::MPI::this_mpi_process(structure.communicator());
  return mine ? Point{{node, 1.}} : Point();
}

std::vector<double> Probes::evaluate(const double time, const double* state)
{
  Structure& structure = system_.structure();
  const LoadState loads = system_.history().at(time);
  const bool forces =
      std::any_of(descriptions_.begin(), descriptions_.end(),
                  [](const Probe& probe) { return needs_forces(probe.kind); });
  if (forces)
  {
    std::vector<double> unused(structure.n_free());
    structure.compute_forces(loads, state, system_.internal(state),
                             Networks::as_given, unused.data(), nullptr);
  }
  const fe::NodalVector positions = structure.compute_positions(loads, state);
  fe::NodalVector velocities;
  const double* v = system_.velocities(state);
  if (v)
    velocities = structure.compute_velocities(loads, v);
  std::vector<double> values;
  for (std::size_t i = 0; i < descriptions_.size(); ++i)
  {
    const Kind kind = descriptions_[i].kind;
    if (is_point(kind))
      values.push_back(evaluate_point(i, positions, v ? &velocities : nullptr));
    else if (is_bar(kind))
      values.push_back(evaluate_bar(i, positions, v ? &velocities : nullptr));
    else if (kind == Kind::mean_stretch || kind == Kind::mean_stress ||
             kind == Kind::min_principal_stress || kind == Kind::max_true_field)
      values.push_back(evaluate_film(i, loads, state, system_.internal(state)));
    else
      values.push_back(evaluate_device(i, loads));
  }
  return values;
}

double Probes::evaluate_point(const std::size_t probe,
                              const fe::NodalVector& positions,
                              const fe::NodalVector* velocities) const
{
  const Structure& structure = system_.structure();
  const Probe& description = descriptions_[probe];
  double value = 0;
  for (const auto& [node, weight] : points_[probe])
  {
    const unsigned int entry = 3 * node + description.component;
    const double x = fe::entry(positions, entry);
    const double x_0 =
        structure.nodes().mesh_position[node][description.component];
    value += weight * (description.kind == Kind::velocity
                           ? fe::entry(*velocities, entry)
                       : description.kind == Kind::position ? x
                                                            : x - x_0);
  }
  return dealii::Utilities::MPI::sum(value, structure.communicator());
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
  case Kind::charge:
    return structure.compute_charges(loads)[target];
  case Kind::capacitance:
    return structure.compute_capacitances()[target];
  case Kind::reaction:
    return structure.compute_reaction(target)[description.component];
  default:
    return structure.compute_volume(groups_[probe]);
  }
}
} // namespace taut::structure
