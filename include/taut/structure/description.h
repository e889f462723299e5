#pragma once

#include <taut/base/signal.h>
#include <taut/material/elastomer.h>

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
  /// Temperature (K).
  double temperature = 293.15;
};

struct Electrode : Named
{
  /// Physical surfaces.
  std::vector<std::string> groups;
  /// Voltage (V) between the two faces.
  Signal voltage;
};

/// Holds components of the position over points, lines or surfaces.
struct Support : Named
{
  std::vector<std::string> groups;
  std::array<bool, 3> held{{true, true, true}};
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
    capacitance,          ///< of an electrode (F)
    reaction,             ///< of a support (N); static and quasi-static parts
    mean_stretch,         ///< of a film along component 0 or 1 of its axes
    mean_stress,          ///< nominal stress of a film along 0 or 1 (Pa)
    min_principal_stress, ///< smallest true principal stress of a film (Pa)
    max_true_field,       ///< of a film (V/m)
    volume ///< enclosed between surface groups and z = 0 plane (m^3)
  };
  Kind kind = Kind::displacement;
  /// Name of the bar, electrode, support or film; or physical groups.
  std::string of;
  /// Coordinates in the mesh (m) for point probes without `of`.
  std::array<double, 3> point{{0, 0, 0}};
  /// 0, 1, 2 = x, y, z, or first and second axis of the film.
  unsigned int component = 0;
};

struct EventDescription : Named
{
  enum class Kind
  {
    tension_loss, ///< smaller principal stress below `threshold` (Pa)
    breakdown,    ///< true field above the strength of the film
    probe_above,  ///< probe rises above threshold
    probe_below   ///< probe falls below threshold
  };
  Kind kind = Kind::tension_loss;
  /// Film (empty = all films) or probe.
  std::string of;
  double threshold = 0;
  /// Share of the film's area that may be beyond the threshold.
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
  equilibrium,  ///< static path through the signals' times
  quasi_static, ///< viscous networks evolve, no inertia
  transient     ///< with inertia
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
  std::vector<Pressure> pressures;
  std::vector<EdgeLoad> edge_loads;
  std::vector<Probe> probes;
  std::vector<EventDescription> events;
  Environment environment;
};
} // namespace taut::structure
