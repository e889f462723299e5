#include <taut/base/exceptions.h>
#include <taut/io/case_checks.h>
#include <taut/material/limits.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace taut::io
{
namespace
{
using structure::Film;

/// Whether nothing needs to hold the device: frames carry their own inertia
/// from a start at rest, but no equilibrium is unique without supports.
bool may_drift(const study::Case& content)
{
  return !content.device.frames.empty() &&
         content.procedure.analysis == structure::Analysis::transient &&
         content.procedure.shape == study::Shape::meshed;
}

/// A case has films or frames, and something that holds them.
void check_completeness(const CaseText& text, const study::Case& content)
{
  const structure::Device& device = content.device;
  if (device.films.empty() && device.frames.empty())
    text.refuse({}, "",
                "the case has no film and no frame: a 'subsection Film NAME' "
                "or a 'subsection Frame NAME' is needed");
  const auto holds = [](const structure::Support& support)
  {
    const auto& at = support.held;
    const auto& turn = support.held_rotations;
    return at[0] || at[1] || at[2] || turn[0] || turn[1] || turn[2];
  };
  if (device.supports.empty() && !may_drift(content))
    text.refuse({}, "",
                "the device has no support and would drift freely: a "
                "'subsection Support NAME' is needed, except for frames in a "
                "transient run with Start shape = meshed");
  for (const structure::Support& support : device.supports)
    if (!holds(support))
      text.refuse({"Support " + support.name}, "Held",
                  "the support holds nothing");
}

/// No group belongs to two entries of a kind.
template <class Item>
void check_groups_unique(const CaseText& text, const std::string& kind,
                         const std::string& key, const std::vector<Item>& items)
{
  std::map<std::string, std::string> owners;
  for (const Item& item : items)
    for (const std::string& group : item.groups)
    {
      const auto [owner, is_new] = owners.emplace(group, item.name);
      if (!is_new)
        text.refuse({kind + " " + item.name}, key,
                    fmt::format("the group '{}' belongs to '{} {}' already",
                                group, kind, owner->second));
    }
}

void check_pre_stretch(const CaseText& text, const Film& film,
                       const structure::Start start)
{
  const double first = film.pre_stretch[0], second = film.pre_stretch[1];
  const material::SymmetricTensor2<double> C{first * first, second * second, 0};
  const material::SymmetricTensor2<double> strained{1, 1, 0};
  std::vector<material::SymmetricTensor2<double>> internal;
  for (const material::Network& network : film.material.networks)
    internal.push_back(start == structure::Start::unrelaxed
                           ? strained
                           : material::relaxed_internal(network, C));
  const std::string excess = material::describe_limit(
      film.material, C, internal.data(), material::no_voltage);
  if (!excess.empty())
    text.refuse({"Film " + film.name}, "Pre-stretch",
                "with the pre-stretch " + excess);
}

/// Masses and viscous flow know one pre-stretch only.
void check_pre_stretch_share(const CaseText& text, const Film& film,
                             const study::ProcedureDescription& procedure)
{
  using structure::Analysis;
  const Signal& share = film.pre_stretch_share;
  const bool is_static = procedure.analysis == Analysis::equilibrium ||
                         procedure.analysis == Analysis::continuation;
  if (is_static || (share.is_constant() && share.value(0) == 1))
    return;
  text.refuse({"Film " + film.name}, "Pre-stretch share",
              "a film is stretched in its frame only in static analyses: "
              "'equilibrium' and 'continuation' are allowed");
}

/// A path needs a side to turn to.
void check_continuation(const CaseText& text,
                        const study::ProcedureDescription& procedure)
{
  const auto& direction = procedure.continuation.direction;
  if (std::hypot(direction[0], direction[1], direction[2]) == 0)
    text.refuse({"Procedure", "Continuation"}, "Direction",
                "the direction has no length");
}

/// The climate of a film stays where its breakdown strength is known.
void check_strength(const CaseText& text, const Film& film,
                    const study::ProcedureDescription& procedure)
{
  const std::string name = "the Breakdown law of its material";
  for (const auto& factor : film.material.dielectric.breakdown.factors)
  {
    if (const auto* by_temperature =
            std::get_if<material::TemperatureStrength>(&factor))
      check_temperature(text, {"Film " + film.name}, film.temperature,
                        by_temperature->law, name, procedure);
    if (const auto* by_humidity =
            std::get_if<material::HumidityStrength>(&factor))
      check_humidity(text, {"Film " + film.name}, film.humidity,
                     by_humidity->law, name, procedure);
  }
}

void check_film(const CaseText& text, const Film& film,
                const study::ProcedureDescription& procedure)
{
  check_pre_stretch(text, film, procedure.start);
  check_pre_stretch_share(text, film, procedure);
  check_temperature(text, {"Film " + film.name}, film.temperature,
                    film.thermal.modulus,
                    "the law of the Modulus of its material", procedure);
  check_temperature(text, {"Film " + film.name}, film.temperature,
                    film.thermal.relaxation_time,
                    "the law of the Relaxation time of its material",
                    procedure);
  for (const auto& [law, name] :
       {std::pair(film.humidity_laws.modulus, "Modulus"),
        std::pair(film.humidity_laws.relaxation_time, "Relaxation time"),
        std::pair(film.humidity_laws.permittivity, "Permittivity")})
    check_humidity(text, {"Film " + film.name}, film.humidity, law,
                   "the law of the " + std::string(name) + " of its material",
                   procedure);
  check_strength(text, film, procedure);
  const auto& axis = film.axis;
  if (std::hypot(axis[0], axis[1], axis[2]) == 0)
    text.refuse({"Film " + film.name}, "Axis", "the direction has no length");
  if (film.tension_field && film.fibre_modulus > 0)
    text.refuse({"Film " + film.name}, "Tension field",
                "fibres carry compression, so that their film has none: set "
                "it to false");
}

/// A motion is prescribed completely or not at all.
void check_support(const CaseText& text, const structure::Support& support)
{
  const SectionPath section = {"Support " + support.name};
  const std::array<const char*, 3> axes{{"x", "y", "z"}};
  bool moves = false;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const bool shaped = support.shape[i] != "0";
    if (shaped && !support.held[i])
      text.refuse(section, std::string("Shape ") + axes[i],
                  fmt::format("a displacement along {} is prescribed, but Held "
                              "does not list {}",
                              axes[i], axes[i]));
    moves = moves || shaped;
  }
  const bool at_rest =
      support.amplitude.is_constant() && support.amplitude.value(0) == 0;
  if (moves && at_rest)
    text.refuse(section, "Amplitude",
                "a Shape is given, but its factor Amplitude is zero");
  if (!moves && !at_rest)
    text.refuse(section, "Amplitude", "there is no Shape that it multiplies");
}

void check_edge_load(const CaseText& text, const structure::EdgeLoad& load)
{
  const auto& direction = load.direction;
  if (std::hypot(direction[0], direction[1], direction[2]) == 0)
    text.refuse({"Edge load " + load.name}, "Direction",
                "the direction has no length");
}

/// A breakdown can only be watched where the material states its strength.
void check_event(const CaseText& text, const structure::EventDescription& event,
                 const structure::Device& device)
{
  if (event.kind != structure::EventDescription::Kind::breakdown)
    return;
  if (event.threshold != 0)
    text.refuse({"Event " + event.name}, "Threshold",
                "a breakdown has no threshold; its limit is the Breakdown "
                "strength of the material");
  for (const Film& film : device.films)
    if ((event.of.empty() || event.of == film.name) &&
        std::isfinite(film.material.dielectric.breakdown.reference))
      return;
  text.refuse({"Event " + event.name}, "Kind",
              "no watched film has a material with a Breakdown strength");
}

void check_times_listed(const CaseText& text, const std::string& key,
                        const std::vector<double>& times,
                        const study::ProcedureDescription& procedure)
{
  for (const double time : times)
    if (time < procedure.start_time || time > procedure.end_time)
      text.refuse({"Output"}, key,
                  fmt::format("{} s is not between the start {} s and the end "
                              "{} s of the run",
                              time, procedure.start_time, procedure.end_time));
}

void check_times(const CaseText& text, const study::Case& content)
{
  const study::ProcedureDescription& procedure = content.procedure;
  if (procedure.end_time <= procedure.start_time)
    text.refuse({"Procedure"}, "End time",
                fmt::format("the end {} s must come after the start {} s",
                            procedure.end_time, procedure.start_time));
  check_times_listed(text, "History times", content.output.history_times,
                     procedure);
  check_times_listed(text, "Field times", content.output.field_times,
                     procedure);
}

void check_method(const CaseText& text,
                  const study::ProcedureDescription& procedure)
{
  if (procedure.analysis == structure::Analysis::quasi_static &&
      procedure.integrator.method != time::Method::bdf)
    text.refuse({"Procedure", "Integrator"}, "Method",
                "a quasi-static run needs the method bdf");
}

void check_shares(const CaseText& text,
                  const study::LumpedResonatorDescription& resonator)
{
  const SectionPath section = {"Lumped resonator"};
  const std::size_t n_networks = resonator.relaxation_times.size();
  const auto& shares = resonator.network_shares;
  const double rest = 1 - resonator.equilibrium_share;
  if ((rest > 0) != (n_networks > 0))
    text.refuse(section, "Relaxation times",
                fmt::format("networks carry the share {:.6g} of the modulus "
                            "(1 - Equilibrium share), but {} are given",
                            rest, n_networks));
  if (shares.empty())
    return;
  if (shares.size() != n_networks)
    text.refuse(section, "Network shares",
                fmt::format("{} shares are given for {} relaxation times",
                            shares.size(), n_networks));
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.);
  if (std::abs(sum - rest) > 1e-9)
    text.refuse(section, "Network shares",
                fmt::format("the shares add up to {:.12g}, not to {:.12g} "
                            "(1 - Equilibrium share)",
                            sum, rest));
}

