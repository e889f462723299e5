#pragma once

#include <taut/material/relaxation_law.h>
#include <taut/material/spring.h>

namespace taut::material
{
/// What a dashpot lets flow.
enum class FlowLaw
{
  isotropic, ///< every direction alike
  held_width ///< the first material axis only, see held_width.h
};

/// A spring in series with a dashpot, beside the other parts of an elastomer.
/// Its viscosity is eta = G T with G the small-strain modulus of its spring.
struct Network
{
  Spring spring;
  double relaxation_time; ///< T_0 in s, that at rest
  FlowLaw flow = FlowLaw::isotropic;
  /// T over T_0 in other states; constant if the width is held.
  RelaxationLaw relaxation = ConstantRelaxation{};
};

/// How the internal variable A = C_i^-1 of an isotropic network moves. From the
/// deviator of the Kirchhoff stress tau = 2 W_t b + 2 W_l (in the plane, b = F
/// A F^T; tau = 0 across the thickness) and an isotropic, isochoric flow (Reese
/// and Govindjee 1998), F^-1 (dev tau) b F^-T = -eta dA/dt. With A C A = t A -
/// d C^-1 that is
///   dA/dt = mobility (a C^-1 - b A),  mobility = 2/eta_0,
///   a = q d W_t,  b = q (2 t W_t + W_l)/3,  q = T_0/T,
/// with the viscosity eta_0 at rest.
template <class Number>
struct Flow
{
  double mobility;               ///< 2/eta_0 in 1/(Pa s)
  Number a, b;                   ///< in Pa
  Number a_t, a_l;               ///< derivatives of a by t and ln d
  Number b_t, b_l;               ///< derivatives of b by t and ln d
  Number quickness = Number(1.); ///< q
};

/// The flow at q = 1.
template <class Number>
Flow<Number> make_constant_flow(const Network& network,
                                const Invariants<Number>& invariants,
                                const EnergyDerivatives<Number>& W)
{
  const double mobility =
      2. / (shear_modulus(network.spring) * network.relaxation_time);
  const Number two_t = 2. * invariants.t;
  constexpr double third = 1. / 3.;
  return {mobility,
          invariants.d * W.t,
          third * (two_t * W.t + W.l),
          invariants.d * W.tt,
          invariants.d * (W.t + W.tl),
          third * (2. * W.t + two_t * W.tt + W.tl),
          third * (two_t * W.tl + W.ll)};
}

/// The flow at the q of the network's law.
template <class Number>
[[gnu::noinline]] Flow<Number>
make_activated_flow(const Network& network,
                    const Invariants<Number>& invariants,
                    const EnergyDerivatives<Number>& W)
{
  using std::exp;
  const Activation<Number> activation =
      compute_activation(network.relaxation, invariants, W);
  const Number q = exp(activation.s);
  const Flow<Number> flow = make_constant_flow(network, invariants, W);
  return {flow.mobility,
          q * flow.a,
          q * flow.b,
          q * (flow.a_t + activation.t * flow.a),
          q * (flow.a_l + activation.l * flow.a),
          q * (flow.b_t + activation.t * flow.b),
          q * (flow.b_l + activation.l * flow.b),
          q};
}

template <class Number>
Flow<Number> make_flow(const Network& network,
                       const Invariants<Number>& invariants,
                       const EnergyDerivatives<Number>& W)
{
  if (is_constant(network.relaxation))
    return make_constant_flow(network, invariants, W);
  // By way of copies, so that the numbers of constant laws stay in registers.
  const Invariants<Number> invariants_copy = invariants;
  const EnergyDerivatives<Number> W_copy = W;
  const Flow<Number> flow =
      make_activated_flow(network, invariants_copy, W_copy);
  return {flow.mobility, flow.a,   flow.b,   flow.a_t,
          flow.a_l,      flow.b_t, flow.b_l, flow.quickness};
}

/// The solution of alpha dA = r + (dAdot/dE) dE + (dAdot/dA) dA, dC = 2 dE:
///   dA = R - w b' A + w a' C^-1,   R = resolvent r - w a C^-1 dC C^-1,
/// where a' and b' are the changes of a and b and w = mobility resolvent. They
/// follow from dt = A : dC + C : dA and dl = C^-1 : dC + A^-1 : dA, which solve
/// two linear equations with the right-hand sides A : dC + C : R and
/// C^-1 : dC + A^-1 : R.
template <class Number>
struct FlowSolution
{
  Number resolvent; ///< 1/(alpha + mobility b) in s, 0 if frozen
  Number w;         ///< mobility times resolvent
  Number t_t, t_l;  ///< dt by the two right-hand sides
  Number l_t, l_l;  ///< dl by the two right-hand sides
};

/// `alpha` in 1/s; infinity freezes the flow.
template <class Number>
FlowSolution<Number> solve_flow(const Flow<Number>& flow,
                                const Invariants<Number>& invariants,
                                double alpha)
{
  const Number resolvent = 1. / (alpha + flow.mobility * flow.b);
  const Number w = flow.mobility * resolvent;
  const Number& t = invariants.t;
  const Number tp = t * invariants.p;
  const Number t_t = 1. + w * (t * flow.b_t - 2. * flow.a_t);
  const Number t_l = w * (t * flow.b_l - 2. * flow.a_l);
  const Number l_t = w * (2. * flow.b_t - tp * flow.a_t);
  const Number l_l = 1. + w * (2. * flow.b_l - tp * flow.a_l);
  const Number inverse_determinant = 1. / (t_t * l_l - t_l * l_t);
  return {resolvent,
          w,
          l_l * inverse_determinant,
          -(t_l * inverse_determinant),
          -(l_t * inverse_determinant),
          t_t * inverse_determinant};
}

/// The stiffness of a network whose internal variable answers the strain.
/// With dC alone (r = 0), C : R = -w a C^-1 : dC and, by the theorem of Cayley
/// and Hamilton for C A, A^-1 : R = -w a p (t C^-1 - A) : dC.
template <class Number>
StiffnessCoefficients<Number> make_flowing_coefficients(
    const EnergyDerivatives<Number>& W, const Flow<Number>& flow,
    const FlowSolution<Number>& solution, const Invariants<Number>& invariants)
{
  const Number wa = solution.w * flow.a;
  const Number wap = wa * invariants.p;
  const Number rest = 1. - wap * invariants.t;
  const Number t_a = solution.t_t + solution.t_l * wap;
  const Number t_c = solution.t_l * rest - solution.t_t * wa;
  const Number l_a = solution.l_t + solution.l_l * wap;
  const Number l_c = solution.l_l * rest - solution.l_t * wa;
  const Number wW = solution.w * W.t;
  const Number a_t = W.tt - wW * flow.b_t;
  const Number a_l = W.tl - wW * flow.b_l;
  const Number c_t = W.tl + wW * flow.a_t;
  const Number c_l = W.ll + wW * flow.a_l;
  return {a_t * t_a + a_l * l_a, a_t * t_c + a_l * l_c, c_t * t_a + c_l * l_a,
          c_t * t_c + c_l * l_c, W.l + wW * flow.a};
}

/// dA/dt in 1/s.
template <class Number>
SymmetricTensor2<Number> compute_rate(const Flow<Number>& flow,
                                      const SymmetricTensor2<Number>& A,
                                      const SymmetricTensor2<Number>& inverse_C)
{
  const Number factor_C = flow.mobility * flow.a;
  const Number factor_A = -(flow.mobility * flow.b);
  return combine(factor_C, inverse_C, factor_A, A);
}

/// dev tau : dev tau/(2 eta) in W/m^3, a sum of squares.
template <class Number>
Number compute_dissipation(const Flow<Number>& flow,
                           const Invariants<Number>& invariants,
                           const EnergyDerivatives<Number>& W)
{
  return (2. / 3. * flow.mobility) * flow.quickness *
         compute_half_stress_squared(invariants, W);
}

/// dA = (alpha - dAdot/dA)^-1 (r + (dAdot/dC) dC), see FlowSolution.
template <class Number>
SymmetricTensor2<Number>
compute_response(const Network& network, const SymmetricTensor2<Number>& C,
                 const SymmetricTensor2<Number>& inverse_C,
                 const SymmetricTensor2<Number>& A, double alpha,
                 const SymmetricTensor2<Number>& dC,
                 const SymmetricTensor2<Number>& r)
{
  const Invariants<Number> invariants = compute_invariants(C, A);
  const Flow<Number> flow =
      make_flow(network, invariants,
                compute_energy_derivatives(network.spring, invariants));
  const FlowSolution<Number> solution = solve_flow(flow, invariants, alpha);
  const Number& w = solution.w;
  const Number minus_wa = -(w * flow.a);
  const SymmetricTensor2<Number> R =
      combine(solution.resolvent, r, minus_wa, sandwich(inverse_C, dC));
  const Number right_t = contract(A, dC) + contract(C, R);
  const Number right_l =
      contract(inverse_C, dC) + contract(compute_inverse(A), R);
  const Number dt = solution.t_t * right_t + solution.t_l * right_l;
  const Number dl = solution.l_t * right_t + solution.l_l * right_l;
  const Number factor_A = -(w * (flow.b_t * dt + flow.b_l * dl));
  const Number factor_C = w * (flow.a_t * dt + flow.a_l * dl);
  return add_scaled(add_scaled(R, factor_A, A), factor_C, inverse_C);
}

/// (dS/dA) dA of S = 2 (W_t A + W_l C^-1), in Pa.
template <class Number>
SymmetricTensor2<Number>
compute_stress_change(const Network& network, const SymmetricTensor2<Number>& C,
                      const SymmetricTensor2<Number>& inverse_C,
                      const SymmetricTensor2<Number>& A,
                      const SymmetricTensor2<Number>& dA)
{
  const EnergyDerivatives<Number> W =
      compute_energy_derivatives(network.spring, compute_invariants(C, A));
  const Number two_dt = 2. * contract(C, dA);
  const Number two_dl = 2. * contract(compute_inverse(A), dA);
  const Number factor_A = W.tt * two_dt + W.tl * two_dl;
  const Number factor_C = W.tl * two_dt + W.ll * two_dl;
  const Number two_t = 2. * W.t;
  return add_scaled(combine(factor_A, A, factor_C, inverse_C), two_t, dA);
}
} // namespace taut::material
