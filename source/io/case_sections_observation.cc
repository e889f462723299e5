#include <taut/io/case_sections.h>

namespace taut::io
{
namespace
{
using structure::EventDescription;
using structure::Probe;

Format<Probe::Kind> probe_kind()
{
  using Kind = Probe::Kind;
  return choice<Kind>({{"position", Kind::position},
                       {"displacement", Kind::displacement},
                       {"velocity", Kind::velocity},
                       {"bar displacement", Kind::bar_displacement},
                       {"bar velocity", Kind::bar_velocity},
                       {"bar rotation", Kind::bar_rotation},
                       {"voltage", Kind::voltage},
                       {"charge", Kind::charge},
                       {"current", Kind::current},
                       {"capacitance", Kind::capacitance},
                       {"reaction", Kind::reaction},
                       {"mean stretch", Kind::mean_stretch},
                       {"mean stress", Kind::mean_stress},
                       {"min principal stress", Kind::min_principal_stress},
                       {"max true field", Kind::max_true_field},
                       {"rotation", Kind::rotation},
                       {"half angle", Kind::half_angle},
                       {"distance", Kind::distance},
                       {"frame force", Kind::frame_force},
                       {"frame moment", Kind::frame_moment},
                       {"frame strain", Kind::frame_strain},
                       {"temperature", Kind::temperature},
                       {"volume", Kind::volume}});
}

Format<unsigned int> component()
{
  return choice<unsigned int>({{"x", 0},
                               {"y", 1},
                               {"z", 2},
                               {"first", 0},
                               {"second", 1},
                               {"third", 2}});
}

void declare_probe(Section& section, Probe& probe, ProbePoint& point)
{
  section.required("Quantity", probe.kind, probe_kind(),
                   "what is recorded, in SI units");
  section.optional("Of", probe.of,
                   text("a name, or empty for a point given by Point"),
                   "the bar, electrode, support, film or frame; for points a "
                   "group of the mesh, for a half angle or distance two, for a "
                   "volume any number");
  section.optional("Point", point,
                   optionally(three_numbers(any(), "m"), "none"),
                   "the point in the mesh if Of is empty; of a frame force or "
                   "moment, if At is");
  section.optional("At", probe.at,
                   text("the name of a physical point, or empty"),
                   "where in the frame a frame force or moment is taken");
  section.optional("Component", probe.component, component(),
                   "component of a vector, axis of the film, axis of a half "
                   "angle; first, second and third are the axes of a frame's "
                   "section");
}

Format<EventDescription::Kind> event_kind()
{
  using Kind = EventDescription::Kind;
  return choice<Kind>({{"tension loss", Kind::tension_loss},
                       {"wrinkling", Kind::wrinkling},
                       {"slackness", Kind::slackness},
                       {"breakdown", Kind::breakdown},
                       {"pull-in", Kind::pull_in},
                       {"snap-through", Kind::snap_through},
                       {"self-contact", Kind::self_contact},
                       {"probe above", Kind::probe_above},
                       {"probe below", Kind::probe_below}});
}

void declare_event(Section& section, EventDescription& event)
{
  section.required("Kind", event.kind, event_kind(), "what is watched for");
  section.optional("Of", event.of,
                   text("the name of a film, frame or probe, or empty"),
                   "the film of a tension loss, wrinkling, slackness or "
                   "breakdown, empty for all; the frame of a self-contact, "
                   "empty for all; nothing for a pull-in, which is of the "
                   "device; the probe of the others");
  section.optional(
      "Threshold", event.threshold,
      number(any(), "Pa for a tension loss, wrinkling or slackness, m for a "
                    "self-contact, dimensionless for a pull-in, the probe's "
                    "SI unit per s for a snap-through, else the probe's SI "
                    "unit"),
      "smallest principal stress of a taut film, largest one of a slack film; "
      "gap between faces of frames that touch; share of its stiffness against "
      "the voltage that a device has at pull-in (with creep above 0: it ends "
      "before the last of it is lost); speed of the probe in a snap-through; "
      "or the value that the probe passes; not used by breakdown");
  section.optional("Quantile", event.quantile,
                   number(within(0, 1), "dimensionless"),
                   "share of the film's area that may be beyond the "
                   "threshold; events of films only, other than pull-in");
  section.optional("Fatal", event.fatal, yes_no(),
                   "whether the event ends the run");
}
} // namespace

void declare_observation(Declarations& all, const CaseText& text,
                         CaseDraft& draft)
{
  structure::Device& device = draft.content.device;
  draft.probe_points.resize(text.names_of({}, "Probe").size());
  declare_list(all, text, {}, "Probe", "a number recorded in history.csv",
               device.probes,
               [&](Section& section, Probe& probe)
               {
                 declare_probe(section, probe,
                               draft.probe_points[&probe - &device.probes[0]]);
               });
  declare_list(all, text, {}, "Event", "a condition located in time",
               device.events, declare_event);
}
} // namespace taut::io
