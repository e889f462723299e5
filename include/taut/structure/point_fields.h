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
  /// Smaller principal true stress (Pa) that the film would have without
  /// wrinkles; they begin where it is zero.
  double smaller_stress;
  /// Larger principal true stress (Pa), with wrinkles if the film has them. A
  /// film that is slack has none: then minus its modulus times the smaller
  /// principal value of C^-1 E, so that this also falls through zero.
  double larger_stress;
  double true_field; ///< |V| J/H (V/m), J that of the wrinkled film
};
std::vector<CriticalValues> compute_critical_values(Structure& structure,
                                                    const LoadState& loads,
                                                    const double* u,
                                                    const double* internal);

/// How far a film is from breaking down.
struct BreakdownValues
{
  double margin;   ///< 1 - true field/strength; 1 where there is no field
  double strength; ///< (V/m); infinity where there is no field
};
/// Errors: StepRejected, with the place, outside the range of a law.
std::vector<BreakdownValues> compute_breakdown_values(Structure& structure,
                                                      const LoadState& loads,
                                                      const double* u,
                                                      const double* internal);

/// How the film carries at a point. Without tension field it counts which
/// principal stresses are not positive.
enum class Tension : unsigned int
{
  taut = 0,
  wrinkled = 1, ///< across the tension, in one direction
  slack = 2     ///< in both directions
};

/// A direction in the deformed film, a unit vector.
using Direction = std::array<double, 3>;

struct PointFields
{
  /// Principal stretches, the larger first, and where they point in space; of
  /// the surface without its wrinkles.
  std::array<double, 2> stretches;
  std::array<Direction, 2> stretch_directions;
  /// Principal true stresses (Pa), likewise; as everything that follows of the
  /// wrinkled film.
  std::array<double, 2> stresses;
  std::array<Direction, 2> stress_directions;
  double true_field; ///< |V| J/H (V/m)
  /// 1 - true field/strength; NaN outside the range of the strength's law.
  double breakdown_margin;
  double thickness; ///< current, H/J (m)
  Tension tension;
  /// By how much the film is wider than the place it has, relative to that,
  /// where it is shortened most; 0 without tension field.
  double wrinkle_strain;
  /// Across the wrinkles; zero if there are none.
  Direction wrinkle_direction;
  /// By network: principal internal stretches, the larger first, square roots
  /// of the eigenvalues of A^{-1}.
  std::vector<std::array<double, 2>> internal_stretches;
};
std::vector<PointFields> compute_point_fields(Structure& structure,
                                              const LoadState& loads,
                                              const double* u,
                                              const double* internal);
} // namespace taut::structure
