#pragma once

#include <taut/material/network.h>

#include <cmath>

// The dashpot of a film whose width is held (Wang et al., Sci Rep 14:15411,
// 2024, Eq. 23): of A = C_i^-1 only a = A_xx flows, along the first material
// axis; A_yy stays and A_xy is zero. With x = C_xx a and z = W_t x + W_l, which
// is a dW/da, and mobility = 2/eta of make_flow,
//   da/dt = -2 mobility a^2 z.
// For a neo-Hookean spring under C = diag(l^2, 1), with a = 1/xi^2, this is
//   eta dxi/dt = G (l^2 xi^-3 - l^-2 xi).
namespace taut::material
{
/// Flow and its derivatives. z changes by
///   dz = z_t dt + z_l dl + W_t dx,  dx = a dC_xx + C_xx da,
/// with dt = A : dC + C : dA and dl = C^-1 : dC + A^-1 : dA.
template <class Number>
struct HeldWidthFlow
{
  Number rate;        ///< da/dt in 1/s
  Number sensitivity; ///< d(da/dt)/dz in 1/(Pa s)
  Number z;           ///< in Pa
  Number z_t, z_l;    ///< in Pa
  Number W_t;         ///< in Pa
  Number by_a;        ///< d(da/dt)/da in 1/s
};

template <class Number>
HeldWidthFlow<Number> make_held_width_flow(const Network& network,
                                           const SymmetricTensor2<Number>& C,
                                           const SymmetricTensor2<Number>& A,
                                           const EnergyDerivatives<Number>& W)
{
  const double factor =
      4. / (shear_modulus(network.spring) * network.relaxation_time);
  const Number x = C.xx * A.xx;
  const Number z = W.t * x + W.l;
  const Number z_t = x * W.tt + W.tl;
  const Number z_l = x * W.tl + W.ll;
  const Number sensitivity = -(factor * (A.xx * A.xx));
  // a dz/da = x z_t + z_l + x W_t.
  const Number by_a = -((factor * A.xx) * (2. * z + x * z_t + z_l + x * W.t));
  return {sensitivity * z, sensitivity, z, z_t, z_l, W.t, by_a};
}

/// dA/dt in 1/s.
template <class Number>
SymmetricTensor2<Number> compute_rate(const HeldWidthFlow<Number>& flow)
{
  return {flow.rate, Number(0.), Number(0.)};
}

/// -dW/da da/dt in W/m^3, a square.
template <class Number>
Number compute_dissipation(const HeldWidthFlow<Number>& flow,
                           const SymmetricTensor2<Number>& A)
{
  return -(flow.rate * flow.z) / A.xx;
}

/// z_t A + z_l C^-1 + W_t a (e_x (x) e_x) in Pa: the change of z by dC at fixed
/// A, and also a times half the change of the stress by da.
template <class Number>
SymmetricTensor2<Number>
compute_gradient(const HeldWidthFlow<Number>& flow,
                 const SymmetricTensor2<Number>& A,
                 const SymmetricTensor2<Number>& inverse_C)
{
  SymmetricTensor2<Number> gradient = combine(flow.z_t, A, flow.z_l, inverse_C);
  gradient.xx = gradient.xx + flow.W_t * A.xx;
  return gradient;
}

/// Adds stress and stiffness of the network to a sum; the stiffness is
/// symmetric at any state. alpha as in solve_flow.
template <class Number>
void add_held_width(const Network& network, const SymmetricTensor2<Number>& C,
                    const SymmetricTensor2<Number>& A,
                    const SymmetricTensor2<Number>& inverse_C,
                    const EnergyDerivatives<Number>& W, double alpha,
                    StiffnessSum<Number>& sum)
{
  const HeldWidthFlow<Number> flow = make_held_width_flow(network, C, A, W);
  sum.add(A, W, make_elastic_coefficients(W));
  sum.add_square(flow.sensitivity / (A.xx * (alpha - flow.by_a)),
                 compute_gradient(flow, A, inverse_C));
}

/// dA = (alpha - dAdot/dA)^-1 (r + (dAdot/dC) dC). The components that do not
/// flow answer r alone, and nothing if alpha is zero.
template <class Number>
SymmetricTensor2<Number> compute_held_width_response(
    const Network& network, const SymmetricTensor2<Number>& C,
    const SymmetricTensor2<Number>& inverse_C,
    const SymmetricTensor2<Number>& A, double alpha,
    const SymmetricTensor2<Number>& dC, const SymmetricTensor2<Number>& r)
{
  const HeldWidthFlow<Number> flow = make_held_width_flow(
      network, C, A,
      compute_energy_derivatives(network.spring, compute_invariants(C, A)));
  const double held = alpha > 0. ? 1. / alpha : 0.;
  const SymmetricTensor2<Number> dA = {Number(0.), held * r.yy, held * r.xy};
  const Number dz = contract(compute_gradient(flow, A, inverse_C), dC) +
                    flow.z_t * contract(C, dA) +
                    flow.z_l * contract(compute_inverse(A), dA);
  return {(r.xx + flow.sensitivity * dz) / (alpha - flow.by_a), dA.yy, dA.xy};
}

/// A at rest in a film whose A_yy is 1: z = 0. Exact for energies of I1 alone,
/// x = 1/det(C A); for others Newton's steps in ln a from there, where the
/// error is squared in each.
template <class Number>
SymmetricTensor2<Number>
compute_held_width_rest(const Network& network,
                        const SymmetricTensor2<Number>& C)
{
  using std::exp;
  using std::sqrt;
  SymmetricTensor2<Number> A = {1. / sqrt(C.xx * compute_determinant(C)),
                                Number(1.), Number(0.)};
  for (unsigned int step = 0; step < 6; ++step)
  {
    const EnergyDerivatives<Number> W =
        compute_energy_derivatives(network.spring, compute_invariants(C, A));
    const HeldWidthFlow<Number> flow = make_held_width_flow(network, C, A, W);
    const Number x = C.xx * A.xx;
    A.xx = A.xx * exp(-flow.z / (x * flow.z_t + flow.z_l + x * flow.W_t));
  }
  return A;
}
} // namespace taut::material
