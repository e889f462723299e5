#pragma once

#include <taut/material/isotropic.h>
#include <taut/material/number.h>

#include <cmath>
#include <variant>

// How fast a network relaxes in its present state: T = T_0 exp(-s) with a
// function s of the invariants of its elastic part, and so of t = tr(C A) and
// l = ln det(C A). s = 0 in a network at rest.
namespace taut::material
{
/// s = 0.
struct ConstantRelaxation
{
};

/// s = tau_e/sigma_0, tau_e = sqrt(3/2 dev tau : dev tau) with the Kirchhoff
/// stress tau of the network: flow that stress activates (Eyring, J. Chem.
/// Phys. 4, 1936, whose rate is this one at stresses above sigma_0). In
/// uniaxial tension tau_e is the stress of the network. So that s has
/// derivatives at rest it is rounded there: sqrt(x^2 + r^2) - r in place of x,
/// with r = stress_rounding.
struct StressActivatedRelaxation
{
  double activation_stress; ///< sigma_0 in Pa
};

/// s = k (I1 - 3) with I1 of the network's elastic part: flow that strain
/// activates. For a neo-Hookean spring I1 - 3 is twice the energy over the
/// modulus.
struct StretchActivatedRelaxation
{
  double coefficient; ///< k
};

constexpr double stress_rounding = 1e-4;

using RelaxationLaw =
    std::variant<ConstantRelaxation, StressActivatedRelaxation,
                 StretchActivatedRelaxation>;

/// (tau_e/2)^2 in Pa^2 as a sum of squares: with the elastic squares e_1, e_2
/// it is (W_l + t W_t/2)^2 + 3/4 (e_1 - e_2)^2 W_t^2.
template <class Number>
Number compute_half_stress_squared(const Invariants<Number>& invariants,
                                   const EnergyDerivatives<Number>& W)
{
  const Number mean = W.l + 0.5 * invariants.t * W.t;
  const Number difference2 = invariants.t * invariants.t - 4. * invariants.d;
  return mean * mean + 0.75 * difference2 * W.t * W.t;
}

/// s and its derivatives by t and l.
template <class Number>
struct Activation
{
  Number s, t, l;
};

template <class Number>
Activation<Number> compute_activation(const ConstantRelaxation&,
                                      const Invariants<Number>&,
                                      const EnergyDerivatives<Number>&)
{
  return {Number(0.), Number(0.), Number(0.)};
}

template <class Number>
Activation<Number> compute_activation(const StressActivatedRelaxation& law,
                                      const Invariants<Number>& invariants,
                                      const EnergyDerivatives<Number>& W)
{
  using std::sqrt;
  const Number& t = invariants.t;
  const Number mean = W.l + 0.5 * t * W.t;
  const Number mean_t = W.tl + 0.5 * (W.t + t * W.tt);
  const Number mean_l = W.ll + 0.5 * t * W.tl;
  const Number difference2 = t * t - 4. * invariants.d;
  const Number W_t2 = W.t * W.t;
  // Of the square of tau_e/2.
  const Number square_t =
      2. * mean * mean_t + 1.5 * (t * W_t2 + difference2 * W.t * W.tt);
  const Number square_l = 2. * mean * mean_l - 3. * (invariants.d * W_t2) +
                          1.5 * difference2 * W.t * W.tl;
  const double scale = 4. / (law.activation_stress * law.activation_stress);
  const Number x2 = scale * compute_half_stress_squared(invariants, W);
  // Of a network at rest nothing but rounding is left, of any sign.
  const Number zero(0.);
  const Number rounded = sqrt(select(is_less(x2, zero), zero, x2) +
                              stress_rounding * stress_rounding);
  const Number factor = (0.5 * scale) / rounded;
  return {rounded - stress_rounding, factor * square_t, factor * square_l};
}

template <class Number>
Activation<Number> compute_activation(const StretchActivatedRelaxation& law,
                                      const Invariants<Number>& invariants,
                                      const EnergyDerivatives<Number>&)
{
  return {law.coefficient * (invariants.first() - 3.), Number(law.coefficient),
          -(law.coefficient * invariants.p)};
}

/// s = ln(T_0/T) of a network at the invariants of C A, W the derivatives of
/// its energy.
template <class Number>
Activation<Number> compute_activation(const RelaxationLaw& relaxation,
                                      const Invariants<Number>& invariants,
                                      const EnergyDerivatives<Number>& W)
{
  return std::visit([&](const auto& law)
                    { return compute_activation(law, invariants, W); },
                    relaxation);
}

inline bool is_constant(const RelaxationLaw& relaxation)
{
  return std::holds_alternative<ConstantRelaxation>(relaxation);
}
} // namespace taut::material