void check_lumped_resonator(const CaseText& text,
                            const study::LumpedResonatorDescription& resonator)
{
  check_shares(text, resonator);
  const double first = resonator.pre_stretch[0];
  const double second = resonator.pre_stretch[1];
  const double invariant =
      first * first + second * second + 1 / (first * first * second * second);
  if (invariant >= resonator.limit + 3)
    text.refuse({"Lumped resonator"}, "Pre-stretch",
                fmt::format("the pre-stretch reaches I1 - 3 = {:.6g}, which "
                            "exceeds Limit = {:.6g}",
                            invariant - 3, resonator.limit));
}

bool is_zero(const Signal& signal)
{
  return signal.is_constant() && signal.value(0) == 0;
}

/// Refuses a key that this control of an electrode lacks, or has no use for and
/// that is not at its default.
void check_key(const CaseText& text, const structure::Electrode& electrode,
               const std::string& key, const bool is_used, const bool is_needed,
               const bool is_default)
{
  const SectionPath section{"Electrode " + electrode.name};
  using Control = structure::Electrode::Control;
  const std::string control = electrode.control == Control::voltage ? "voltage"
                              : electrode.control == Control::charge
                                  ? "charge"
                                  : "circuit";
  const bool is_given = text.find(section, key) != nullptr;
  if (is_given && !is_used && !is_default)
    text.refuse(
        section, key,
        fmt::format("an electrode with Control = {} has no {}", control, key));
  if (!is_given && is_needed)
    text.refuse(section, key,
                fmt::format("it is missing: an electrode with Control = {} "
                            "needs it",
                            control));
}

