#pragma once

#include <taut/structure/description.h>
#include <taut/time/integrate.h>

#include <optional>
#include <string>
#include <vector>

/// A case: a device and what is to be done with it, as plain data.
namespace taut::study
{
/// How the rows of history.csv and the frames of fields.pvd are placed in time.
struct OutputDescription
{
  /// Number of equal intervals between start and end; 0 = only start and end.
  unsigned int history_intervals = 200;
  unsigned int field_intervals = 20;
  /// Extra times of history rows (s).
  std::vector<double> history_times;
  std::vector<double> field_times;
  bool write_fields = true;
};

struct CheckpointDescription
{
  /// Accepted steps between checkpoints; 0 = never. Restarts the integrator.
  long every_steps = 0;
  /// Simulated time between checkpoints (s); 0 = never. Restarts it too.
  double every_time = 0;
  /// Wall time between checkpoints (min); 0 = never.
  double every_minutes = 10;
};

/// How a film case begins.
enum class Shape
{
  meshed,      ///< positions of the mesh, at rest
  equilibrium, ///< the equilibrium next to them
  rest         ///< the stable shape into which a stretched film bends its frame
};

/// The way to a rest shape: the frames start stiffer than they are and soften
/// to their own stiffness, while a small load across them, which has vanished
/// at the end, decides to which side they bend.
struct RestShapeDescription
{
  /// To which side (dimensionless, any length).
  std::array<double, 3> direction{{0, 0, 1}};
  /// Of the small load, relative to what bends the frames by their length.
  double perturbation = 2;
  /// The frames start so many times stiffer.
  double first_stiffness = 10;
  /// Steps of the path, at least.
  unsigned int steps = 6;
  /// Also finds the shape on the other side and reports it.
  bool both_branches = false;
};

/// How a continuation follows equilibria through limit points and
/// bifurcations. All signals are read at the path's parameter, which runs from
/// the start time towards the end time and may turn back; so a ramp of a force,
/// voltage, charge, pressure, support or pre-stretch makes it the parameter.
struct ContinuationDescription
{
  /// The first step is this part of the range of the parameter.
  unsigned int steps = 20;
  /// Longest step, relative to the largest displacements so far and to the
  /// range of the parameter.
  double largest_step = 0.1;
  /// Number of converged points after which the path ends.
  unsigned int most_points = 1000;
  /// At a bifurcation: stay on the branch, or turn to the stable one.
  enum class Branch
  {
    primary,
    stable
  };
  Branch branch = Branch::primary;
  /// To which side the path turns (dimensionless, any length).
  std::array<double, 3> direction{{0, 0, 1}};
  /// Follows the path back from its end and tells the states that a device goes
  /// through, which jumps where a stable part ends: the hysteresis.
  bool backward = false;
};

/// The settled motions of a lumped model under
///   offset + amplitude sin(2 pi f t)
/// for a range of frequencies f.
struct FrequencyResponseDescription
{
  enum class Direction
  {
    up,
    down,
    both
  };
  double from = 0;             ///< lowest frequency (Hz)
  double to = 0;               ///< highest (Hz)
  unsigned int points = 50;    ///< number of frequencies
  bool is_logarithmic = false; ///< their spacing
  Direction direction = Direction::up;
  double offset = 0;    ///< of the source (V, or C under charge)
  double amplitude = 0; ///< of its sine (the same)
  /// Column of the lumped model that is watched; empty: its angle or its bar's
  /// displacement.
  std::string of;
  unsigned int least_periods = 32;
  unsigned int most_periods = 2000;
  /// Change of mean and amplitude that is still to come, over the amplitude.
  double settled_within = 1e-4;
  /// Each frequency from rest for a fixed time, or from where the last ended.
  bool from_rest = false;
  double observation_time = 0; ///< from rest (s)
};

struct ProcedureDescription
{
  Shape shape = Shape::equilibrium;
  RestShapeDescription rest_shape;
  ContinuationDescription continuation;
  FrequencyResponseDescription frequency_response;
  structure::Analysis analysis = structure::Analysis::transient;
  structure::Start start = structure::Start::relaxed;
  double start_time = 0; ///< (s)
  double end_time = 1;   ///< (s)
  time::IntegratorOptions integrator;
  /// Relative residual of equilibria.
  double newton_tolerance = 1e-10;
  /// Steps of a static path (analysis = equilibrium), at least.
  unsigned int load_steps = 10;
};

/// A resonator of the lumped kind ([T], physics of two strips and a bar) in SI.
struct LumpedResonatorDescription
{
  double length_active = 0;  ///< L_1A undeformed (m)
  double length_passive = 0; ///< L_1B undeformed (m)
  double width = 0;          ///< L_2 undeformed (m)
  double thickness = 0;      ///< L_3 undeformed (m)
  std::array<double, 2> pre_stretch{{1, 1}};
  double bar_mass = 0;                  ///< total (kg)
  double density = 0;                   ///< (kg/m^3)
  double shear_modulus = 0;             ///< total G = G_eq + G_neq (Pa)
  double equilibrium_share = 1;         ///< chi
  std::vector<double> network_shares;   ///< g_m, sum 1 - chi; empty = equal
  std::vector<double> relaxation_times; ///< T_m (s)
  double limit = 67;                    ///< J_lim
  bool relaxation_is_rate = false;      ///< the printed reading of tau
  double relative_permittivity = 4.7;
  double breakdown_strength = 0; ///< (V/m)
  Signal voltage;                ///< (V)
  /// For which the highest voltage that can be held is sought (s); 0 = not.
  double hold_time = 0;
};

/// With which shape a lumped DEMES begins.
enum class DemesStart
{
  rest, ///< the relaxed equilibrium without voltage at the reference
        ///< temperature
  flat  ///< the straight frame with a film that is relaxed at its pre-stretch
};

/// A dielectric elastomer minimum energy structure of the lumped kind (one
/// angle; Wang et al. 2024) in SI: a film along the chord of a frame that bends
/// into an arc.
struct LumpedDemesDescription
{
  double film_length = 0;     ///< L_0 undeformed (m)
  double film_width = 0;      ///< W_0, which is held (m)
  double film_thickness = 0;  ///< t_0 undeformed (m)
  double film_offset = 0;     ///< h, of the film from the frame's axis (m)
  double pre_stretch = 2;     ///< lambda_p; the frame is lambda_p L_0 long
  double shear_modulus = 0;   ///< mu of the elastic spring (Pa)
  double viscous_ratio = 2.5; ///< beta, of the viscous branch to mu
  double viscosity = 0;       ///< eta (Pa s)
  double relative_permittivity = 5.310702; ///< of the unstretched film
  /// a, b, c of 1 + a (l - 1) + b (l - 1)^2 + c (l - 1)^3; empty = constant.
  std::vector<double> permittivity_coefficients{-0.1658, 0.04086, -0.00302754};
  double frame_modulus = 0;   ///< Young's modulus (Pa)
  double frame_width = 0;     ///< of both legs together (m)
  double frame_thickness = 0; ///< (m)
  double inertia = 0;         ///< I, twice that of each end (kg m^2)
  double rest_angle = 0;      ///< of the frame without film (rad)
  std::string temperature_laws = "softening"; ///< by name
  double temperature = 299;                   ///< (K)
  bool charge_controlled = false;             ///< the source holds the charge
  Signal source;                              ///< voltage (V) or charge (C)
  DemesStart start = DemesStart::rest;
  double seed_angle = 0.01; ///< of a flat start (rad)
  double tolerance = 1e-9;  ///< local error of a step, relative
};

/// Which parts of the device play the parts of the lumped resonator.
struct ComparisonDescription
{
  std::string active_film;
  std::string passive_film;
  std::string electrode;
  std::string bar;
};

/// Which parts of the device play the parts of a lumped DEMES.
struct DemesComparisonDescription
{
  std::string film;
  std::string electrode;
  std::vector<std::string> legs; ///< names of frames
  std::string left_body;
  std::string right_body;
  /// Probes of the half angle (rad), of the distance of the film's ends (m) and
  /// of the film's mean stretch.
  std::string angle_probe;
  std::string chord_probe;
  std::string stretch_probe;
};

/// What `taut modes` looks for.
struct ModesDescription
{
  unsigned int count = 10;
  /// The modes next to this frequency (Hz); 0: the lowest.
  double near_frequency = 0;
  /// About which state of the run.
  enum class At
  {
    end,
    start
  };
  At at = At::end;
  /// Whether the networks are too slow to follow a vibration, or too fast to
  /// resist it.
  enum class Networks
  {
    frozen,
    relaxed
  };
  Networks networks = Networks::frozen;
  /// Largest displacement of a mode in fields.pvd, of the device's extent.
  double amplitude = 0.1;
};

/// What is found out about a motion when its run is over.
struct MotionDescription
{
  /// Probe of a film, or column of a lumped model.
  std::string of;
  /// Its rate, likewise; empty: the derivative of `of` through its rows.
  std::string velocity;
  double period = 0; ///< of the drive (s); 0: the motion is free
  double from = 0;   ///< what is before is left out (s)
  /// Spread of what repeats, over the motion's own size.
  double tolerance = 1e-3;
  bool lyapunov_exponent = false; ///< lumped models only
};

struct Case
{
  std::string file;
  /// "film": the device below by finite elements; "resonator" and "demes":
  /// lumped.
  std::string model = "film";
  structure::Device device;
  LumpedResonatorDescription lumped_resonator;
  LumpedDemesDescription lumped_demes;
  /// At most one of both.
  std::optional<ComparisonDescription> comparison;
  std::optional<DemesComparisonDescription> demes_comparison;
  std::optional<MotionDescription> motion;
  ProcedureDescription procedure;
  OutputDescription output;
  CheckpointDescription checkpoint;
  ModesDescription modes;
};
} // namespace taut::study
