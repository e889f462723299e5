#pragma once

#include <taut/base/signal.h>

namespace taut::lumped
{
/// How the permittivity follows the stretch,
///   phi = 1 + a (lambda - 1) + b (lambda - 1)^2 + c (lambda - 1)^3,
/// over its value at lambda = 1. All zero: a constant permittivity.
struct PermittivityLaw
{
  double a = 0;
  double b = 0;
  double c = 0;

  double value(const double stretch) const
  {
    const double x = stretch - 1;
    return 1 + x * (a + x * (b + x * c));
  }
  double derivative(const double stretch) const
  {
    const double x = stretch - 1;
    return a + x * (2 * b + 3 * c * x);
  }
  double second_derivative(const double stretch) const
  {
    return 2 * b + 6 * c * (stretch - 1);
  }
};

/// The coefficients of Wang, Xu, Zhou, Li and He, Sci Rep 14:15411 (2024), for
/// VHB 4905.
constexpr PermittivityLaw wang_permittivity{-0.1658, 0.04086, -0.00302754};

/// What the source connected to the electrodes holds.
enum class DemesControl
{
  voltage,
  charge
};

/// The one-angle model of a dielectric elastomer minimum energy structure: a
/// frame that bends into a circular arc of the total angle 2 theta, and a film
/// of held width along the chord between its ends. After Wang et al. (2024),
/// whose equations are (20) and (23) below, with the angle theta as half of the
/// arc's and the electric energy Legendre-transformed.
///
/// Dimensionless: time tau = t omega_0 with omega_0^2 = mu_0 V_0 / I, energies
/// over mu_0 V_0 (shear modulus of one spring at the reference temperature and
/// volume of the film), moments alike, forces along the film over mu_0 times
/// its undeformed section.
struct Demes
{
  /// lambda_p, stretch of the film in the straight frame.
  double pre_stretch = 2;
  /// K, bending stiffness 4 EI / C over mu_0 V_0.
  double frame_stiffness = 1;
  /// S, viscosity over shear modulus, in units of time.
  double relaxation = 0.03;
  /// m, shear modulus over mu_0.
  double modulus_factor = 1;
  /// g, permittivity at stretch 1 over that at the reference temperature.
  double permittivity_factor = 1;
  /// beta, modulus of the viscous branch over that of the elastic spring.
  double viscous_ratio = 2.5;
  /// epsilon = 2 h / C: the film is bonded at the distance h from the frame's
  /// neutral line, on the hollow side of positive angles.
  double eccentricity = 0;
  /// theta_0, angle of the frame without a film (rad).
  double rest_angle = 0;
  PermittivityLaw permittivity = wang_permittivity;
  DemesControl control = DemesControl::voltage;
  /// What the source does, e(tau) = drive.value(tau time_unit) / drive_unit:
  /// under prescribed voltage (V / t_0) sqrt(eps_0 eps_r / mu_0), under
  /// prescribed charge Q / (L_0 W_0 sqrt(eps_0 eps_r mu_0)).
  Signal drive;
  double drive_unit = 1;
  double time_unit = 1;
};

/// Errors: BadInput that names the first impossible parameter, its value and
/// what is allowed.
void validate(const Demes& demes);

/// Chord over length of the frame, f = sin(theta) / theta - epsilon
/// sin(theta), with f' and f''; by its power series where the quotients cancel.
struct ChordShape
{
  double value = 1;
  double slope = 0;
  double curvature = -1. / 3;
};
ChordShape compute_chord(double angle, double eccentricity);

/// Electric energy over mu_0 V_0 and its first two derivatives by the stretch
/// at a held drive e. Prescribed voltage: -g e^2 phi lambda^2 / 2; prescribed
/// charge: +e^2 / (2 g phi lambda^2).
struct ElectricState
{
  double energy = 0;
  double force = 0;
  double stiffness = 0;
  /// What the source does not hold: the charge g e phi lambda^2 under
  /// prescribed voltage, the voltage e / (g phi lambda^2) under charge.
  double conjugate = 0;
};
ElectricState compute_electric(const Demes& demes, double stretch,
                               double drive);

/// s of the boxed equations: nominal force along the film,
///   m [(l - l^-3) + beta (l xi^-2 - l^-3 xi^2)] + electric force.
double compute_membrane_force(const Demes& demes, double stretch,
                              double inner_stretch, double drive);

/// theta'' = -K (theta - theta_0) - lambda_p f' s (20).
double compute_acceleration(const Demes& demes, double angle,
                            double inner_stretch, double drive);

/// xi' = (beta / S) (l^2 xi^-3 - l^-2 xi) (23).
double compute_inner_rate(const Demes& demes, double stretch,
                          double inner_stretch);

/// Frame, film and electric energy without the kinetic part:
///   K (theta - theta_0)^2 / 2 + m [(l^2 + l^-2 - 2) / 2
///     + beta (l^2 xi^-2 + l^-2 xi^2 - 2) / 2] + electric energy.
double compute_free_energy(const Demes& demes, double angle,
                           double inner_stretch, double drive);

/// Power that the dashpot takes, m (beta^2 / S) (l^2 xi^-3 - l^-2 xi)^2.
double compute_dissipation(const Demes& demes, double stretch,
                           double inner_stretch);

/// Squares of the angular frequencies of small motions about a relaxed state
/// (xi = lambda): with a film that stays relaxed, and with a dashpot that does
/// not move meanwhile,
///   omega^2 = K + s' (lambda_p f')^2 + s lambda_p f''.
/// The first is negative where the state is unstable.
struct DemesFrequencies
{
  double relaxed_squared = 0;
  double instantaneous_squared = 0;
};
DemesFrequencies compute_frequencies(const Demes& demes, double angle,
                                     double drive);
} // namespace taut::lumped
