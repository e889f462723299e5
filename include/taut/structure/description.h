#pragma once

#include <taut/base/signal.h>
#include <taut/material/elastomer.h>
#include <taut/material/humidity_law.h>
#include <taut/material/temperature_law.h>

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What a device is, as plain data: the parameter file is read into these
/// structs and everything below the io layer sees only them. SI units.
/// Every named entry carries `source_line` (line in the parameter file, 0 if it
/// was built in code) so that later checks, against the mesh for instance, can
/// point the user to it.
namespace taut::structure
{
struct Named
{
  std::string name;
  unsigned int source_line = 0;
};

struct MeshDescription
{
  /// .geo or .msh, as found from the case file.
  std::string file;
  /// Values that replace those of DefineConstant in the .geo.
  std::map<std::string, double> geo_parameters;
  /// Uniform refinements after reading.
  unsigned int refinements = 0;
  /// Then so many adaptive ones, each after solving the starting equilibrium.
  unsigned int adaptive_refinements = 0;
  /// Share of the cells that each adaptive refinement splits in four.
  double refined_share = 0.2;
  /// 1 or 2: polynomial degree of the quads.
  unsigned int degree = 2;
  unsigned int source_line = 0;
};

/// A film: one surface group, one material.
struct Film : Named
{
  /// Physical surfaces.
  std::vector<std::string> groups;
  material::Elastomer material;
  /// Undeformed thickness H (m).
  double thickness = 0;
  /// Principal pre-stretches along and across `axis`.
  std::array<double, 2> pre_stretch{{1, 1}};
  /// Direction of the first pre-stretch and first material axis, projected
  /// into the film's plane; dimensionless, any length.
  std::array<double, 3> axis{{1, 0, 0}};
  /// Of the way from 1 to `pre_stretch`, for static paths that stretch the film
  /// in its frame: the pre-stretches are 1 + share (pre_stretch - 1).
  Signal pre_stretch_share = Signal::constant(1);
  /// Temperature (K), uniform.
  Signal temperature = Signal::constant(293.15);
  /// Relative humidity of the air, 0 to 1, uniform.
  Signal humidity = Signal::constant(0);
  material::ThermalLaws thermal;
  material::HumidityLaws humidity_laws;
  /// In compression the film wrinkles or goes slack instead of carrying it.
  bool tension_field = true;
  /// Modulus (Pa) of fibres across `axis` that hold the width of the framed
  /// film; 0 = none. They carry compression.
  double fibre_modulus = 0;
};

struct Electrode : Named
{
  enum class Control
  {
    voltage, ///< the source holds the voltage between the faces
    charge,  ///< the charge is given, the voltage follows
    circuit  ///< a voltage source behind a resistor, and a film that leaks
  };
  /// Physical surfaces.
  std::vector<std::string> groups;
  Control control = Control::voltage;
  /// Voltage (V) between the two faces; in a circuit that of the source.
  Signal voltage;
  /// Charge (C) of the face at the higher potential, if it is controlled.
  Signal charge;
  /// Between source and film (Ohm), in a circuit; positive.
  double series_resistance = 0;
  /// Through the film (Ohm), in a circuit.
  double leakage_resistance = std::numeric_limits<double>::infinity();
};

/// Holds components of the position over points, lines or surfaces.
struct Support : Named
{
  enum class Target
  {
    all,
    film, ///< only nodes of films
    frame ///< only nodes of frames and rigid bodies
  };
  std::vector<std::string> groups;
  Target target = Target::all;
  std::array<bool, 3> held{{true, true, true}};
  /// Components of the rotation vector of frame nodes that stay zero.
  std::array<bool, 3> held_rotations{{false, false, false}};
  /// Prescribed displacement (m) = shape(x, y, z) * amplitude(t); the
  /// expression is muParser text in x, y, z of the mesh (m).
  std::array<std::string, 3> shape{{"0", "0", "0"}};
  Signal amplitude;
};

/// Pressure (Pa) on the current surface, along its normal (follower load).
struct Pressure : Named
{
  std::vector<std::string> groups;
  Signal pressure;
};

/// Force per length of the mesh (N/m) on lines, constant direction (dead).
struct EdgeLoad : Named
{
  std::vector<std::string> groups;
  std::array<double, 3> direction{{0, 0, 0}};
  Signal force;
};

/// A straight line of the mesh that moves as a rigid body.
struct RigidBar : Named
{
  std::vector<std::string> groups;
  /// Total mass (kg), of both bars if one is glued on each face.
  double mass = 0;
  /// Rotary inertia about the axes across the bar (kg m^2); by default that of
  /// a uniform thin rod, mass L^2/12.
  std::optional<double> rotary_inertia;
  /// Components of the translation left free.
  std::array<bool, 3> free{{true, true, true}};
  /// Whether the bar may rotate; a guided bar only translates.
  bool rotates = true;
};

/// The cross-section of a beam. Its axes: 1 along the beam, 3 along the
/// frame's `normal` (the thickness), 2 = 3 x 1 (the width).
struct BeamSection
{
  double axial_stiffness = 0;                      ///< E A (N)
  std::array<double, 2> shear_stiffness{{0, 0}};   ///< G A along 2, 3 (N)
  double torsional_stiffness = 0;                  ///< G J (N m^2)
  std::array<double, 2> bending_stiffness{{0, 0}}; ///< E I about 2, 3 (N m^2)
  double mass_per_length = 0;                      ///< rho A (kg/m)
  /// Of mass per length about 1, 2, 3 (kg m).
  std::array<double, 3> rotary_inertia{{0, 0, 0}};
  /// Along 3; for the default offset of a film and for strains (m).
  double thickness = 0;
};

/// A rectangle; shear stiffness with the factor 5/6, torsion constant of
/// Saint-Venant.
struct RectangularSection
{
  double width = 0;         ///< along 2 (m)
  double thickness = 0;     ///< along 3 (m)
  double young_modulus = 0; ///< (Pa)
  double poisson_ratio = 0.4;
  double density = 0; ///< (kg/m^3)
};
BeamSection make_section(const RectangularSection& rectangle);

/// Geometrically exact beams along lines of the mesh, with or without a film.
/// Frames that meet in a node are joined rigidly there unless a Joint says
/// otherwise.
struct Frame : Named
{
  enum class Attachment
  {
    along,   ///< the film follows the frame wherever it touches its lines
    nowhere, ///< frame and film only share places
    at       ///< the film follows at `attached_at` only
  };
  /// Physical lines, edges of films or lines of their own.
  std::vector<std::string> groups;
  BeamSection section;
  /// Direction of the section's axis 3, projected across the line.
  std::array<double, 3> normal{{0, 0, 1}};
  Attachment attachment = Attachment::along;
  /// Physical points or lines.
  std::vector<std::string> attached_at;
  /// From the beam's axis to the film along `normal` (m). The mesh holds the
  /// film's place: the axis lies at - offset from it.
  double offset = 0;
  /// Temperature (K), relative humidity (0 to 1) and the laws of all
  /// stiffnesses.
  Signal temperature = Signal::constant(293.15);
  Signal humidity = Signal::constant(0);
  material::TemperatureLaw modulus_law;
  material::HumidityLaw humidity_law;
  /// Rayleigh damping: forces mass_damping M v (1/s) and stresses
  /// stiffness_damping C strain rate (s, Kelvin-Voigt).
  double mass_damping = 0;
  double stiffness_damping = 0;
};

/// Frames that meet at points turn independently there.
struct Hinge : Named
{
  std::vector<std::string> groups; ///< physical points
};

/// All nodes of films and frames in the groups move as one rigid body.
struct RigidBody : Named
{
  std::vector<std::string> groups; ///< points or lines, not of one place
  /// Centre of mass (m); by default the mean of its nodes.
  std::optional<std::array<double, 3>> centre;
  double mass = 0; ///< (kg)
  /// About x, y, z of the mesh through the centre (kg m^2).
  std::array<double, 3> rotary_inertia{{0, 0, 0}};
};

/// Mass and rotary inertia added to nodes of frames or, without inertia, films.
struct PointMass : Named
{
  std::vector<std::string> groups; ///< physical points; each gets all of it
  double mass = 0;                 ///< (kg)
  std::array<double, 3> rotary_inertia{{0, 0, 0}}; ///< (kg m^2), x, y, z
};

/// Force and moment on each point of the groups.
struct PointLoad : Named
{
  std::vector<std::string> groups; ///< physical points
  std::array<double, 3> force_direction{{0, 0, 0}};
  Signal force; ///< (N)
  std::array<double, 3> moment_direction{{0, 0, 0}};
  Signal moment; ///< (N m), on frames only
  /// Turns with the node of the frame.
  bool follower = false;
};

struct Probe : Named
{
  enum class Kind
  {
    position,             ///< of a point (m)
    displacement,         ///< of a point (m)
    velocity,             ///< of a point (m/s)
    bar_displacement,     ///< of a bar's centre (m)
    bar_velocity,         ///< of a bar's centre (m/s)
    bar_rotation,         ///< of a bar's director, component of n - n_0
    voltage,              ///< of an electrode (V)
    charge,               ///< of an electrode (C)
    current,              ///< into an electrode, dQ/dt and leakage (A)
    capacitance,          ///< of an electrode (F)
    reaction,             ///< of a support (N); static and quasi-static parts
    mean_stretch,         ///< of a film along component 0 or 1 of its axes
    mean_stress,          ///< nominal stress of a film along 0 or 1 (Pa)
    min_principal_stress, ///< smallest true principal stress of a film (Pa)
    max_true_field,       ///< of a film (V/m)
    rotation,             ///< of a frame at a point, about a fixed axis (rad)
    half_angle,           ///< between the sections at two points (rad)
    distance,             ///< between two points (m)
    frame_force,          ///< of a frame at a point, section axes (N)
    frame_moment,         ///< of a frame at a point, section axes (N m)
    frame_strain,         ///< largest of a frame, of its faces (dimensionless)
    temperature,          ///< of a film or frame (K)
    volume ///< enclosed between surface groups and z = 0 plane (m^3)
  };
  Kind kind = Kind::displacement;
  /// Name of the bar, electrode, support, film or frame; or physical groups,
  /// of which half_angle and distance take two points.
  std::string of;
  /// Of frame_force and frame_moment: a physical point, or empty for `point`.
  std::string at;
  /// Coordinates in the mesh (m) for point probes without `of` or `at`.
  std::array<double, 3> point{{0, 0, 0}};
  /// 0, 1, 2 = x, y, z, or first and second axis of the film.
  unsigned int component = 0;
};

struct EventDescription : Named
{
  enum class Kind
  {
    tension_loss, ///< smaller principal stress below `threshold` (Pa)
    wrinkling,    ///< tension is lost in one direction
    slackness,    ///< tension is lost in both
    breakdown,    ///< true field above the strength of the film
    pull_in,      ///< the film runs away into thickness, see Watches
    snap_through, ///< the shape runs away to another, see Watches
    self_contact, ///< frames touch each other or themselves
    probe_above,  ///< probe rises above threshold
    probe_below   ///< probe falls below threshold
  };
  Kind kind = Kind::tension_loss;
  /// Film or frame (empty = all of them) or probe; empty for a pull-in.
  std::string of;
  double threshold = 0; ///< see EventReport::value
  /// Share of the film's volume that may be beyond the threshold.
  double quantile = 1e-3;
  /// Stops the run with exit code 4.
  bool fatal = false;
};

struct Environment
{
  /// Acceleration (m/s^2).
  std::array<double, 3> gravity{{0, 0, 0}};
  /// Air drag per undeformed film volume and velocity (kg/(m^3 s)).
  double air_drag = 0;
};

enum class Start
{
  unrelaxed, ///< A = 1: the pre-stretch has just been applied
  relaxed    ///< A = C^{-1} everywhere in the starting equilibrium
};

enum class Analysis
{
  equilibrium,       ///< static path through the signals' times
  continuation,      ///< static path that may turn back in the signals' time
  quasi_static,      ///< viscous networks evolve, no inertia
  transient,         ///< with inertia
  frequency_response ///< settled motions over frequencies, lumped models only
};

/// The device.
struct Device
{
  std::string title;
  MeshDescription mesh;
  std::vector<Film> films;
  std::vector<Electrode> electrodes;
  std::vector<Support> supports;
  std::vector<RigidBar> bars;
  std::vector<Frame> frames;
  std::vector<Hinge> hinges;
  std::vector<RigidBody> bodies;
  std::vector<PointMass> masses;
  std::vector<PointLoad> point_loads;
  std::vector<Pressure> pressures;
  std::vector<EdgeLoad> edge_loads;
  std::vector<Probe> probes;
  std::vector<EventDescription> events;
  Environment environment;
};
} // namespace taut::structure
