#pragma once

#include <taut/material/elastomer.h>

#include <cmath>
#include <limits>
#include <string>

// Where the laws of an elastomer hold: every law that does not hold everywhere
// names a quantity that must stay below a limit.
namespace taut::material
{
enum class LimitedLaw
{
  spring,          ///< I1 of a spring with a limit
  network_spring,  ///< I1 of the elastic part of a network
  fibre_family,    ///< the exponent k2 e^2
  permittivity,    ///< under voltage; minus its factor by the stretches
  relaxation_time, ///< ln(T_0/T) of a network
};

/// A quantity that must stay below `limit`.
template <class Number>
struct LimitedQuantity
{
  LimitedLaw law;
  unsigned int index; ///< of the spring, network or family
  Number value;
  double limit;
  double undeformed; ///< the value in the undeformed state
};

/// Calls visit(quantity) for everything that bounds the energy at a state.
template <class Number, class Visit>
void visit_energy_limits(const Elastomer& elastomer,
                         const SymmetricTensor2<Number>& C,
                         InternalVariables<Number> A, const Field& field,
                         const Visit& visit)
{
  const Invariants<Number> plane = compute_invariants(C);
  const auto visit_spring = [&](const LimitedLaw law, const unsigned int index,
                                const Spring& spring, const Number& first)
  {
    const double limit = first_invariant_limit(spring);
    if (limit < frozen)
      visit(LimitedQuantity<Number>{law, index, first, limit, 3.});
  };
  for (unsigned int i = 0; i < elastomer.springs.size(); ++i)
    visit_spring(LimitedLaw::spring, i, elastomer.springs[i], plane.first());
  for (unsigned int i = 0; i < elastomer.networks.size(); ++i)
    visit_spring(LimitedLaw::network_spring, i, elastomer.networks[i].spring,
                 compute_invariants(C, A[i]).first());
  for (unsigned int i = 0; i < elastomer.fibres.size(); ++i)
  {
    const FibreFamily& family = elastomer.fibres[i];
    if (const auto* law = std::get_if<ExponentialFibres>(&family.law))
      visit(LimitedQuantity<Number>{LimitedLaw::fibre_family, i,
                                    compute_exponent(*law, family, C, plane.p),
                                    largest_exponent, 0.});
  }
  const auto* const permittivity =
      std::get_if<StretchPermittivity>(&elastomer.dielectric.permittivity);
  if (permittivity && field.nominal_squared != 0.)
    visit(LimitedQuantity<Number>{LimitedLaw::permittivity, 0,
                                  -compute_stretch_factor(*permittivity, plane),
                                  0., -1.});
}

/// Calls visit(quantity) for everything that bounds the flow at a state.
template <class Number, class Visit>
void visit_flow_limits(const Elastomer& elastomer,
                       const SymmetricTensor2<Number>& C,
                       InternalVariables<Number> A, const Visit& visit)
{
  for (unsigned int i = 0; i < elastomer.networks.size(); ++i)
  {
    const Network& network = elastomer.networks[i];
    if (is_constant(network.relaxation))
      continue;
    const Invariants<Number> invariants = compute_invariants(C, A[i]);
    const EnergyDerivatives<Number> W =
        compute_energy_derivatives(network.spring, invariants);
    visit(LimitedQuantity<Number>{
        LimitedLaw::relaxation_time, i,
        compute_activation(network.relaxation, invariants, W).s,
        largest_exponent, 0.});
  }
}

/// No voltage: permittivities do not matter.
constexpr Field no_voltage = {0., 0.};

/// Some metric in which the energy is defined.
template <class Number>
Mask<Number>
is_within_limits(const Elastomer& elastomer, const SymmetricTensor2<Number>& C,
                 InternalVariables<Number> A, const Field& field = no_voltage)
{
  const Mask<Number> positive = is_less(Number(0.), compute_determinant(C));
  Mask<Number> within = positive & is_less(Number(0.), C.xx);
  visit_energy_limits<Number>(
      elastomer, C, A, field,
      [&within](const LimitedQuantity<Number>& limited)
      { within = within & is_less(limited.value, Number(limited.limit)); });
  return within;
}

/// How far a quantity is from its limit, relative to the way from the
/// undeformed state.
template <class Number>
double compute_margin(const LimitedQuantity<Number>& limited)
{
  return (limited.limit - largest(limited.value)) /
         (limited.limit - limited.undeformed);
}

/// The smaller of two numbers, NaN if one of them is.
inline double get_smaller(double a, double b)
{
  return a < b || std::isnan(a) ? a : b;
}

/// The smallest margin of all laws, 1 undeformed, to stay above 0 for the state
/// to be admissible; infinity if no law has a limit, NaN if the state of a
/// limited law is.
template <class Number>
double
limit_margin(const Elastomer& elastomer, const SymmetricTensor2<Number>& C,
             InternalVariables<Number> A, const Field& field = no_voltage)
{
  double margin = std::numeric_limits<double>::infinity();
  const auto visit = [&margin](const LimitedQuantity<Number>& limited)
  { margin = get_smaller(margin, compute_margin(limited)); };
  visit_energy_limits<Number>(elastomer, C, A, field, visit);
  visit_flow_limits<Number>(elastomer, C, A, visit);
  return margin;
}

/// What is exceeded where limit_margin is not positive: the quantity with the
/// smallest margin, its value, its limit and the law, as in "I1 = 72.3 is
/// beyond the limit 70 of the Gent spring 1". Empty if nothing is exceeded.
std::string describe_limit(const Elastomer& elastomer,
                           const SymmetricTensor2<double>& C,
                           InternalVariables<double> A, const Field& field);
} // namespace taut::material
