#include <taut/base/exceptions.h>
#include <taut/study/resonator_equivalent.h>

#include <algorithm>
#include <cmath>

#include "comparison_checks.h"
#include "resonator_equivalent_material.h"
#include "resonator_equivalent_strip.h"

namespace taut::study
{
namespace
{
using structure::Film;
using structure::RigidBar;
using structure::Support;

const std::array<const char*, 3> axis_names{{"x", "y", "z"}};

void check_parts(const Case& film_case)
{
  const structure::Device& device = film_case.device;
  const ComparisonDescription& parts = *film_case.comparison;
  if (parts.active_film == parts.passive_film)
    refuse(film_case, "the active and the passive film are both '" +
                          parts.active_film + "'");
  check_no_others(film_case, "Film", device.films,
                  {parts.active_film, parts.passive_film});
  check_no_others(film_case, "Electrode", device.electrodes, {parts.electrode});
  check_no_others(film_case, "Bar", device.bars, {parts.bar});
}

/// The parts of a case and their place in the mesh.
struct Parts
{
  const Case& film_case;
  const fe::MeshData& mesh;
  const Film& active;
  const Film& passive;
  const structure::Electrode& electrode;
  const RigidBar& bar;
  FilmStrip strip_active;
  FilmStrip strip_passive;
  double sign;

  unsigned int along() const
  {
    return strip_active.along;
  }
  double size() const
  {
    return strip_active.width();
  }
  /// The line between the films, and the ends in the frame.
  double get_middle() const
  {
    return sign > 0 ? strip_active.high[along()] : strip_active.low[along()];
  }
  double get_end_active() const
  {
    return sign > 0 ? strip_active.low[along()] : strip_active.high[along()];
  }
  double get_end_passive() const
  {
    return sign > 0 ? strip_passive.high[along()] : strip_passive.low[along()];
  }
};

Parts find_parts(const Case& film_case, const fe::MeshData& mesh)
{
  const structure::Device& device = film_case.device;
  const ComparisonDescription& names = *film_case.comparison;
  const Film& active = find(film_case, device.films, names.active_film, "film");
  const Film& passive =
      find(film_case, device.films, names.passive_film, "film");
  Parts parts{film_case,
              mesh,
              active,
              passive,
              find(film_case, device.electrodes, names.electrode, "electrode"),
              find(film_case, device.bars, names.bar, "bar"),
              measure_strip(active, mesh, film_case.file),
              measure_strip(passive, mesh, film_case.file),
              1};
  const unsigned int along = parts.along();
  parts.sign =
      parts.strip_passive.low[along] > parts.strip_active.low[along] ? 1 : -1;
  return parts;
}

void check_films(const Parts& parts)
{
  const FilmStrip &a = parts.strip_active, &b = parts.strip_passive;
  const double near =
      parts.sign > 0 ? b.low[parts.along()] : b.high[parts.along()];
  bool aligned = a.along == b.along && a.across == b.across &&
                 is_same_length(near, parts.get_middle(), parts.size());
  for (unsigned int c = 0; c < 3; ++c)
    aligned = aligned && (c == parts.along() ||
                          (is_same_length(a.low[c], b.low[c], parts.size()) &&
                           is_same_length(a.high[c], b.high[c], parts.size())));
  if (!aligned)
    refuse(parts.film_case, "Film", parts.passive,
           "the lumped model needs both films side by side, one behind the "
           "other along their first axis and equally wide");
  check_same(parts.active, parts.passive, parts.film_case.file);
}

void check_electrode(const Parts& parts)
{
  if (parts.electrode.control != structure::Electrode::Control::voltage)
    refuse(parts.film_case, "Electrode", parts.electrode,
           "the source of the lumped resonator holds the voltage: it needs "
           "Control = voltage");
  if (find_quads(parts.electrode.groups, parts.mesh) !=
      find_quads(parts.active.groups, parts.mesh))
    refuse(parts.film_case, "Electrode", parts.electrode,
           "the electrode of the lumped model covers the whole film '" +
               parts.active.name + "' and nothing else");
}

void check_bar(const Parts& parts)
{
  const unsigned int along = parts.along();
  if (!lie_at(find_line_points(parts.bar.groups, parts.mesh), along,
              parts.get_middle(), parts.size()))
    refuse(parts.film_case, "Bar", parts.bar,
           "the bar of the lumped model lies on the line between the films");
  if (!parts.bar.free[along])
    refuse(parts.film_case, "Bar", parts.bar,
           std::string("the bar of the lumped model moves along ") +
               axis_names[along] + ", which Free does not list");
}

/// Whether any support holds the line of the mesh at an end of the films.
bool is_end_held(const Parts& parts, const double end)
{
  for (const Support& support : parts.film_case.device.supports)
    if (support.held[parts.along()])
      for (const std::string& group : support.groups)
        if (lie_at(find_line_points({group}, parts.mesh), parts.along(), end,
                   parts.size()))
          return true;
  return false;
}

void check_ends(const Parts& parts)
{
  const auto require = [&](const Film& film, const double end)
  {
    if (!is_end_held(parts, end))
      refuse(
          parts.film_case, "Film", film,
          std::string("the lumped model needs its far end to be held along ") +
              axis_names[parts.along()] +
              " by a support of a group of lines there");
  };
  require(parts.active, parts.get_end_active());
  require(parts.passive, parts.get_end_passive());
}

std::string find_end_support(const Parts& parts)
{
  for (const Support& support : parts.film_case.device.supports)
  {
    const bool only_lines =
        std::all_of(support.groups.begin(), support.groups.end(),
                    [&](const std::string& group)
                    { return parts.mesh.groups.has(1, group); });
    if (support.held[parts.along()] && only_lines &&
        lie_at(find_line_points(support.groups, parts.mesh), parts.along(),
               parts.get_end_active(), parts.size()))
      return support.name;
  }
  return "";
}

/// Whether a support holds points of the long sides away from both ends along
/// the motion.
bool are_sides_clamped(const Parts& parts)
{
  const FilmStrip& strip = parts.strip_active;
  for (const Support& support : parts.film_case.device.supports)
    if (support.held[parts.along()])
      for (const auto& point : find_line_points(support.groups, parts.mesh))
        if (is_same_length(point[parts.along()], parts.get_middle(),
                           parts.size()) &&
            (is_same_length(point[strip.across], strip.low[strip.across],
                            parts.size()) ||
             is_same_length(point[strip.across], strip.high[strip.across],
                            parts.size())))
          return true;
  return false;
}

double measure_bar(const Parts& parts)
{
  const unsigned int across = parts.strip_active.across;
  const auto points = find_line_points(parts.bar.groups, parts.mesh);
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(),
      [&](const auto& a, const auto& b) { return a[across] < b[across]; });
  return (*high)[across] - (*low)[across];
}

std::vector<std::string> list_ignored(const Parts& parts)
{
  std::vector<std::string> ignored;
  if (are_sides_clamped(parts))
    ignored.push_back("the side edges hold the film along the motion");
  const double width = parts.strip_active.width();
  if (!is_same_length(measure_bar(parts), width, width))
    ignored.push_back("the bar ends before the side edges");
  bool others = parts.bar.rotates;
  for (unsigned int c = 0; c < 3; ++c)
    others = others || (c != parts.along() && parts.bar.free[c]);
  if (others)
    ignored.push_back("the bar may also turn or move across");
  if (parts.film_case.device.environment.air_drag > 0)
    ignored.push_back("the air drags");
  return ignored;
}
} // namespace

