#pragma once

#include <taut/material/elastomer.h>

#include <memory>

/// The arithmetic of the film on a batch of eight cells at once. Every array
/// holds eight lanes per number, [...][lane], aligned to 64 bytes, so that this
/// interface does not depend on the width of the processor's registers.
///
/// Notation: a, b nodes of the cell, q quadrature points, m networks;
/// gradients G_a = P^T grad N_a in the material axes, P the pre-stretch, so
/// that F = sum_a x_a (x) G_a (3x2), C = F^T F.
namespace taut::fe
{
/// What a batch is made of.
struct BatchGeometry
{
  /// 4 (Q1) or 9 (Q2), with as many quadrature points.
  unsigned int n_nodes;
  /// G_a, [q][a][2] (1/m).
  const double* gradients;
  /// Undeformed film volume of the points, [q] (m^3); 0 in unused lanes.
  const double* volumes;
};

/// What a batch is made from.
struct BatchLaw
{
  const material::Elastomer* elastomer;
  material::Field field;
  /// What wrinkles cost (Pa, see taut/material/tension_field.h): all that
  /// depends on C = F^T F does so through the metric C* of the wrinkled film.
  /// 0: the film carries compression.
  double wrinkle_stiffness = 0;
  /// Holds *elastomer if it was made for this law, else null.
  std::shared_ptr<const material::Elastomer> owned = nullptr;
};

/// Where a law was taken beyond its limit.
struct LimitCheck
{
  /// Smallest margin of all points; not positive (or NaN): inadmissible.
  double margin;
  unsigned int point;
  /// Of the cell whose wrinkles grow without end; else nothing.
  unsigned int lane;
  /// Inadmissible because wrinkles grow without end, not by a law's limit.
  bool wrinkles_grow;
};

/// Sums over the points of each cell, [lane].
struct BatchPower
{
  /// Dissipated in the networks (W).
  alignas(64) double dissipation[8];
  /// Integral of eps det C dV0 (F m^2): times V/H^2 it is the charge.
  alignas(64) double permittivity[8];
};

/// Internal forces [a][3] (N), rates of the internal variables [q][m][3] (1/s)
/// and powers at positions x [a][3] (m) and internal variables A [q][m][3].
LimitCheck compute_forces(const BatchGeometry& geometry, const BatchLaw& law,
                          const double* positions, const double* internal,
                          double* forces, double* rates, BatchPower& power);

/// BatchPower::permittivity alone, [lane].
LimitCheck compute_permittivity(const BatchGeometry& geometry,
                                const BatchLaw& law, const double* positions,
                                const double* internal, double* permittivity);

/// Stiffness d forces / d x, [a][3][b][3] (N/m), with the networks condensed
/// at `alpha` (1/s; infinity: frozen), plus mass_factor * density * N_a N_b on
/// the diagonal of each block (mass_factor in 1/s^2; shape_values [q][a] one
/// number each, the same for all lanes). If `symmetric`, its symmetric part,
/// and only the blocks b <= a are written.
void compute_stiffness(const BatchGeometry& geometry, const BatchLaw& law,
                       const double* shape_values, double mass_factor,
                       const double* positions, const double* internal,
                       double alpha, bool symmetric, double* stiffness);

/// density * integral N_a N_b dV0 on the diagonal of each block,
/// [a][3][b][3] (kg, if density is in kg/m^3), blocks b <= a.
void compute_mass(const BatchGeometry& geometry, const double* shape_values,
                  double density, double* mass);

/// Change of the internal forces [a][3] when the internal variables change by
/// (alpha - dA'/dA)^{-1} r at fixed positions.
void compute_force_change(const BatchGeometry& geometry, const BatchLaw& law,
                          const double* positions, const double* internal,
                          double alpha, const double* r, double* forces);

/// dA = (alpha - dA'/dA)^{-1} (r + dA'/dx dx), [q][m][3].
void compute_internal_change(const BatchGeometry& geometry, const BatchLaw& law,
                             const double* positions, const double* internal,
                             double alpha, const double* dx, const double* r,
                             double* change);

/// Energy at prescribed voltage (Legendre transformed) and its part stored in
/// springs and networks, per lane (J).
struct BatchEnergy
{
  alignas(64) double at_voltage[8];
  alignas(64) double stored[8];
};
void compute_energy(const BatchGeometry& geometry, const BatchLaw& law,
                    const double* positions, const double* internal,
                    BatchEnergy& energy);

/// Right Cauchy-Green tensor C at the points, [q][3] as (xx, yy, xy).
void compute_metric(const BatchGeometry& geometry, const double* positions,
                    double* metric);

/// The metric C* of the wrinkled film, likewise; C where it is taut.
void compute_wrinkled_metric(const BatchGeometry& geometry, const BatchLaw& law,
                             const double* positions, const double* internal,
                             double* metric);

/// Forces [a][3] (N) of a pressure (Pa) that follows the current surface, and
/// their derivative with respect to x, [a][3][b][3] (N/m), not symmetrised.
/// shape_values [q][a], shape_gradients [q][a][2] and weights [q] of the
/// reference element, one number each; active[lane] is 1 or 0.
void compute_pressure_forces(unsigned int n_nodes, const double* shape_values,
                             const double* shape_gradients,
                             const double* weights, const double* active,
                             const double* positions, double pressure,
                             double* forces);
void add_pressure_stiffness(unsigned int n_nodes, const double* shape_values,
                            const double* shape_gradients,
                            const double* weights, const double* active,
                            const double* positions, double pressure,
                            bool symmetric, double* stiffness);
} // namespace taut::fe
