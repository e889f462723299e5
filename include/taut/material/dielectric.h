#pragma once

#include <taut/material/breakdown_law.h>
#include <taut/material/isotropic.h>

#include <cmath>
#include <variant>

namespace taut::material
{
/// Permittivity of the vacuum in F/m (CODATA 2018).
constexpr double vacuum_permittivity = 8.8541878128e-12;

struct ConstantPermittivity
{
  double relative; ///< eps_r
};

/// eps_r = (eps_inf + A/T) (1 + a x + b x^2 + c x^3), x = lambda_1 + lambda_2
/// - 2 with the principal stretches in the plane. Defaults: VHB 4905 (Wang et
/// al., Sci Rep 14:15411, 2024).
struct StretchPermittivity
{
  double high_temperature = 2.1; ///< eps_inf
  double dipole = 960.;          ///< A in K
  double linear = -0.1658;       ///< a
  double quadratic = 0.04086;    ///< b
  double cubic = -0.00302754;    ///< c
};

using PermittivityLaw = std::variant<ConstantPermittivity, StretchPermittivity>;

/// Ideal dielectric: the permittivity alone couples the field to the strain.
struct Dielectric
{
  PermittivityLaw permittivity = ConstantPermittivity{1.};
  /// Of the largest true field.
  BreakdownLaw breakdown = {};
};

/// What loads the dielectric at prescribed voltage V.
struct Field
{
  double nominal_squared; ///< (V/H)^2 in V^2/m^2, H the undeformed thickness
  double temperature;     ///< in K
};

/// The factor (eps_inf + A/T) of the stretch-dependent law.
inline double compute_unstretched_permittivity(const StretchPermittivity& law,
                                               double temperature)
{
  return law.high_temperature + law.dipole / temperature;
}

/// The law with the permittivity multiplied by a factor.
inline ConstantPermittivity scale(const ConstantPermittivity& law,
                                  double factor)
{
  return {factor * law.relative};
}

inline StretchPermittivity scale(const StretchPermittivity& law, double factor)
{
  StretchPermittivity result = law;
  result.high_temperature *= factor;
  result.dipole *= factor;
  return result;
}

/// lambda_1 + lambda_2 = tr sqrt(C) = sqrt(t + 2 sqrt(d)).
template <class Number>
Number compute_stretch_sum(const Invariants<Number>& invariants)
{
  using std::sqrt;
  const Number area_stretch = sqrt(invariants.d);
  return sqrt(invariants.t + 2. * area_stretch);
}

template <class Number>
Number compute_relative_permittivity(const ConstantPermittivity& law,
                                     const Invariants<Number>&, double)
{
  return Number(law.relative);
}

/// 1 + a x + b x^2 + c x^3, to stay positive.
template <class Number>
Number compute_stretch_factor(const StretchPermittivity& law,
                              const Invariants<Number>& invariants)
{
  const Number x = compute_stretch_sum(invariants) - 2.;
  return 1. + x * (law.linear + x * (law.quadratic + x * law.cubic));
}

template <class Number>
Number compute_relative_permittivity(const StretchPermittivity& law,
                                     const Invariants<Number>& invariants,
                                     double temperature)
{
  return compute_unstretched_permittivity(law, temperature) *
         compute_stretch_factor(law, invariants);
}

/// eps_r at the invariants of C and a temperature in K.
template <class Number>
Number compute_relative_permittivity(const PermittivityLaw& permittivity,
                                     const Invariants<Number>& invariants,
                                     double temperature)
{
  return std::visit(
      [&](const auto& law)
      { return compute_relative_permittivity(law, invariants, temperature); },
      permittivity);
}

/// -eps_0 eps_r/2 (V/H)^2 det C, per undeformed volume in J/m^3: the energy at
/// prescribed voltage, less the work of the source.
template <class Number>
Number compute_energy(const Dielectric& dielectric,
                      const Invariants<Number>& invariants, const Field& field)
{
  return (-0.5 * vacuum_permittivity * field.nominal_squared) *
         compute_relative_permittivity(dielectric.permittivity, invariants,
                                       field.temperature) *
         invariants.d;
}

template <class Number>
EnergyDerivatives<Number>
compute_energy_derivatives(const ConstantPermittivity& law,
                           const Invariants<Number>& invariants,
                           const Field& field)
{
  const Number energy =
      (-0.5 * vacuum_permittivity * law.relative * field.nominal_squared) *
      invariants.d;
  return {Number(0.), energy, Number(0.), Number(0.), energy};
}

/// Of -f phi(s) d by s = tr sqrt(C) and d, with s_t = 1/(2 s) and, j = sqrt(d),
/// s_l = j/(2 s).
template <class Number>
EnergyDerivatives<Number>
compute_energy_derivatives(const StretchPermittivity& law,
                           const Invariants<Number>& invariants,
                           const Field& field)
{
  using std::sqrt;
  const double factor =
      -0.5 * vacuum_permittivity * field.nominal_squared *
      compute_unstretched_permittivity(law, field.temperature);
  const Number j = sqrt(invariants.d);
  const Number s = sqrt(invariants.t + 2. * j);
  const Number x = s - 2.;
  const Number phi =
      1. + x * (law.linear + x * (law.quadratic + x * law.cubic));
  const Number slope =
      law.linear + x * (2. * law.quadratic + (3. * law.cubic) * x);
  const Number curvature = 2. * law.quadratic + (6. * law.cubic) * x;
  const Number s_t = 0.5 / s;
  const Number s_l = j * s_t;
  const Number s_tt = -(s_t * s_t) / s;
  const Number s_tl = j * s_tt;
  const Number s_ll = 0.5 * s_l + j * s_tl;
  const Number scale = factor * invariants.d;
  const Number tl = curvature * s_t * s_l + slope * (s_tl + s_t);
  const Number ll = phi + slope * (2. * s_l + s_ll) + curvature * s_l * s_l;
  return {scale * slope * s_t, scale * (phi + slope * s_l),
          scale * (curvature * s_t * s_t + slope * s_tt), scale * tl,
          scale * ll};
}

/// Derivatives of the energy by t and ln d in Pa.
template <class Number>
EnergyDerivatives<Number>
compute_energy_derivatives(const Dielectric& dielectric,
                           const Invariants<Number>& invariants,
                           const Field& field)
{
  return std::visit(
      [&](const auto& law)
      { return compute_energy_derivatives(law, invariants, field); },
      dielectric.permittivity);
}
} // namespace taut::material