void check_comparable(const Case& film_case)
{
  if (!film_case.comparison)
    throw BadInput("the case has no section 'Comparison' that says which "
                   "parts stand for those of the lumped model",
                   film_case.file, 0, "");
  if (film_case.procedure.analysis == structure::Analysis::equilibrium ||
      film_case.procedure.analysis == structure::Analysis::continuation)
    throw BadInput("the lumped model has no static analysis; "
                   "'quasi-static' and 'transient' are allowed",
                   film_case.file, 0, "Procedure/Analysis");
  check_parts(film_case);
  check_loads(film_case);
}

ResonatorEquivalent make_resonator_equivalent(const Case& film_case,
                                              const fe::MeshData& mesh)
{
  check_comparable(film_case);
  const Parts parts = find_parts(film_case, mesh);
  check_films(parts);
  check_electrode(parts);
  check_bar(parts);
  check_ends(parts);
  ResonatorEquivalent result;
  LumpedResonatorDescription& resonator = result.resonator;
  read_film(parts.active, film_case.file, resonator);
  resonator.length_active =
      parts.strip_active.length() / resonator.pre_stretch[0];
  resonator.length_passive =
      parts.strip_passive.length() / resonator.pre_stretch[0];
  resonator.width = parts.strip_active.width() / resonator.pre_stretch[1];
  resonator.bar_mass = parts.bar.mass;
  resonator.voltage = parts.electrode.voltage;
  result.component = parts.along();
  result.sign = parts.sign;
  result.end_support = find_end_support(parts);
  result.ignored = list_ignored(parts);
  return result;
}
} // namespace taut::study
