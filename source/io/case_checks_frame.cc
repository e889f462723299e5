#include <taut/base/exceptions.h>
#include <taut/io/case_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taut::io
{
namespace
{
using structure::Frame;
using structure::Support;

double length_of(const std::array<double, 3>& direction)
{
  return std::hypot(direction[0], direction[1], direction[2]);
}

bool any_of(const std::array<bool, 3>& flags)
{
  return flags[0] || flags[1] || flags[2];
}

bool any_of(const std::array<double, 3>& values)
{
  return length_of(values) > 0;
}

bool vanishes(const Signal& signal)
{
  return signal.is_constant() && signal.value(0) == 0;
}

/// The values at the start, at the end, around kinks, and at many times
/// between.
std::vector<double> sample(const Signal& signal,
                           const study::ProcedureDescription& procedure)
{
  const double start = procedure.start_time, end = procedure.end_time;
  if (signal.is_constant())
    return {signal.value(start)};
  constexpr unsigned int intervals = 1000;
  std::vector<double> values;
  for (unsigned int i = 0; i <= intervals; ++i)
    values.push_back(signal.value(start + (end - start) * i / intervals));
  for (const double kink : signal.kinks(start, end))
  {
    values.push_back(signal.value_before(kink));
    values.push_back(signal.value(kink));
  }
  return values;
}

void check_attachment(const CaseText& text, const Frame& frame,
                      const bool has_films)
{
  const SectionPath section = {"Frame " + frame.name};
  const bool at = frame.attachment == Frame::Attachment::at;
  if (at && frame.attached_at.empty())
    text.refuse(section, "Attached at",
                "Attachment = at needs the points or lines where films follow "
                "the frame");
  if (!at && !frame.attached_at.empty())
    text.refuse(section, "Attached at",
                "places of attachment go with Attachment = at only");
  if (at && !has_films)
    text.refuse(section, "Attachment",
                "the case has no film that could be attached");
}

/// With a general section no width is known that could bound the offset.
void check_offset(const CaseText& text, const Frame& frame,
                  const FrameDraft& draft)
{
  const SectionPath section = {"Frame " + frame.name};
  if (!draft.offset && frame.section.thickness == 0)
    text.refuse(section, "Offset",
                "half of the frame's thickness needs the thickness: give "
                "Depth");
  const double width = draft.rectangle.width;
  if (draft.section == "rectangle" && std::abs(frame.offset) > width)
    text.refuse(section, "Offset",
                fmt::format("the film lies {} m beside the beam's axis, more "
                            "than the width {} m of the frame; a film on its "
                            "face has an offset of half the thickness, "
                            "stand-offs are a Rigid body",
                            std::abs(frame.offset), width));
}

void check_frame(const CaseText& text, const Frame& frame,
                 const FrameDraft& draft, const study::Case& content)
{
  if (length_of(frame.normal) == 0)
    text.refuse({"Frame " + frame.name}, "Normal",
                "the direction has no length");
  check_attachment(text, frame, !content.device.films.empty());
  check_offset(text, frame, draft);
  check_temperature(text, {"Frame " + frame.name}, frame.temperature,
                    frame.modulus_law, "the Modulus law", content.procedure);
  check_humidity(text, {"Frame " + frame.name}, frame.humidity,
                 frame.humidity_law, "the Humidity law", content.procedure);
}

/// Only nodes of frames and rigid bodies have rotations.
bool has_rotations(const structure::Device& device)
{
  return !device.frames.empty() || !device.bodies.empty();
}

/// A support acts on something that the case has.
void check_target(const CaseText& text, const Support& support,
                  const structure::Device& device)
{
  const SectionPath section = {"Support " + support.name};
  if (support.target == Support::Target::film && device.films.empty())
    text.refuse(section, "Acts on", "the case has no film");
  if (support.target == Support::Target::frame && !has_rotations(device))
    text.refuse(section, "Acts on",
                "the case has neither a frame nor a rigid body");
}

void check_rotations(const CaseText& text, const Support& support,
                     const structure::Device& device)
{
  if (!any_of(support.held_rotations))
    return;
  const SectionPath section = {"Support " + support.name};
  if (support.target == Support::Target::film)
    text.refuse(section, "Held rotations",
                "films have no rotations; Acts on must be all or frame");
  if (!has_rotations(device))
    text.refuse(section, "Held rotations",
                "the case has neither a frame nor a rigid body, whose "
                "rotations these are");
}

void check_point_mass(const CaseText& text, const structure::PointMass& mass,
                      const structure::Device& device)
{
  const SectionPath section = {"Point mass " + mass.name};
  if (mass.mass == 0 && !any_of(mass.rotary_inertia))
    text.refuse(section, "Mass", "there is neither mass nor rotary inertia");
  if (any_of(mass.rotary_inertia) && !has_rotations(device))
    text.refuse(section, "Rotary inertia",
                "the case has neither a frame nor a rigid body that turns; a "
                "film takes mass only");
}

/// A force or a moment has a direction, and a direction has a force.
void check_directed(const CaseText& text, const SectionPath& section,
                    const std::string& what, const Signal& signal,
                    const std::array<double, 3>& direction)
{
  if (!vanishes(signal) && length_of(direction) == 0)
    text.refuse(section, what + " direction", "the direction has no length");
  if (vanishes(signal) && length_of(direction) > 0)
    text.refuse(
        section, what,
        fmt::format("{} direction is given, but {} is zero", what, what));
}

void check_point_load(const CaseText& text, const structure::PointLoad& load,
                      const structure::Device& device)
{
  const SectionPath section = {"Point load " + load.name};
  check_directed(text, section, "Force", load.force, load.force_direction);
  check_directed(text, section, "Moment", load.moment, load.moment_direction);
  if (vanishes(load.force) && vanishes(load.moment))
    text.refuse(section, "Force", "there is neither a force nor a moment");
  if (has_rotations(device))
    return;
  for (const auto& [key, given] :
       {std::make_pair("Moment", !vanishes(load.moment)),
        std::make_pair("Follower", load.follower)})
    if (given)
      text.refuse(section, key,
                  "the case has neither a frame nor a rigid body that could "
                  "turn");
}

/// The way to a rest shape softens frames.
void check_rest_shape(const CaseText& text, const study::Case& content)
{
  const study::ProcedureDescription& procedure = content.procedure;
  if (procedure.shape != study::Shape::rest)
    return;
  if (content.device.frames.empty())
    text.refuse({"Procedure"}, "Start shape",
                "a rest shape needs a frame that bends; allowed without one "
                "are meshed and equilibrium");
  if (length_of(procedure.rest_shape.direction) == 0)
    text.refuse({"Procedure", "Rest shape"}, "Direction",
                "the direction has no length");
}

struct ClimateWords
{
  const char *key, *name, *unit;
};

/// Refuses values that a law does not know.
void check_reached(const CaseText& text, const SectionPath& section,
                   const ClimateWords& words, const std::vector<double>& values,
                   const material::LawRange& range, const std::string& law_name)
{
  for (const double value : values)
    if (value < range.lowest || value > range.highest)
      text.refuse(section, words.key,
                  fmt::format("{} reaches {:.6g}{}, but {} holds from {:.6g}{} "
                              "to {:.6g}{}",
                              words.name, value, words.unit, law_name,
                              range.lowest, words.unit, range.highest,
                              words.unit));
}
} // namespace

void check_temperature(const CaseText& text, const SectionPath& section,
                       const Signal& temperature,
                       const material::TemperatureLaw& law,
                       const std::string& law_name,
                       const study::ProcedureDescription& procedure)
{
  check_reached(text, section, {"Temperature", "the temperature", " K"},
                sample(temperature, procedure), material::get_range(law),
                law_name);
}

void check_humidity(const CaseText& text, const SectionPath& section,
                    const Signal& humidity, const material::HumidityLaw& law,
                    const std::string& law_name,
                    const study::ProcedureDescription& procedure)
{
  check_reached(text, section, {"Humidity", "the relative humidity", ""},
                sample(humidity, procedure), material::get_range(law),
                law_name);
}

void resolve_frames(CaseDraft& draft)
{
  auto& frames = draft.content.device.frames;
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const FrameDraft& part = draft.frames[i];
    if (part.section == "rectangle")
      frames[i].section = structure::make_section(part.rectangle);
    frames[i].offset = part.offset.value_or(frames[i].section.thickness / 2);
  }
}

void check_frames(const CaseText& text, const CaseDraft& draft)
{
  const study::Case& content = draft.content;
  const structure::Device& device = content.device;
  for (std::size_t i = 0; i < device.frames.size(); ++i)
    check_frame(text, device.frames[i], draft.frames[i], content);
  if (!device.hinges.empty() && device.frames.empty())
    text.refuse({"Hinge " + device.hinges[0].name}, "",
                "the case has no frame that a hinge could part");
  for (const Support& support : device.supports)
  {
    check_target(text, support, device);
    check_rotations(text, support, device);
  }
  for (const structure::PointMass& mass : device.masses)
    check_point_mass(text, mass, device);
  for (const structure::PointLoad& load : device.point_loads)
    check_point_load(text, load, device);
  check_rest_shape(text, content);
}
} // namespace taut::io