void check_electrode(const CaseText& text,
                     const structure::Electrode& electrode)
{
  using Control = structure::Electrode::Control;
  const bool charge = electrode.control == Control::charge;
  const bool circuit = electrode.control == Control::circuit;
  check_key(text, electrode, "Voltage", !charge, !charge,
            is_zero(electrode.voltage));
  check_key(text, electrode, "Charge", charge, charge,
            is_zero(electrode.charge));
  check_key(text, electrode, "Series resistance", circuit, circuit,
            electrode.series_resistance == 0);
  check_key(text, electrode, "Leakage resistance", circuit, false,
            std::isinf(electrode.leakage_resistance));
  if (circuit && !(electrode.series_resistance > 0))
    text.refuse({"Electrode " + electrode.name}, "Series resistance",
                "without resistance the source holds the voltage: take "
                "Control = voltage, or a positive resistance");
}

void check_device(const CaseText& text, const CaseDraft& draft)
{
  const structure::Device& device = draft.content.device;
  check_completeness(text, draft.content);
  check_method(text, draft.content.procedure);
  check_continuation(text, draft.content.procedure);
  check_groups_unique(text, "Film", "Surfaces", device.films);
  check_groups_unique(text, "Electrode", "Surfaces", device.electrodes);
  check_groups_unique(text, "Bar", "Lines", device.bars);
  check_groups_unique(text, "Frame", "Lines", device.frames);
  check_groups_unique(text, "Hinge", "Points", device.hinges);
  check_groups_unique(text, "Rigid body", "Groups", device.bodies);
  for (const Film& film : device.films)
    check_film(text, film, draft.content.procedure);
  for (const structure::Electrode& electrode : device.electrodes)
    check_electrode(text, electrode);
  for (const structure::Support& support : device.supports)
    check_support(text, support);
  for (const structure::EdgeLoad& load : device.edge_loads)
    check_edge_load(text, load);
  for (const structure::EventDescription& event : device.events)
    check_event(text, event, device);
  check_frames(text, draft);
}
} // namespace

void check_case(const CaseText& text, const CaseDraft& draft)
{
  if (draft.content.model == "resonator")
    check_lumped_resonator(text, draft.content.lumped_resonator);
  else if (draft.content.model == "film")
    check_device(text, draft);
  check_times(text, draft.content);
  check_frequency_response(text, draft.content);
  check_motion(text, draft.content);
}
} // namespace taut::io
