#pragma once

#include <taut/base/signal.h>

#include <cstddef>
#include <vector>

namespace taut::lumped
{
/// One viscous network of both strips.
struct ResonatorNetwork
{
  /// Its shear modulus over the sum of all moduli, g_m.
  double weight = 0;
  /// T_m = viscosity / modulus (s).
  double relaxation_time = 0;
};

/// What a number tau_m given for a network stands for: the thesis calls it a
/// relaxation time but prints modulus / viscosity.
enum class TauMeaning
{
  relaxation_time,
  rate
};

/// Networks that share what the ground network leaves: the weights are
/// proportional to `split` and sum to 1 - equilibrium_fraction.
/// Errors: BadInput if the lists differ in length, an entry is not positive or
/// a network is missing or too many for the fraction.
std::vector<ResonatorNetwork>
make_networks(double equilibrium_fraction, const std::vector<double>& split,
              const std::vector<double>& tau,
              TauMeaning meaning = TauMeaning::relaxation_time);

/// The membrane resonator of the thesis "Effect of material viscoelasticity on
/// frequency tuning of dielectric elastomer membrane resonators" (numbers 3.x
/// below are its equations): two strips A and B, pre-stretched in line by
/// lambda_1p and across by lambda_2p, a rigid bar between them, the voltage on
/// A only. The strips are homogeneous, keep lambda_2 = lambda_2p and are
/// incompressible Gent solids with Gent networks.
///
/// Everything is dimensionless except time (s): stresses over the sum G of all
/// shear moduli, lengths over the undeformed length of A, the voltage as
/// V* = (V / thickness) sqrt(permittivity / G).
struct Resonator
{
  /// k = L_1A / L_1B.
  double length_ratio = 1;
  /// chi, the ground network's share of the modulus, in (0, 1].
  double equilibrium_fraction = 0.5;
  /// J_lim of every network.
  double gent_limit = 67;
  /// Weights sum to 1 - equilibrium_fraction.
  std::vector<ResonatorNetwork> networks;
  double pre_stretch_1 = 2;
  double pre_stretch_2 = 4;
  /// d = breakdown field sqrt(permittivity / G).
  double strength = 5;
  /// rho L_1A^2 / (3 G), rho L_1B^2 / (3 G) and m L_1A / (G L_2 L_3) (s^2) with
  /// the total mass m of the bar: the three parts of 1 / alpha in (3.15).
  double inertia_a = 0;
  double inertia_b = 0;
  double inertia_bar = 1;
  /// V* = voltage.value(t) / voltage_unit.
  Signal voltage;
  double voltage_unit = 1;

  /// lambda_1B of (3.9): the far ends of both strips stay where they are.
  double get_stretch_1b(const double stretch_1a) const
  {
    return pre_stretch_1 + length_ratio * (pre_stretch_1 - stretch_1a);
  }
  /// alpha (1/s^2) of (3.15), with the sign of B's part and the bar's mass
  /// as the derivation gives them.
  double get_alpha() const
  {
    return 1 / (inertia_a + length_ratio * inertia_b + inertia_bar);
  }
  /// Four internal stretches per network, in the order 1A, 2A, 1B, 2B.
  std::size_t n_internal() const
  {
    return 4 * networks.size();
  }
};

/// Errors: BadInput that names the first impossible parameter, its value and
/// what is allowed.
void validate(const Resonator& resonator);
} // namespace taut::lumped
