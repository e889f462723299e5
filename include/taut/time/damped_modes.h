#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace taut::time
{
/// A few coordinates q with the mass 1 that vibrate and lose energy:
///   q'' + D q' + K q - sum over r of K_r y_r = 0,  y_r' = (q - y_r)/T_r,
/// so that q = exp(s t) meets s^2 + s D + K - sum of K_r/(1 + s T_r): K is the
/// stiffness of fast motions, K - sum of K_r that of slow ones. Matrices are
/// symmetric, row-major.
struct DampedVibration
{
  struct Part
  {
    std::vector<double> stiffness; ///< K_r (1/s^2)
    double time;                   ///< T_r (s)
  };
  std::size_t size = 0;
  std::vector<double> stiffness; ///< K (1/s^2)
  std::vector<double> damping;   ///< D (1/s)
  std::vector<Part> parts;
};

/// The s (1/s) of the damped motion that resembles the vector `shape` most: of
/// those that swing, the one with the largest |q . shape|/|q|; where one that
/// only creeps is more alike, the one of these that grows fastest or fades
/// last. The imaginary part is not negative. Dense (SLEPc, LAPACK); on one
/// rank. Errors: SolverFailed.
std::complex<double> find_damped_rate(const DampedVibration& vibration,
                                      const std::vector<double>& shape);
} // namespace taut::time
