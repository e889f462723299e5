#pragma once

#include <taut/structure/structure.h>

#include <array>
#include <vector>

/// What a film shows at its quadrature points. All functions give one entry per
/// point of this rank's cells, [cell][q] as in FilmCells, at the displacements
/// `u` and internal variables of a state; where a network is relaxed its
/// internal variable is C^{-1}. They are collective, because positions are
/// shared, and leave the positions in `structure` at `u`.
namespace taut::structure
{
/// What may end the use of a film, for watches that look at every step.
struct CriticalValues
{
  double smaller_stress; ///< smaller principal true stress (Pa)
  double true_field;     ///< |V| J/H (V/m)
};
std::vector<CriticalValues> compute_critical_values(Structure& structure,
                                                    const LoadState& loads,
                                                    const double* u,
                                                    const double* internal);

/// How the film carries at a point.
enum class Tension : unsigned int
{
  taut = 0,
  wrinkled = 1, ///< the smaller principal stress is not positive
  slack = 2     ///< neither is
};

/// A direction in the deformed film, a unit vector.
using Direction = std::array<double, 3>;

struct PointFields
{
  /// Principal stretches, the larger first, and where they point in space.
  std::array<double, 2> stretches;
  std::array<Direction, 2> stretch_directions;
  /// Principal true stresses (Pa), likewise.
  std::array<double, 2> stresses;
  std::array<Direction, 2> stress_directions;
  double true_field;       ///< |V| J/H (V/m)
  double breakdown_margin; ///< 1 - true field/strength
  double thickness;        ///< current, H/J (m)
  Tension tension;
  /// By network: principal internal stretches, the larger first, square roots
  /// of the eigenvalues of A^{-1}.
  std::vector<std::array<double, 2>> internal_stretches;
};
std::vector<PointFields> compute_point_fields(Structure& structure,
                                              const LoadState& loads,
                                              const double* u,
                                              const double* internal);
} // namespace taut::structure
