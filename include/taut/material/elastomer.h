#pragma once

#include <taut/material/dielectric.h>
#include <taut/material/held_width.h>
#include <taut/material/network.h>
#include <taut/material/number.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

// An incompressible film in plane stress, thickness eliminated: springs and
// viscous networks side by side, and an ideal dielectric. All functions are
// pure. C = F^T F is the metric of the plane (stretches squared, material
// axes), A points to one C_i^-1 per network and is ignored if there are none;
// all energies are per undeformed volume. `Number` is a double, a number of
// automatic differentiation or a pack of doubles. The functions that assembly
// calls at every point are flattened: with everything inlined a pack of doubles
// stays in registers, which halves their time.
namespace taut::material
{
/// Fibres across the first material axis, glued to the stretched film:
/// unstrained at `rest_stretch`. W = (modulus/8) (C_yy/rest_stretch^2 - 1)^2
/// per undeformed volume; they carry compression.
struct Fibres
{
  double modulus;      ///< in Pa
  double rest_stretch; ///< of the film across its first axis
};

struct Elastomer
{
  std::vector<Spring> springs;
  std::vector<Network> networks;
  Dielectric dielectric;
  double density; ///< in kg/m^3
  std::optional<Fibres> fibres = std::nullopt;
};

/// The energy of fibres in J/m^3 and its derivatives by C_yy in Pa.
template <class Number>
struct FibreEnergy
{
  Number value, by_yy;
  double by_yy_yy;
};

template <class Number>
FibreEnergy<Number> compute_fibre_energy(const Fibres& fibres,
                                         const SymmetricTensor2<Number>& C)
{
  const double inverse_rest = 1. / (fibres.rest_stretch * fibres.rest_stretch);
  const double factor = 0.25 * fibres.modulus * inverse_rest;
  const Number strain = inverse_rest * C.yy - 1.;
  return {(0.125 * fibres.modulus) * strain * strain, factor * strain,
          factor * inverse_rest};
}

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
  if (elastomer.fibres)
    energy = energy + compute_fibre_energy(*elastomer.fibres, C).value;
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
  if (elastomer.fibres)
    sum.yy = sum.yy + compute_fibre_energy(*elastomer.fibres, C).by_yy;
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
  if (elastomer.fibres)
  {
    const auto fibres = compute_fibre_energy(*elastomer.fibres, C);
    sum.add_across(fibres.by_yy, Number(fibres.by_yy_yy));
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

/// How far the first invariant is from the limit of a spring, relative to the
/// way from the undeformed state; infinity for a spring without limit.
inline double compute_margin(const Spring& spring, double first_invariant)
{
  const double limit = first_invariant_limit(spring);
  return limit < frozen ? (limit - first_invariant) / (limit - 3.) : limit;
}

/// The smaller of two numbers, NaN if one of them is.
inline double get_smaller(double a, double b)
{
  return a < b || std::isnan(a) ? a : b;
}

/// The smallest margin of all limited springs, 1 undeformed, to stay above 0
/// for the state to be admissible; infinity if no spring has a limit, NaN if
/// the state of a limited spring is.
template <class Number>
double limit_margin(const Elastomer& elastomer,
                    const SymmetricTensor2<Number>& C,
                    InternalVariables<Number> A)
{
  double margin = std::numeric_limits<double>::infinity();
  const Number first = compute_invariants(C).first();
  for (const Spring& spring : elastomer.springs)
    margin = get_smaller(margin, compute_margin(spring, largest(first)));
  for (const Network& network : elastomer.networks)
  {
    const Number elastic = compute_invariants(C, *A++).first();
    margin =
        get_smaller(margin, compute_margin(network.spring, largest(elastic)));
  }
  return margin;
}
} // namespace taut::material
