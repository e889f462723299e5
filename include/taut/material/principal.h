#pragma once

#include <taut/material/dielectric.h>

#include <array>

namespace taut::material
{
/// Two principal values, the larger one first, each with the unit vector of
/// its direction in the material axes of the undeformed film.
struct Principal
{
  std::array<double, 2> values;
  std::array<std::array<double, 2>, 2> directions;
};

/// Principal stretches, the square roots of the eigenvalues of C.
Principal compute_principal_stretches(const SymmetricTensor2<double>& C);

/// Principal true (Cauchy) stresses in Pa, the eigenvalues of S C. A direction
/// is that of the material line which the deformation turns into the direction
/// of the stress (an eigenvector of S C): the two are orthogonal only once
/// deformed.
Principal compute_principal_stresses(const SymmetricTensor2<double>& C,
                                     const SymmetricTensor2<double>& S);

/// True field |V| J/H in V/m, J = sqrt(det C); `nominal_field` is V/H in V/m.
double compute_true_field(const SymmetricTensor2<double>& C,
                          double nominal_field);

/// What a film with metric C is exposed to.
struct Exposure
{
  double nominal_field; ///< V/H (V/m)
  double field_rate;    ///< |d(V/H)/dt| (V/(m s))
  double thickness;     ///< undeformed, H (m)
  double temperature;   ///< (K)
  double humidity;      ///< relative, 0 to 1
};

/// E_B in V/m at a point. Errors: StepRejected, see breakdown_law.h.
double compute_strength(const Dielectric& dielectric,
                        const SymmetricTensor2<double>& C,
                        const Exposure& exposure);

/// 1 - true field/breakdown strength: 1 without voltage or strength, 0 at
/// breakdown. Errors: StepRejected, see breakdown_law.h; none without voltage.
double compute_breakdown_margin(const Dielectric& dielectric,
                                const SymmetricTensor2<double>& C,
                                const Exposure& exposure);
} // namespace taut::material
