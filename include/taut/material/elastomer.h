#pragma once

#include <taut/material/dielectric.h>
#include <taut/material/fibre_family.h>
#include <taut/material/held_width.h>
#include <taut/material/network.h>
#include <taut/material/number.h>

#include <limits>
#include <vector>

// An incompressible film in plane stress, thickness eliminated: springs,
// viscous networks and families of fibres side by side, and an ideal
// dielectric. All functions are pure. C = F^T F is the metric of the plane
// (stretches squared, material axes), A points to one C_i^-1 per network and is
// ignored if there are none; all energies are per undeformed volume. `Number`
// is a double, a number of automatic differentiation or a pack of doubles. The
// functions that assembly calls at every point are flattened: with everything
// inlined a pack of doubles stays in registers, which halves their time.
namespace taut::material
{
struct Elastomer
{
  std::vector<Spring> springs;
  std::vector<Network> networks;
  Dielectric dielectric;
  double density; ///< in kg/m^3
  std::vector<FibreFamily> fibres = {};
};

/// One internal variable A per network, null if there is no network.
template <class Number>
using InternalVariables =
    const SymmetricTensor2<typename NotDeduced<Number>::type>*;

/// The `alpha` of networks that do not flow.
constexpr double frozen = std::numeric_limits<double>::infinity();

/// The elastomer at infinitely slow strain: its networks carry nothing. (One
/// whose width is held still pushes across, which does not matter where the
/// width is held: its reaction is left out.)
inline Elastomer relaxed(const Elastomer& elastomer)
{
  Elastomer result = elastomer;
  result.networks.clear();
  return result;
}

/// The small-strain shear modulus of springs and networks together, in Pa.
inline double shear_modulus(const Elastomer& elastomer)
{
  double modulus = 0.;
  for (const Spring& spring : elastomer.springs)
    modulus += shear_modulus(spring);
  for (const Network& network : elastomer.networks)
    modulus += shear_modulus(network.spring);
  return modulus;
}

/// The internal variable of an isotropic network at rest, C^-1.
template <class Number>
SymmetricTensor2<Number> relaxed_internal(const SymmetricTensor2<Number>& C)
{
  return compute_inverse(C);
}

/// The internal variable of a network at rest.
template <class Number>
SymmetricTensor2<Number> relaxed_internal(const Network& network,
                                          const SymmetricTensor2<Number>& C)
{
  return network.flow == FlowLaw::held_width
             ? compute_held_width_rest(network, C)
             : relaxed_internal(C);
}

/// Energy of springs, networks and fibres in J/m^3.
template <class Number>
Number stored_energy(const Elastomer& elastomer,
                     const SymmetricTensor2<Number>& C,
                     InternalVariables<Number> A)
{
  Number energy(0.);
  const Invariants<Number> invariants = compute_invariants(C);
  for (const Spring& spring : elastomer.springs)
    energy = energy + compute_energy(spring, invariants);
  for (const Network& network : elastomer.networks)
    energy =
        energy + compute_energy(network.spring, compute_invariants(C, *A++));
  for (const FibreFamily& family : elastomer.fibres)
    energy = energy + StrainedFibres<Number>(family, C, invariants.p).energy;
  return energy;
}

/// Energy at prescribed voltage in J/m^3: stored, less
/// eps_0 eps_r/2 (V/H)^2 det C. Its derivative is the stress.
template <class Number>
Number energy(const Elastomer& elastomer, const SymmetricTensor2<Number>& C,
              InternalVariables<Number> A, const Field& field)
{
  return stored_energy(elastomer, C, A) +
         compute_energy(elastomer.dielectric, compute_invariants(C), field);
}

/// Derivatives of the energy of springs and dielectric together.
template <class Number>
EnergyDerivatives<Number>
compute_elastic_derivatives(const Elastomer& elastomer,
                            const Invariants<Number>& invariants,
                            const Field& field)
{
  EnergyDerivatives<Number> sum =
      compute_energy_derivatives(elastomer.dielectric, invariants, field);
  for (const Spring& spring : elastomer.springs)
    sum = sum + compute_energy_derivatives(spring, invariants);
  return sum;
}

/// Second Piola-Kirchhoff stress S = 2 dW/dC in the plane, in Pa.
template <class Number>
[[gnu::flatten]] SymmetricTensor2<Number>
stress(const Elastomer& elastomer, const SymmetricTensor2<Number>& C,
       InternalVariables<Number> A, const Field& field)
{
  const Invariants<Number> invariants = compute_invariants(C);
  const EnergyDerivatives<Number> elastic =
      compute_elastic_derivatives(elastomer, invariants, field);
  SymmetricTensor2<Number> sum = {elastic.t, elastic.t, Number(0.)};
  Number l = elastic.l;
  for (const Network& network : elastomer.networks)
  {
    const EnergyDerivatives<Number> W =
        compute_energy_derivatives(network.spring, compute_invariants(C, *A));
    sum = add_scaled(sum, W.t, *A++);
    l = l + W.l;
  }
  for (const FibreFamily& family : elastomer.fibres)
  {
    const StrainedFibres<Number> fibres(family, C, invariants.p);
    sum = add_scaled(sum, fibres.derivatives.t, fibres.tensor);
    l = l + fibres.derivatives.l;
  }
  l = 2. * l;
  return combine(Number(2.), sum, l, compute_inverse(C, invariants.p));
}

/// S = stress and its derivative D = dS/dE (conventions of tensors.h) in Pa,
/// with the networks answering the strain by
/// dA = (alpha - dAdot/dA)^-1 (dAdot/dE) dE; alpha in 1/s, or `frozen`. Exact:
/// D is symmetric if the networks are frozen or at rest, else not.
template <class Number>
[[gnu::flatten]] void stress_and_stiffness(const Elastomer& elastomer,
                                           const SymmetricTensor2<Number>& C,
                                           InternalVariables<Number> A,
                                           const Field& field, double alpha,
                                           SymmetricTensor2<Number>& S,
                                           Matrix3<Number>& D)
{
  const Invariants<Number> plane = compute_invariants(C);
  const SymmetricTensor2<Number> inverse_C = compute_inverse(C, plane.p);
  StiffnessSum<Number> sum(compute_elastic_derivatives(elastomer, plane, field),
                           inverse_C);
  for (const Network& network : elastomer.networks)
  {
    const Invariants<Number> invariants = compute_invariants(C, *A);
    const EnergyDerivatives<Number> W =
        compute_energy_derivatives(network.spring, invariants);
    if (alpha == frozen)
    {
      sum.add(*A++, W, make_elastic_coefficients(W));
      continue;
    }
    if (network.flow == FlowLaw::held_width)
    {
      add_held_width(network, C, *A++, inverse_C, W, alpha, sum);
      continue;
    }
    const Flow<Number> flow = make_flow(network, invariants, W);
    sum.add(*A++, W,
            make_flowing_coefficients(
                W, flow, solve_flow(flow, invariants, alpha), invariants));
  }
  for (const FibreFamily& family : elastomer.fibres)
  {
    const StrainedFibres<Number> fibres(family, C, plane.p);
    sum.add(fibres.tensor, fibres.derivatives,
            make_elastic_coefficients(fibres.derivatives));
  }
  sum.get(S, D);
}

/// dA/dt of every network in 1/s.
template <class Number>
[[gnu::flatten]] void
rates(const Elastomer& elastomer, const SymmetricTensor2<Number>& C,
      InternalVariables<Number> A, SymmetricTensor2<Number>* A_rate)
{
  const SymmetricTensor2<Number> inverse_C = compute_inverse(C);
  for (const Network& network : elastomer.networks)
  {
    const Invariants<Number> invariants = compute_invariants(C, *A);
    const EnergyDerivatives<Number> W =
        compute_energy_derivatives(network.spring, invariants);
    if (network.flow == FlowLaw::held_width)
      *A_rate++ = compute_rate(make_held_width_flow(network, C, *A++, W));
    else
      *A_rate++ =
          compute_rate(make_flow(network, invariants, W), *A++, inverse_C);
  }
}

/// dA = (alpha - dAdot/dA)^-1 (r + (dAdot/dE) dE) of every network, for the
/// engineering strain increment (dE_xx, dE_yy, 2 dE_xy). `r` has one tensor
/// per network in 1/s; null stands for zero. alpha in 1/s.
template <class Number>
[[gnu::flatten]] void
network_response(const Elastomer& elastomer, const SymmetricTensor2<Number>& C,
                 InternalVariables<Number> A, double alpha,
                 const SymmetricTensor2<Number>& dE_engineering,
                 InternalVariables<Number> r, SymmetricTensor2<Number>* dA)
{
  const SymmetricTensor2<Number> inverse_C = compute_inverse(C);
  const SymmetricTensor2<Number> dC = {
      2. * dE_engineering.xx, 2. * dE_engineering.yy, dE_engineering.xy};
  const SymmetricTensor2<Number> zero = {Number(0.), Number(0.), Number(0.)};
  for (const Network& network : elastomer.networks)
  {
    const SymmetricTensor2<Number> right = r ? *r++ : zero;
    *dA++ =
        network.flow == FlowLaw::held_width
            ? compute_held_width_response(network, C, inverse_C, *A++, alpha,
                                          dC, right)
            : compute_response(network, C, inverse_C, *A++, alpha, dC, right);
  }
}

/// (dS/dA) dA in Pa: the change of stress when the internal variables change by
/// dA at the same strain.
template <class Number>
SymmetricTensor2<Number>
stress_change(const Elastomer& elastomer, const SymmetricTensor2<Number>& C,
              InternalVariables<Number> A, InternalVariables<Number> dA)
{
  const SymmetricTensor2<Number> inverse_C = compute_inverse(C);
  SymmetricTensor2<Number> sum = {Number(0.), Number(0.), Number(0.)};
  for (const Network& network : elastomer.networks)
    sum = add_scaled(sum, Number(1.),
                     compute_stress_change(network, C, inverse_C, *A++, *dA++));
  return sum;
}

/// Power lost in the dashpots in W/m^3, never negative.
template <class Number>
Number dissipation(const Elastomer& elastomer,
                   const SymmetricTensor2<Number>& C,
                   InternalVariables<Number> A)
{
  Number sum(0.);
  for (const Network& network : elastomer.networks)
  {
    const Invariants<Number> invariants = compute_invariants(C, *A);
    const EnergyDerivatives<Number> W =
        compute_energy_derivatives(network.spring, invariants);
    sum =
        sum +
        (network.flow == FlowLaw::held_width
             ? compute_dissipation(make_held_width_flow(network, C, *A, W), *A)
             : compute_dissipation(make_flow(network, invariants, W),
                                   invariants, W));
    ++A;
  }
  return sum;
}

/// Charge on an electrode per undeformed area in C/m^2:
/// eps_0 eps_r (V/H) det C. `nominal_field` is V/H in V/m.
template <class Number>
Number charge_density(const Elastomer& elastomer,
                      const SymmetricTensor2<Number>& C, const Field& field,
                      double nominal_field)
{
  const Invariants<Number> invariants = compute_invariants(C);
  return (vacuum_permittivity * nominal_field) *
         compute_relative_permittivity(elastomer.dielectric.permittivity,
                                       invariants, field.temperature) *
         invariants.d;
}
} // namespace taut::material
