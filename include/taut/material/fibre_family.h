#pragma once

#include <taut/material/isotropic.h>
#include <taut/material/number.h>

#include <array>
#include <cmath>
#include <variant>

// Fibres of one direction a_0 in the film's plane, glued to it: a film that is
// stiffer along a_0 (transversely isotropic). With e the excess of the squared
// stretch that they feel,
//   e = (kappa I1 + (1 - 3 kappa) I4)/r^2 - 1,   I4 = a_0 . C a_0,
// I1 = tr C + 1/det C, the dispersion kappa of Gasser, Ogden and Holzapfel (J.
// R. Soc. Interface 3, 2006) and the stretch r at which they are unstrained.
// C is measured from the undeformed film, so that r = 1 stands for fibres that
// lay in the film before it was pre-stretched. e is H : C + kappa/(r^2 det C)
// - 1 with a constant tensor H, hence a function of H : C and ln det C: the
// stress is 2 (W_t H + W_l C^-1), of the form that all parts of an elastomer
// have.
namespace taut::material
{
/// W = k1/2 e^2, the standard reinforcing model (Qiu and Pence, J. Elasticity
/// 49, 1997).
struct QuadraticFibres
{
  double stiffness; ///< k1 in Pa
};

/// W = k1/(2 k2) (exp(k2 e^2) - 1) (Holzapfel, Gasser and Ogden, J. Elasticity
/// 61, 2000).
struct ExponentialFibres
{
  double stiffness; ///< k1 in Pa
  double exponent;  ///< k2 > 0
};

using FibreLaw = std::variant<QuadraticFibres, ExponentialFibres>;

struct FibreFamily
{
  FibreLaw law;
  /// a_0, a unit vector in the material axes.
  std::array<double, 2> direction{{1., 0.}};
  /// Whether the fibres buckle under compression: W = 0 where e < 0.
  bool tension_only = true;
  /// kappa, from 0 (all along a_0) to 1/3 (all directions alike).
  double dispersion = 0.;
  /// r, of the film along the fibres.
  double rest_stretch = 1.;
};

/// Fibres across the first material axis with a Young's modulus (Pa), glued to
/// the stretched film: W = (modulus/8) (C_yy/rest_stretch^2 - 1)^2. They carry
/// compression.
inline FibreFamily make_fibres_across(double modulus, double rest_stretch)
{
  return {QuadraticFibres{modulus / 4.}, {{0., 1.}}, false, 0., rest_stretch};
}

/// W as a function of e >= 0 and its derivatives.
template <class Number>
struct FibreEnergy
{
  Number value, by_e, by_ee;
};

template <class Number>
FibreEnergy<Number> compute_fibre_energy(const QuadraticFibres& law,
                                         const Number& e)
{
  const Number stress = law.stiffness * e;
  return {0.5 * stress * e, stress, Number(law.stiffness)};
}

template <class Number>
FibreEnergy<Number> compute_fibre_energy(const ExponentialFibres& law,
                                         const Number& e)
{
  using std::exp;
  const Number power = law.exponent * (e * e);
  const Number growth = exp(power);
  const Number stiffness = law.stiffness * growth;
  return {(0.5 * law.stiffness / law.exponent) * (growth - 1.), stiffness * e,
          stiffness * (1. + 2. * power)};
}

/// A family in a state of the film.
template <class Number>
struct StrainedFibres
{
  StrainedFibres(const FibreFamily& family, const SymmetricTensor2<Number>& C,
                 const Number& p);

  /// H.
  SymmetricTensor2<Number> tensor;
  /// Of W by H : C and ln det C in Pa.
  EnergyDerivatives<Number> derivatives;
  Number energy; ///< W in J/m^3
};

/// e without regard to buckling; p = 1/det C.
template <class Number>
Number compute_fibre_strain(const FibreFamily& family,
                            const SymmetricTensor2<Number>& C, const Number& p)
{
  const auto& [x, y] = family.direction;
  const double rest = 1. / (family.rest_stretch * family.rest_stretch);
  const Number along = (x * x) * C.xx + (y * y) * C.yy + (2. * x * y) * C.xy;
  if (family.dispersion == 0.)
    return rest * along - 1.;
  return rest * (family.dispersion * (C.xx + C.yy + p) +
                 (1. - 3. * family.dispersion) * along) -
         1.;
}

/// e, 0 where the fibres buckle.
template <class Number>
Number compute_active_strain(const FibreFamily& family, const Number& e)
{
  const Number zero(0.);
  return family.tension_only ? select(is_less(e, zero), zero, e) : e;
}

/// k2 e^2, what an exponential function must bear, of fibres that are active.
template <class Number>
Number compute_exponent(const ExponentialFibres& law, const FibreFamily& family,
                        const SymmetricTensor2<Number>& C, const Number& p)
{
  const Number e =
      compute_active_strain(family, compute_fibre_strain(family, C, p));
  return law.exponent * (e * e);
}

template <class Number>
StrainedFibres<Number>::StrainedFibres(const FibreFamily& family,
                                       const SymmetricTensor2<Number>& C,
                                       const Number& p)
{
  const auto& [x, y] = family.direction;
  const double rest = 1. / (family.rest_stretch * family.rest_stretch);
  const double all = rest * family.dispersion;
  const double along = rest * (1. - 3. * family.dispersion);
  tensor = {Number(all + along * x * x), Number(all + along * y * y),
            Number(along * x * y)};
  const Number zero(0.);
  const Number e = compute_fibre_strain(family, C, p);
  const Number strain = compute_active_strain(family, e);
  const FibreEnergy<Number> W = std::visit(
      [&strain](const auto& law) { return compute_fibre_energy(law, strain); },
      family.law);
  energy = W.value;
  const Number by_ee =
      family.tension_only ? select(is_less(e, zero), zero, W.by_ee) : W.by_ee;
  // de = H : dC - kappa/r^2 p dl.
  const Number slope = -(all * p);
  derivatives = {W.by_e, slope * W.by_e, by_ee, slope * by_ee,
                 slope * slope * by_ee - slope * W.by_e};
}
} // namespace taut::material
