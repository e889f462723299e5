#include <taut/material/principal.h>

#include <cmath>

namespace taut::material
{
namespace
{
Principal compute_eigensystem(const SymmetricTensor2<double>& a)
{
  const double mean = (a.xx + a.yy) / 2.;
  const double half_difference = (a.xx - a.yy) / 2.;
  const double radius = std::hypot(half_difference, a.xy);
  const double angle = std::atan2(a.xy, half_difference) / 2.;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {{mean + radius, mean - radius}, {{{c, s}, {-s, c}}}};
}

/// U = (C + J)/tr U, from the theorem of Cayley and Hamilton.
SymmetricTensor2<double>
compute_right_stretch(const SymmetricTensor2<double>& C)
{
  const Invariants<double> invariants = compute_invariants(C);
  return combine(1. / compute_stretch_sum(invariants), C,
                 std::sqrt(invariants.d) / compute_stretch_sum(invariants),
                 make_identity<double>());
}

std::array<double, 2> apply_and_normalise(const SymmetricTensor2<double>& a,
                                          const std::array<double, 2>& v)
{
  const double x = a.xx * v[0] + a.xy * v[1];
  const double y = a.xy * v[0] + a.yy * v[1];
  const double length = std::hypot(x, y);
  return {x / length, y / length};
}
} // namespace

Principal compute_principal_stretches(const SymmetricTensor2<double>& C)
{
  Principal result = compute_eigensystem(C);
  for (double& value : result.values)
    value = std::sqrt(value);
  return result;
}

Principal compute_principal_stresses(const SymmetricTensor2<double>& C,
                                     const SymmetricTensor2<double>& S)
{
  // U S U is symmetric and similar to S C; U^-1 carries its eigenvectors over.
  const SymmetricTensor2<double> U = compute_right_stretch(C);
  Principal result = compute_eigensystem(sandwich(U, S));
  const SymmetricTensor2<double> inverse_U = compute_inverse(U);
  for (std::array<double, 2>& direction : result.directions)
    direction = apply_and_normalise(inverse_U, direction);
  return result;
}

double compute_true_field(const SymmetricTensor2<double>& C,
                          double nominal_field)
{
  return std::abs(nominal_field) * std::sqrt(compute_determinant(C));
}

double compute_strength(const Dielectric& dielectric,
                        const SymmetricTensor2<double>& C,
                        const Exposure& exposure)
{
  const double area_stretch = std::sqrt(compute_determinant(C));
  return compute_strength(dielectric.breakdown,
                          {area_stretch, exposure.thickness / area_stretch,
                           exposure.temperature, exposure.field_rate,
                           exposure.humidity});
}

double compute_breakdown_margin(const Dielectric& dielectric,
                                const SymmetricTensor2<double>& C,
                                const Exposure& exposure)
{
  if (exposure.nominal_field == 0.)
    return 1.;
  return 1. - compute_true_field(C, exposure.nominal_field) /
                  compute_strength(dielectric, C, exposure);
}
} // namespace taut::material
