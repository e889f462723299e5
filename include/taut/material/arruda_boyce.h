#pragma once

#include <taut/material/isotropic.h>

#include <cmath>

namespace taut::material
{
/// Eight-chain model with the exact inverse Langevin function:
///   W = G N (y b + ln(b/sinh b)) - W(no strain),
/// y = sqrt(I1/3)/sqrt(N), b = L^-1(y), L(b) = coth b - 1/b, N = limit
/// stretch^2; admissible below I1 = 3 N (Arruda and Boyce 1993).
struct ArrudaBoyce
{
  /// G in Pa, the modulus of long chains (rubbery modulus). The small-strain
  /// shear modulus is larger by the factor L^-1(s) / (3 s), s = 1/limit
  /// stretch.
  double shear_modulus;
  double limit_stretch; ///< sqrt(N) > 1
};

/// L(b) = coth b - 1/b and its derivative.
template <class Number>
struct Langevin
{
  Number value, derivative;
};

template <class Number>
Langevin<Number> compute_langevin(const Number& b)
{
  using std::exp;
  const Number q = exp(-2. * b);
  const Number inverse_b = 1. / b;
  const Number inverse_left = 1. / (1. - q);
  return {(1. + q) * inverse_left - inverse_b,
          inverse_b * inverse_b - 4. * q * inverse_left * inverse_left};
}

/// b with L(b) = y, 0 < y < 1. Starts from a rational form with the right
/// limits at both ends (its error is 0.3 percent), after which three Newton
/// steps, each squaring the relative error, leave only rounding. Close to
/// y = 0 the rounding of L grows as 1e-16/y^2.
template <class Number>
Number compute_inverse_langevin(const Number& y)
{
  const Number y2 = y * y;
  Number b = y * (3. - y2 * (6. + y2 * (1. - 2. * y2)) * 0.2) / (1. - y2);
  for (unsigned int step = 0; step < 3; ++step)
  {
    const Langevin<Number> langevin = compute_langevin(b);
    b = b - (langevin.value - y) / langevin.derivative;
  }
  return b;
}

inline double shear_modulus(const ArrudaBoyce& spring)
{
  return spring.shear_modulus * spring.limit_stretch / 3. *
         compute_inverse_langevin(1. / spring.limit_stretch);
}

inline ArrudaBoyce scale_moduli(const ArrudaBoyce& spring, double factor)
{
  return {factor * spring.shear_modulus, spring.limit_stretch};
}

/// The first invariant that the spring never reaches.
inline double first_invariant_limit(const ArrudaBoyce& spring)
{
  return 3. * spring.limit_stretch * spring.limit_stretch;
}

/// y b + ln(b/sinh b), the energy of a chain of relative length y.
template <class Number>
Number compute_chain_energy(const Number& y)
{
  using std::exp;
  using std::log;
  const Number b = compute_inverse_langevin(y);
  const Number q = exp(-2. * b);
  return (y - 1.) * b + log(2. * b / (1. - q));
}

template <class Number>
Number compute_energy(const ArrudaBoyce& spring,
                      const Invariants<Number>& invariants)
{
  using std::sqrt;
  const Number y = sqrt(invariants.first() / 3.) / spring.limit_stretch;
  const double unstrained = compute_chain_energy(1. / spring.limit_stretch);
  return (spring.shear_modulus * spring.limit_stretch * spring.limit_stretch) *
         (compute_chain_energy(y) - unstrained);
}

/// W_1 = G b/(6 y), W_11 = G (db/dy - b/y)/(36 N y^2).
template <class Number>
FirstInvariantDerivatives<Number>
compute_derivatives(const ArrudaBoyce& spring,
                    const Invariants<Number>& invariants)
{
  using std::sqrt;
  const double limit2 = spring.limit_stretch * spring.limit_stretch;
  const Number y = sqrt(invariants.first() / (3. * limit2));
  const Number b = compute_inverse_langevin(y);
  const Number slope = 1. / compute_langevin(b).derivative;
  const Number inverse_y = 1. / y;
  const Number secant = b * inverse_y;
  return {(spring.shear_modulus / 6.) * secant,
          (spring.shear_modulus / (36. * limit2)) * (slope - secant) *
              inverse_y * inverse_y};
}
} // namespace taut::material
