#include <taut/io/case_sections.h>

namespace taut::io
{
namespace
{
using namespace study;

void declare_procedure(Section section, ProcedureDescription& procedure)
{
  using structure::Analysis;
  using structure::Start;
  section.optional(
      "Analysis", procedure.analysis,
      choice<Analysis>({{"equilibrium", Analysis::equilibrium},
                        {"continuation", Analysis::continuation},
                        {"quasi-static", Analysis::quasi_static},
                        {"transient", Analysis::transient},
                        {"frequency response", Analysis::frequency_response}}),
      "static path, one that may turn back in time, viscous flow "
      "without inertia, motion, or the settled motions of a "
      "lumped model over the frequency of its source");
  section.optional("Start", procedure.start,
                   choice<Start>({{"relaxed", Start::relaxed},
                                  {"unrelaxed", Start::unrelaxed}}),
                   "whether the networks have forgotten the pre-stretch when "
                   "the run starts, or the pre-stretch has just been applied");
  section.optional("Start shape", procedure.shape,
                   choice<Shape>({{"meshed", Shape::meshed},
                                  {"equilibrium", Shape::equilibrium},
                                  {"rest", Shape::rest}}),
                   "whether the run starts from the mesh at rest, from the "
                   "equilibrium next to it, or from the stable shape into "
                   "which a stretched film bends its frame");
  section.optional("Start time", procedure.start_time, number(any(), "s"),
                   "time at which the run starts");
  section.optional("End time", procedure.end_time, number(any(), "s"),
                   "time at which the run ends");
  section.optional("Newton tolerance", procedure.newton_tolerance,
                   number(within(1e-15, 1e-2), "dimensionless"),
                   "residual of an equilibrium over its internal forces");
  section.optional("Load steps", procedure.load_steps, count(1, 1000000),
                   "least number of steps of an equilibrium path");
}

void declare_rest_shape(Section section, RestShapeDescription& rest)
{
  section.optional("Direction", rest.direction,
                   three_numbers(any(), "dimensionless"),
                   "to which side the frames bend, of any length");
  section.optional("Perturbation", rest.perturbation,
                   number(positive(), "dimensionless"),
                   "load along the frames that decides the side and is gone at "
                   "the end, over 8 EI/L^3 with the extent L of the device");
  section.optional("First stiffness", rest.first_stiffness,
                   number(within(1, 1e6), "dimensionless"),
                   "how many times stiffer the frames are at first");
  section.optional("Steps", rest.steps, count(1, 1000000),
                   "least number of steps in which they soften");
  section.optional("Both branches", rest.both_branches, yes_no(),
                   "whether the shape on the other side is found and reported "
                   "as well");
}

void declare_continuation(Section section, ContinuationDescription& path)
{
  using Branch = ContinuationDescription::Branch;
  section.optional("Steps", path.steps, count(1, 1000000),
                   "the first step is this part of the time");
  section.optional("Largest step", path.largest_step,
                   number(within(1e-4, 1), "dimensionless"),
                   "relative to the largest displacements so far and to the "
                   "time from start to end");
  section.optional("Most points", path.most_points, count(2, 1000000),
                   "number of points after which the path ends");
  section.optional("Branch", path.branch,
                   choice<Branch>({{"primary", Branch::primary},
                                   {"stable", Branch::stable}}),
                   "at a bifurcation: straight on, or along the other branch "
                   "where the path becomes unstable or turns back");
  section.optional("Direction", path.direction,
                   three_numbers(any(), "dimensionless"),
                   "to which side another branch is taken, of any length");
  section.optional("Backward", path.backward, yes_no(),
                   "whether the path is also followed back, along what a "
                   "device does: its jumps show the hysteresis");
}

/// `analysis` is the entry of Analysis, if there is one: it decides about the
/// default method.
void declare_integrator(Section section, const Entry* analysis,
                        time::IntegratorOptions& options)
{
  using time::Method;
  if (analysis && analysis->value == "quasi-static")
    options.method = Method::bdf;
  section.optional("Method", options.method,
                   choice<Method>({{"esdirk4", Method::esdirk4},
                                   {"esdirk3", Method::esdirk3},
                                   {"bdf", Method::bdf}}),
                   "implicit Runge-Kutta of order 4 or 3, or variable-order "
                   "BDF, the only one and the default of quasi-static runs");
  section.optional("Position tolerance", options.position_tolerance,
                   number(positive(), "m"),
                   "local error of a displacement, root mean square");
  section.optional("Internal tolerance", options.internal_tolerance,
                   number(positive(), "dimensionless"),
                   "local error of an internal variable in quasi-static runs");
  section.optional("Charge tolerance", options.global_tolerance,
                   number(positive(), "dimensionless"),
                   "local error of the charge in a circuit, over that of the "
                   "framed film at the field (V/H) sqrt(eps/G) = 1");
  section.optional("Weight of rates", options.weight_of_rates,
                   number(positive(), "dimensionless"),
                   "weight of velocities in the error, and in transient runs "
                   "of internal variables");
  section.optional("Velocity time", options.velocity_time,
                   number(positive(), "s"),
                   "turns the position tolerance into one of velocity");
  section.optional("First step", options.first_step, number(positive(), "s"),
                   "step after the start and after every kink of a signal");
  section.optional("Largest step", options.largest_step,
                   number(not_negative(), "s"), "bound of the step; 0 is none");
  section.optional("Highest order", options.max_order, small_count(1, 5),
                   "highest order of bdf");
  section.optional("Largest step change", options.max_gamma_change,
                   number(between(0, 1), "dimensionless"),
                   "relative change of the step that keeps the factorisation");
  section.optional("Factorisation interval", options.setup_frequency,
                   small_count(1, 1000000),
                   "steps after which the matrix is factorised anew");
  section.optional("Most steps", options.max_steps, long_count(1),
                   "number of steps after which the run fails");
}

void declare_output(Section section, OutputDescription& output)
{
  section.optional("History intervals", output.history_intervals,
                   count(0, 100000000),
                   "equal intervals between the rows of history.csv; 0 "
                   "gives the start and the end alone");
  section.optional("Field intervals", output.field_intervals, count(0, 1000000),
                   "equal intervals between the frames of fields.pvd; 0 "
                   "gives the start and the end alone");
  section.optional("History times", output.history_times, numbers(any(), "s"),
                   "further times of rows");
  section.optional("Field times", output.field_times, numbers(any(), "s"),
                   "further times of frames");
  section.optional("Write fields", output.write_fields, yes_no(),
                   "whether fields.pvd is written at all");
}

void declare_checkpoint(Section section, CheckpointDescription& checkpoint)
{
  section.optional("Every steps", checkpoint.every_steps, long_count(0),
                   "accepted steps between checkpoints, 0 is never; the "
                   "integrator starts anew at each");
  section.optional("Every time", checkpoint.every_time,
                   number(not_negative(), "s"),
                   "simulated time between checkpoints, 0 is never; the "
                   "integrator starts anew at each");
  section.optional("Every minutes", checkpoint.every_minutes,
                   number(not_negative(), "min"),
                   "wall time between checkpoints, 0 is never");
}

void declare_modes(Section section, ModesDescription& modes)
{
  using At = ModesDescription::At;
  using Networks = ModesDescription::Networks;
  section
      .optional("Count", modes.count, count(1, 1000),
                "number of vibration modes")
      .optional("Near frequency", modes.near_frequency,
                number(not_negative(), "Hz"),
                "the modes next to it; 0 gives the lowest")
      .optional("At", modes.at,
                choice<At>({{"end", At::end}, {"start", At::start}}),
                "about which state of the run")
      .optional("Networks", modes.networks,
                choice<Networks>({{"frozen", Networks::frozen},
                                  {"relaxed", Networks::relaxed}}),
                "whether networks are too slow to follow a vibration, or too "
                "fast to resist it")
      .optional("Amplitude", modes.amplitude,
                number(positive(), "dimensionless"),
                "largest displacement of a mode in fields.pvd, over the "
                "extent of the device");
}

/// The model decides which keys are needed, which resolve_names checks.
void declare_comparison(Section section, CaseDraft& draft)
{
  study::ComparisonDescription& resonator = draft.comparison;
  study::DemesComparisonDescription& demes = draft.demes_comparison;
  section
      .optional("Model", draft.comparison_model, one_of({"resonator", "demes"}),
                "the lumped model: a resonator, or a DEMES of one angle")
      .optional("Active film", resonator.active_film,
                text("the name of a film"),
                "the film that plays the strip with electrodes of a resonator")
      .optional("Passive film", resonator.passive_film,
                text("the name of a film"),
                "the film that plays the strip without")
      .optional("Bar", resonator.bar, text("the name of a bar"),
                "the bar between the strips of a resonator")
      .optional("Electrode", resonator.electrode,
                text("the name of an electrode"), "the driven electrode")
      .optional("Film", demes.film, text("the name of a film"),
                "the film along the chord of a DEMES")
      .optional("Legs", demes.legs, names_or_none("names of frames"),
                "the frames that bend between the ends of a DEMES")
      .optional("Left body", demes.left_body, text("the name of a rigid body"),
                "one end of a DEMES, with half of the inertia")
      .optional("Right body", demes.right_body,
                text("the name of a rigid body"), "its other end")
      .optional("Angle probe", demes.angle_probe, text("the name of a probe"),
                "of the half angle between the ends of a DEMES")
      .optional("Chord probe", demes.chord_probe, text("the name of a probe"),
                "of the distance between the film's ends")
      .optional("Stretch probe", demes.stretch_probe,
                text("the name of a probe"),
                "of the film's mean stretch along its first axis");
}

/// Film and dashpot of a lumped DEMES.
void declare_demes_film(Section section, LumpedDemesDescription& demes)
{
  const Format<double> length = number(positive(), "m");
  const Format<double> pure = number(positive(), "dimensionless");
  section
      .required("Film length", demes.film_length, length,
                "L_0, undeformed; times the pre-stretch that of the frame")
      .required("Film width", demes.film_width, length,
                "W_0, undeformed, which is held")
      .required("Film thickness", demes.film_thickness, length,
                "t_0, undeformed")
      .optional("Film offset", demes.film_offset, number(any(), "m"),
                "h, from the axis of the frame to the film, positive on the "
                "hollow side of positive angles")
      .optional("Pre-stretch", demes.pre_stretch, pure,
                "lambda_p, of the film in the straight frame")
      .required("Shear modulus", demes.shear_modulus, number(positive(), "Pa"),
                "mu of the elastic spring")
      .optional("Viscous ratio", demes.viscous_ratio,
                number(not_negative(), "dimensionless"),
                "beta, modulus of the viscous branch over mu")
      .required("Viscosity", demes.viscosity, number(positive(), "Pa s"),
                "eta of the dashpot")
      .optional("Relative permittivity", demes.relative_permittivity,
                number({1, 1e6}, "dimensionless"),
                "eps_r of the unstretched film at 299 K")
      .optional("Permittivity coefficients", demes.permittivity_coefficients,
                numbers(any(), "dimensionless"),
                "a, b, c of 1 + a (l - 1) + b (l - 1)^2 + c (l - 1)^3, by "
                "default those of Wang et al. (2024); none is a constant");
}

/// Its frame, surroundings and start.
void declare_demes_frame(Section section, LumpedDemesDescription& demes)
{
  section
      .required("Frame modulus", demes.frame_modulus, number(positive(), "Pa"),
                "Young's modulus at 299 K")
      .required("Frame width", demes.frame_width, number(positive(), "m"),
                "of both legs together")
      .required("Frame thickness", demes.frame_thickness,
                number(positive(), "m"), "in the direction in which it bends")
      .required("Inertia", demes.inertia, number(positive(), "kg m^2"),
                "twice the rotary inertia of each end")
      .optional("Rest angle", demes.rest_angle, number(within(-3, 3), "rad"),
                "half of the arc's angle of the frame without film")
      .optional("Temperature laws", demes.temperature_laws,
                one_of({"constant", "softening", "entropic"}),
                "how moduli and viscosity follow the temperature")
      .optional("Temperature", demes.temperature, number(positive(), "K"),
                "of film and frame; the laws start at 299 K")
      .optional("Charge controlled", demes.charge_controlled, yes_no(),
                "whether Source is the charge (C) instead of the voltage")
      .required("Source", demes.source, signal("V"),
                "voltage between the electrodes, or charge on them")
      .optional("Begin", demes.start,
                choice<DemesStart>(
                    {{"rest", DemesStart::rest}, {"flat", DemesStart::flat}}),
                "relaxed at rest without voltage at 299 K, or straight with "
                "the film relaxed at its pre-stretch")
      .optional("Seed angle", demes.seed_angle, number(within(-3, 3), "rad"),
                "with which a flat start leaves its unstable equilibrium; 0 "
                "never leaves it")
      .optional("Tolerance", demes.tolerance,
                number(within(1e-13, 1e-3), "dimensionless"),
                "local error of a step");
}
} // namespace

void declare_lumped_resonator(Declarations& all,
                              LumpedResonatorDescription& resonator)
{
  const Format<double> length = number(positive(), "m");
  const Format<double> pure = number(positive(), "dimensionless");
  all.section({"Lumped resonator"},
              "two strips in a frame with a bar between them, the case of "
              "Model = resonator")
      .required("Length active", resonator.length_active, length,
                "undeformed length of the strip with electrodes")
      .required("Length passive", resonator.length_passive, length,
                "undeformed length of the strip without")
      .required("Width", resonator.width, length, "undeformed width of both")
      .required("Thickness", resonator.thickness, length,
                "undeformed thickness of both")
      .optional("Pre-stretch", resonator.pre_stretch,
                two_numbers(positive(), "dimensionless"),
                "stretches along and across the strips")
      .required("Bar mass", resonator.bar_mass, number(not_negative(), "kg"),
                "total mass between the strips")
      .required("Density", resonator.density, number(positive(), "kg/m^3"),
                "mass of the film per volume")
      .required("Shear modulus", resonator.shear_modulus,
                number(positive(), "Pa"), "total, of spring and networks")
      .optional("Equilibrium share", resonator.equilibrium_share,
                number(within(0, 1), "dimensionless"),
                "share of the shear modulus in the spring")
      .optional("Network shares", resonator.network_shares,
                numbers(positive(), "dimensionless"),
                "shares in the networks; none gives equal ones")
      .optional("Relaxation times", resonator.relaxation_times,
                numbers(positive(), "s"), "of the networks, one each")
      .optional("Limit", resonator.limit, pure, "J_lim of the Gent springs")
      .optional("Relaxation is rate", resonator.relaxation_is_rate, yes_no(),
                "whether the relaxation times are read as rates, as printed "
                "in the source of the model")
      .optional("Relative permittivity", resonator.relative_permittivity,
                number({1, 1e6}, "dimensionless"), "eps_r")
      .required("Breakdown strength", resonator.breakdown_strength,
                number(positive(), "V/m"),
                "largest true field that the film stands")
      .required("Voltage", resonator.voltage, signal("V"),
                "voltage on the active strip")
      .optional("Hold time", resonator.hold_time, number(not_negative(), "s"),
                "run.json tells the highest voltage to which the source can "
                "rise and then stay so long without a failure; 0 does not seek "
                "it");
}

void declare_lumped_demes(Declarations& all, LumpedDemesDescription& demes)
{
  all.allow_section({}, "Lumped DEMES", false);
  Section section =
      all.section({"Lumped DEMES"},
                  "a film across a frame that bends into an arc, the case of "
                  "Model = demes");
  declare_demes_film(section, demes);
  declare_demes_frame(section, demes);
}
void declare_study(Declarations& all, const CaseText& text, CaseDraft& draft)
{
  Case& content = draft.content;
  const Entry* model = text.find({}, "Model");
  if (model && model->value == "demes")
    declare_lumped_demes(all, content.lumped_demes);
  for (const char* kind :
       {"Procedure", "Output", "Checkpoint", "Modes", "Comparison"})
    all.allow_section({}, kind, false);
  all.allow_section({"Procedure"}, "Integrator", false);
  declare_procedure(all.section({"Procedure"}, "what is done with the device"),
                    content.procedure);
  all.allow_section({"Procedure"}, "Rest shape", false);
  declare_rest_shape(all.section({"Procedure", "Rest shape"},
                                 "the way to a Start shape = rest"),
                     content.procedure.rest_shape);
  all.allow_section({"Procedure"}, "Continuation", false);
  declare_continuation(all.section({"Procedure", "Continuation"},
                                   "the way of Analysis = continuation"),
                       content.procedure.continuation);
  declare_frequency_response(all, text, content.procedure);
  declare_integrator(
      all.section({"Procedure", "Integrator"}, "how time is stepped"),
      text.find({"Procedure"}, "Analysis"), content.procedure.integrator);
  declare_output(all.section({"Output"}, "what is written when"),
                 content.output);
  declare_checkpoint(
      all.section({"Checkpoint"}, "when the run can be resumed from"),
      content.checkpoint);
  declare_modes(all.section({"Modes"}, "what `taut modes` looks for"),
                content.modes);
  declare_motion(all, text, content);
  if (text.find({"Comparison"}))
    declare_comparison(
        all.section({"Comparison"}, "the film case as a lumped model"), draft);
}
} // namespace taut::io
