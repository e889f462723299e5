#pragma once

#include <taut/lumped/resonator.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace taut::lumped
{
enum class Strip
{
  a,
  b
};

/// Nominal stresses s_1, s_2 over G and ds_1 / dlambda_1 at held internal
/// stretches.
struct StripResponse
{
  double stress_1 = 0;
  double stress_2 = 0;
  double stiffness_1 = 0;
};

/// A strip whose internal stretches are held: an elastic Gent solid per
/// network. With e_1 = (lambda_1 / lambda^i_1)^2, e_2 likewise,
/// e_3 = 1 / (e_1 e_2) and D = J_lim - e_1 - e_2 - e_3 + 3 of each network (the
/// ground network has weight chi and internal stretches 1), and with
/// E = V* in strip A, 0 in B:
///   s_1 = sum g J_lim (e_1 - e_3) / (lambda_1 D) - E^2 lambda_1 lambda_2^2
///   s_2 = sum g J_lim (e_2 - e_3) / (lambda_2 D) - E^2 lambda_2 lambda_1^2
///                                     (static parts of 3.7, 3.8, 3.12, 3.13)
/// Errors of all functions of the stretch: StepRejected if a D is not positive.
class FrozenStrip
{
public:
  FrozenStrip(const Resonator& resonator, Strip strip);

  /// Takes the internal stretches of this strip from all of the resonator's.
  void freeze(const double* internal);

  StripResponse respond(double stretch_1, double voltage) const;
  /// Whether the stretch and every D are positive.
  bool is_admissible(double stretch_1) const;
  /// The stretches between which it is so.
  std::pair<double, double> compute_admissible_interval() const;

  /// Writes d lambda^i / dt of this strip into its places among all rates:
  ///   lambda^i_1 / (6 T) J_lim / D (2 e_1 - e_2 - e_3), 2 likewise
  ///                                                     (3.19 to 3.22).
  void compute_rates(double stretch_1, double* rates) const;

  /// Legendre-transformed energy per volume over G,
  ///   sum g Psi(e) - E^2 lambda_1^2 lambda_2^2 / 2,
  ///   Psi = -J_lim / 2 ln(1 - (e_1 + e_2 + e_3 - 3) / J_lim)
  /// (3.3, 3.4).
  double compute_energy(double stretch_1, double voltage) const;

  /// Dissipated power per volume over G (1/s):
  ///   sum g / (2 T) (J_lim / D)^2 |dev diag(e)|^2.
  double compute_dissipation(double stretch_1) const;

private:
  struct Network;
  /// Squares of the elastic stretches of a network, and its D.
  struct Elastic
  {
    double e1, e2, e3, margin;
  };
  Elastic compute_elastic(const Network& network, double square_1) const;

  struct Network
  {
    double weight;
    /// 1 / (6 T), zero for the ground network.
    double mobility;
    double internal_1;
    double internal_2;
    double inverse_square_1;
    double e2;
    /// e_3 lambda_1^2.
    double e3_square_1;
  };
  double gent_limit_;
  double stretch_2_;
  bool electrified_;
  /// Place of this strip's first internal stretch.
  std::size_t offset_;
  /// The ground network first.
  std::vector<Network> networks_;
};

/// Both strips with held internal stretches.
class FrozenResonator
{
public:
  /// The resonator must outlive it.
  explicit FrozenResonator(const Resonator& resonator);

  /// `internal`: n_internal() stretches.
  void freeze(const double* internal);

  /// lambda_1A with s_1A = s_1B (3.16), to round-off, by Newton from `guess`.
  /// Errors: StepRejected if there is none or it is not stable.
  double find_balance(double voltage, double guess) const;
  /// The same from nowhere: slower, but finds the balance wherever it is.
  double find_balance(double voltage) const;

  StripResponse respond_a(double stretch_1a, double voltage) const;
  StripResponse respond_b(double stretch_1a) const;

  /// Omega_n^2 = (omega_n^2 / alpha) = ds_1A / dlambda_1A + k ds_1B /
  /// dlambda_1B at held internal stretches (3.28, 3.29): negative where the
  /// balance is unstable.
  double compute_frequency_squared(double stretch_1a, double voltage) const;

  /// All n_internal() rates.
  void compute_rates(double stretch_1a, double* rates) const;

  /// Of both strips, over G and the undeformed volume of A.
  double compute_energy(double stretch_1a, double voltage) const;
  double compute_dissipation(double stretch_1a) const;

  const Resonator& get_resonator() const
  {
    return resonator_;
  }

private:
  /// s_1A - s_1B and its derivative.
  std::pair<double, double> compute_imbalance(double stretch_1a,
                                              double voltage) const;
  bool is_admissible(double stretch_1a) const;

  const Resonator& resonator_;
  FrozenStrip a_;
  FrozenStrip b_;
};
} // namespace taut::lumped
