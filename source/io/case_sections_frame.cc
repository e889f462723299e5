#include <taut/io/case_sections.h>

namespace taut::io
{
namespace
{
using namespace structure;

const char* const points = "names of physical points of the mesh";

/// Names, or the word `none` for an empty list.
void declare_rectangle(Section& section, RectangularSection& rectangle)
{
  const Format<double> length = number(positive(), "m");
  section.required("Width", rectangle.width, length,
                   "of the section, along its axis 2");
  section.required("Thickness", rectangle.thickness, length,
                   "of the section, along its axis 3");
  section.required("Young modulus", rectangle.young_modulus,
                   number(positive(), "Pa"), "E");
  section.optional("Poisson ratio", rectangle.poisson_ratio,
                   number(within(0, .5), "dimensionless"),
                   "nu, for the shear modulus E/(2 (1 + nu))");
  section.required("Density", rectangle.density,
                   number(not_negative(), "kg/m^3"),
                   "mass per volume; 0 is a massless frame");
}

void declare_stiffnesses(Section& section, BeamSection& stiffnesses)
{
  section.required("Axial stiffness", stiffnesses.axial_stiffness,
                   number(positive(), "N"), "E A");
  section.required("Shear stiffness", stiffnesses.shear_stiffness,
                   two_numbers(positive(), "N"),
                   "G A with the shear factor, along the axes 2 and 3");
  section.required("Torsional stiffness", stiffnesses.torsional_stiffness,
                   number(positive(), "N m^2"), "G J");
  section.required("Bending stiffness", stiffnesses.bending_stiffness,
                   two_numbers(positive(), "N m^2"),
                   "E I about the axes 2 (out of the frame's plane) and 3");
  section.required("Mass per length", stiffnesses.mass_per_length,
                   number(not_negative(), "kg/m"), "rho A");
  section.optional("Rotary inertia per length", stiffnesses.rotary_inertia,
                   three_numbers(not_negative(), "kg m"),
                   "rho I about the axes 1, 2 and 3");
  section.optional("Depth", stiffnesses.thickness, number(not_negative(), "m"),
                   "thickness along axis 3, for strains and an Offset of half "
                   "the thickness");
}

/// Declares the kind of section, and the keys of the selected one.
void declare_section(Section& section, const CaseText& text, Frame& frame,
                     FrameDraft& draft)
{
  section.optional("Section", draft.section,
                   one_of({"rectangle", "stiffnesses"}),
                   "whether the cross-section is a rectangle or given by its "
                   "stiffnesses; its axis 1 runs along the frame, 3 along "
                   "Normal, 2 = 3 x 1");
  const Entry* kind = text.find(section.path(), "Section");
  if (kind && kind->value == "stiffnesses")
    declare_stiffnesses(section, frame.section);
  else
    declare_rectangle(section, draft.rectangle);
}

void declare_attachment(Section& section, Frame& frame, FrameDraft& draft)
{
  using Attachment = Frame::Attachment;
  section.optional("Attachment", frame.attachment,
                   choice<Attachment>({{"along", Attachment::along},
                                       {"nowhere", Attachment::nowhere},
                                       {"at", Attachment::at}}),
                   "whether films follow the frame all along the lines that "
                   "they share, nowhere, or at Attached at only");
  section.optional("Attached at", frame.attached_at,
                   names_or_none("names of physical points or lines"),
                   "where films follow the frame if Attachment = at");
  section.optional("Offset", draft.offset,
                   optionally(number(any(), "m"), "half thickness"),
                   "from the beam's axis to the film along Normal: the mesh "
                   "holds the film's place; half thickness is that of the "
                   "frame alone, a film glued on its face");
}

void declare_frame(Section& section, const CaseText& text, Frame& frame,
                   FrameDraft& draft)
{
  section.required("Lines", frame.groups,
                   names("names of physical lines of the mesh"),
                   "where the frame is: edges of films, or lines of their own");
  declare_section(section, text, frame, draft);
  section.optional("Normal", frame.normal,
                   three_numbers(any(), "dimensionless"),
                   "direction of the section's axis 3, of any length, "
                   "projected across the lines");
  declare_attachment(section, frame, draft);
  section.optional("Temperature", frame.temperature, signal("K"),
                   "temperature of the frame");
  section.optional("Modulus law", frame.modulus_law, temperature_law(),
                   "factor on all stiffnesses");
  section.optional("Humidity", frame.humidity, signal("dimensionless"),
                   "relative humidity of the air, from 0 to 1");
  section.optional("Humidity law", frame.humidity_law, humidity_law(),
                   "factor on all stiffnesses, beside that of the Modulus law");
  section.optional("Mass damping", frame.mass_damping,
                   number(not_negative(), "1/s"),
                   "damping force over mass and velocity");
  section.optional("Stiffness damping", frame.stiffness_damping,
                   number(not_negative(), "s"),
                   "Kelvin-Voigt: stress of a strain rate over the stress of "
                   "the strain");
}

void declare_hinge(Section& section, Hinge& hinge)
{
  section.required("Points", hinge.groups, names(points),
                   "where frames that meet turn independently");
}

void declare_body(Section& section, RigidBody& body)
{
  section.required("Groups", body.groups,
                   names("names of physical points or lines"),
                   "what moves as one: all nodes of films and frames there");
  section.optional("Centre", body.centre,
                   optionally(three_numbers(any(), "m"), "mean of its nodes"),
                   "centre of mass, in the mesh");
  section.optional("Mass", body.mass, number(not_negative(), "kg"),
                   "mass of the body itself");
  section.optional("Rotary inertia", body.rotary_inertia,
                   three_numbers(not_negative(), "kg m^2"),
                   "about x, y, z of the mesh through the centre");
}

void declare_point_mass(Section& section, PointMass& mass)
{
  section.required("Points", mass.groups, names(points),
                   "where it is; each point carries all of it");
  section.required("Mass", mass.mass, number(not_negative(), "kg"),
                   "added mass");
  section.optional("Rotary inertia", mass.rotary_inertia,
                   three_numbers(not_negative(), "kg m^2"),
                   "about x, y, z of the mesh, on frames only");
}

void declare_point_load(Section& section, PointLoad& load)
{
  section.required("Points", load.groups, names(points),
                   "where it acts; each point carries all of it");
  const Format<std::array<double, 3>> direction =
      three_numbers(any(), "dimensionless");
  section.optional("Force direction", load.force_direction, direction,
                   "direction of the force, scaled to length 1");
  section.optional("Force", load.force, signal("N"), "force");
  section.optional("Moment direction", load.moment_direction, direction,
                   "axis of the moment, scaled to length 1");
  section.optional("Moment", load.moment, signal("N m"),
                   "moment, on frames only");
  section.optional("Follower", load.follower, yes_no(),
                   "whether force and moment turn with the node of the frame");
}
} // namespace

void declare_frames(Declarations& all, const CaseText& text, CaseDraft& draft)
{
  Device& device = draft.content.device;
  draft.frames.resize(text.names_of({}, "Frame").size());
  declare_list(all, text, {}, "Frame",
               "a beam along lines of the mesh, with or without a film; frames "
               "that meet are joined rigidly",
               device.frames,
               [&](Section& section, Frame& frame)
               {
                 declare_frame(section, text, frame,
                               draft.frames[&frame - &device.frames[0]]);
               });
  declare_list(all, text, {}, "Hinge", "a joint that lets frames turn",
               device.hinges, declare_hinge);
  declare_list(all, text, {}, "Rigid body",
               "a stand-off, an end bar: points and lines that move as one",
               device.bodies, declare_body);
  declare_list(all, text, {}, "Point mass", "mass and inertia at points",
               device.masses, declare_point_mass);
  declare_list(all, text, {}, "Point load", "force and moment at points",
               device.point_loads, declare_point_load);
}
} // namespace taut::io
