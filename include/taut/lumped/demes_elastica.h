#pragma once

#include <taut/lumped/demes_run.h>

#include <vector>

namespace taut::lumped
{
/// A DEMES whose massless, inextensible frame takes the shape that the film
/// gives it, an elastica loaded at its ends, instead of a circular arc. The
/// film runs between rigid stand-offs of height h at the ends, on the hollow
/// side. All lengths are over the length C of the frame.
///
/// The half frame, phi(s) from its middle: phi'' = -p sin(phi), phi(0) = 0,
/// phi'(1/2) = p h cos(phi_end), chord = 2 int cos(phi) - 2 h sin(phi_end),
/// lambda = lambda_p chord, and p = P C^2 / (E I) = 4 lambda_p s(lambda) / K.
struct DemesElastica
{
  /// Its eccentricity and rest angle must be zero; K = 4 EI / C over mu_0 V_0
  /// as for the arc.
  Demes demes;
  /// h / C, zero or positive.
  double standoff = 0;
};

/// Errors: BadInput that names the first impossible parameter.
void validate(const DemesElastica& elastica);

/// The frame between the rotations of its ends.
struct ElasticaShape
{
  /// phi(1/2) (rad).
  double end_angle = 0;
  /// C phi'(0) and C phi'(1/2).
  double mid_curvature = 0;
  double end_curvature = 0;
  /// p, positive where the film pulls.
  double load = 0;
  /// Distance of the ends of the frame, without stand-offs, over C.
  double frame_chord = 1;
  /// Height of the middle above the line between the ends, over C.
  double sag = 0;
};

/// The half frame that starts with the curvature and under the load given, by
/// Jacobi's elliptic functions.
ElasticaShape compute_elastica(double mid_curvature, double load);

struct ElasticaEquilibrium
{
  ElasticaShape shape;
  /// Distance of the film's ends over C.
  double chord = 1;
  double stretch = 0;
  double membrane_force = 0;
  /// Of the end rotation, the frame following without inertia.
  DemesFrequencies frequencies;
  /// relaxed_squared > 0.
  bool stable = false;
};

/// The straight equilibrium, if there is no stand-off, and the relaxed ones
/// that a pulling film bends to positive angles, by increasing angle. Without
/// stand-offs those bent have mirror images.
/// Errors: BadInput for impossible parameters.
std::vector<ElasticaEquilibrium> find_equilibria(const DemesElastica& elastica,
                                                 double drive);

/// As for the arc, which buckles at 12 EI / C^2 instead of pi^2 EI / C^2.
/// Errors: BadInput if there is a stand-off.
double compute_critical_pre_stretch(const DemesElastica& elastica);
double compute_flattening_drive(const DemesElastica& elastica);

/// The end rotation as the only coordinate with inertia: in the same units
///   theta'' = -(K / 2) (phi'(1/2) - p h cos(theta)),
/// the rest of the frame follows in equilibrium.
struct ElasticaRow
{
  /// tau.
  double time = 0;
  double velocity = 0;
  double inner_stretch = 0;
  double stretch = 0;
  /// e.
  double drive = 0;
  double membrane_force = 0;
  ElasticaShape shape;
};

struct ElasticaRunOptions
{
  double start_time = 0;
  double end_time = 0;
  /// Increasing; start and end are always written.
  std::vector<double> output_times;
  DemesState start;
  time::OdeOptions ode;
};

/// Errors: BadInput for impossible parameters or if no frame in equilibrium has
/// the start's end rotation: a straight start needs p < 4 pi^2, above which
/// even clamped ends do not hold the frame straight. SolverFailed as
/// time::integrate_ode.
std::vector<ElasticaRow> run_elastica(const DemesElastica& elastica,
                                      const ElasticaRunOptions& options);
} // namespace taut::lumped
