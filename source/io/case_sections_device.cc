#include <taut/io/case_sections.h>

#include <cmath>
#include <limits>

namespace taut::io
{
namespace
{
using namespace structure;

const char* const surfaces = "names of physical surfaces of the mesh";
const char* const lines = "names of physical lines of the mesh";

void declare_mesh(Section section, MeshDescription& mesh)
{
  section.required("File", mesh.file,
                   text("a .geo or .msh file, found from the case file"),
                   "mesh of the framed (pre-stretched) device in m");
  section.optional("Parameters", mesh.geo_parameters,
                   named_numbers("SI units of the .geo"),
                   "values that replace those of DefineConstant in the .geo");
  section.optional("Refinements", mesh.refinements, count(0, 20),
                   "how often every cell is split into four");
  section.optional("Adaptive refinements", mesh.adaptive_refinements,
                   count(0, 20),
                   "how often, after that, the cells in which the starting "
                   "equilibrium is resolved worst are split into four");
  section.optional("Refined share", mesh.refined_share,
                   number(between(0, 1), "dimensionless"),
                   "share of the cells that an adaptive refinement splits");
  section.optional("Degree", mesh.degree, count(1, 2),
                   "polynomial degree of the elements");
}

void declare_film(Section& section, Film& film, std::string& material)
{
  section.required("Surfaces", film.groups, names(surfaces),
                   "where the film is");
  section.required("Material", material, text("the name of a Material section"),
                   "what the film is made of");
  section.required("Thickness", film.thickness, number(positive(), "m"),
                   "undeformed thickness, before the pre-stretch");
  section.optional("Pre-stretch", film.pre_stretch,
                   two_numbers(positive(), "dimensionless"),
                   "stretches along and across Axis that brought the film "
                   "into the frame");
  section.optional("Pre-stretch share", film.pre_stretch_share,
                   signal("dimensionless"),
                   "of the way from 1 to Pre-stretch, in static analyses: a "
                   "ramp stretches the film in its frame");
  section.optional("Axis", film.axis, three_numbers(any(), "dimensionless"),
                   "direction of the first pre-stretch, of any length, "
                   "projected into the film");
  section.optional("Temperature", film.temperature, signal("K"),
                   "temperature of the film");
  section.optional("Humidity", film.humidity, signal("dimensionless"),
                   "relative humidity of the air, from 0 to 1");
  section.optional("Fibre modulus", film.fibre_modulus,
                   number(not_negative(), "Pa"),
                   "of fibres across Axis, unstrained in the mesh, that hold "
                   "the width; 0 = none");
  section.optional("Tension field", film.tension_field, yes_no(),
                   "whether the film wrinkles and goes slack instead of "
                   "carrying compression");
}

void declare_electrode(Section& section, Electrode& electrode)
{
  section.required("Surfaces", electrode.groups, names(surfaces),
                   "parts of films coated on both faces");
  using Control = Electrode::Control;
  section.optional("Control", electrode.control,
                   choice<Control>({{"voltage", Control::voltage},
                                    {"charge", Control::charge},
                                    {"circuit", Control::circuit}}),
                   "what the source holds: the voltage, the charge, or a "
                   "voltage behind a resistor while the film leaks");
  section.optional("Voltage", electrode.voltage, signal("V"),
                   "voltage between the faces, in a circuit that of the "
                   "source; needed unless Control = charge");
  section.optional("Charge", electrode.charge, signal("C"),
                   "charge of the face at the higher potential, needed if "
                   "Control = charge");
  section.optional("Series resistance", electrode.series_resistance,
                   number(not_negative(), "Ohm"),
                   "between source and film, needed if Control = circuit");
  section.optional("Leakage resistance", electrode.leakage_resistance,
                   number_or(positive(), "Ohm", "none",
                             std::numeric_limits<double>::infinity()),
                   "through the film, in a circuit");
}

void declare_support(Section& section, Support& support)
{
  const Format<std::string> shape = formula_of_position("m");
  section.required("Groups", support.groups,
                   names("names of physical points, lines or surfaces"),
                   "what is held");
  section.optional("Acts on", support.target,
                   choice<Support::Target>({{"all", Support::Target::all},
                                            {"film", Support::Target::film},
                                            {"frame", Support::Target::frame}}),
                   "whether all nodes there are held, only those of films, or "
                   "only those of frames and rigid bodies");
  section.optional("Held", support.held, directions(),
                   "components of the position that are held");
  section.optional("Held rotations", support.held_rotations, directions(),
                   "components of the rotation vector of frames and rigid "
                   "bodies that are held");
  const std::array<const char*, 3> axes{{"x", "y", "z"}};
  for (unsigned int i = 0; i < 3; ++i)
    section.optional(std::string("Shape ") + axes[i], support.shape[i], shape,
                     std::string("prescribed displacement along ") + axes[i] +
                         " for an amplitude of 1, at x, y, z of the mesh in m");
  section.optional("Amplitude", support.amplitude, signal("dimensionless"),
                   "factor of the shape in time");
}

void declare_pressure(Section& section, Pressure& pressure)
{
  section.required("Surfaces", pressure.groups, names(surfaces),
                   "where the pressure acts");
  section.required("Pressure", pressure.pressure, signal("Pa"),
                   "pressure along the normal of the moving surface");
}

void declare_edge_load(Section& section, EdgeLoad& load)
{
  section.required("Lines", load.groups, names(lines), "where the load acts");
  section.required("Direction", load.direction,
                   three_numbers(any(), "dimensionless"),
                   "direction of the force, scaled to length 1");
  section.required("Force", load.force, signal("N/m"),
                   "force per length of the mesh");
}

void declare_bar(Section& section, RigidBar& bar)
{
  section.required("Lines", bar.groups, names(lines),
                   "the straight line of the mesh that moves as a rigid body");
  section.required("Mass", bar.mass, number(not_negative(), "kg"),
                   "total mass, of both bars if one is glued on each face");
  section.optional("Rotary inertia", bar.rotary_inertia,
                   optionally(number(positive(), "kg m^2"), "uniform rod"),
                   "about the axes across the bar; a uniform rod has mass "
                   "length^2/12");
  section.optional("Free", bar.free, directions(),
                   "components of the translation left free");
  section.optional("Rotates", bar.rotates, yes_no(),
                   "whether the bar turns; a guided bar only translates");
}

void declare_environment(Section section, Environment& environment)
{
  section.optional("Gravity", environment.gravity,
                   three_numbers(any(), "m/s^2"), "acceleration by gravity");
  section.optional("Air drag", environment.air_drag,
                   number(not_negative(), "kg/(m^3 s)"),
                   "force per undeformed volume of film and velocity");
}
} // namespace

void declare_device(Declarations& all, const CaseText& text, CaseDraft& draft)
{
  Device& device = draft.content.device;
  all.allow_section({}, "Mesh", false);
  declare_mesh(all.section({"Mesh"}, "the mesh"), device.mesh);
  draft.film_materials.resize(text.names_of({}, "Film").size());
  declare_list(all, text, {}, "Film", "a film: one material, one thickness",
               device.films,
               [&](Section& section, Film& film)
               {
                 declare_film(section, film,
                              draft.film_materials[&film - &device.films[0]]);
               });
  declare_list(all, text, {}, "Electrode", "a compliant electrode pair",
               device.electrodes, declare_electrode);
  declare_list(all, text, {}, "Support",
               "holds or moves points, lines or surfaces", device.supports,
               declare_support);
  declare_list(all, text, {}, "Bar", "a rigid bar", device.bars, declare_bar);
  declare_frames(all, text, draft);
  declare_list(all, text, {}, "Pressure", "a follower pressure",
               device.pressures, declare_pressure);
  declare_list(all, text, {}, "Edge load", "a dead load on lines",
               device.edge_loads, declare_edge_load);
  declare_observation(all, text, draft);
  all.allow_section({}, "Environment", false);
  declare_environment(all.section({"Environment"}, "gravity and air"),
                      device.environment);
}
} // namespace taut::io
