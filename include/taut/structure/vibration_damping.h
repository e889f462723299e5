#pragma once

#include <taut/structure/vibration.h>

#include <complex>
#include <vector>

namespace taut::structure
{
/// How a mode fades.
struct DampedMode
{
  /// s of the motion exp(s t) (1/s): minus the rate at which it fades, and its
  /// angular frequency, 0 if it creeps back.
  std::complex<double> rate;
  /// By relaxation: angular frequency of the undamped mode times relaxation
  /// time; 0 of unstable modes.
  std::vector<double> products;

  /// - Re s/|s|: 1 if it creeps, negative if it grows.
  double ratio() const
  {
    return std::abs(rate) > 0 ? -rate.real() / std::abs(rate) : 0.;
  }
};

/// The complex modes
///   (s^2 M + s D + K_frozen - sum over r of K_r/(1 + s T_r)) phi = 0
/// next to `modes`, on the space that they and `others` span: Galerkin's
/// method, whose error is of the square of what the space lacks of phi.
///
/// About a relaxed state (`at_rest`) this K(s) is exact for networks that flow
/// in all directions: at fixed strain their evolution is there
/// d(A - C^{-1})/dt = -(A - C^{-1})/T, whatever the spring. Networks of a held
/// width relax at another rate, which is measured at each mode. About a state
/// that still relaxes, K_r is what the relaxation takes from the stiffness of a
/// motion exp(omega t), times 1 + omega T_r: right where omega T_r is large.
/// Leaves the tangent frozen. Collective. Errors as Vibration and
/// time::find_damped_rate.
std::vector<DampedMode> compute_damped_modes(
    Vibration& vibration, const std::vector<time::VibrationMode>& modes,
    const std::vector<time::VibrationMode>& others, bool at_rest = true);
} // namespace taut::structure
