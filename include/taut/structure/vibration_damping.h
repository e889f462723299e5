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
///   (s^2 M + s D + K_relaxed + sum of s T_r/(1 + s T_r) (K_r - K_relaxed)) phi
/// next to given ones, on the space that all `frozen` and `relaxed` modes span.
/// About a relaxed state this K(s) is exact for networks that flow in all
/// directions: there their evolution is d(A - C^{-1})/dt = -(A - C^{-1})/T at
/// fixed strain, whatever the spring. Networks of a held width relax at another
/// rate, which is measured at each mode. About a state that still relaxes, its
/// drift is left out. Collective. Errors as Vibration and
/// time::find_damped_rate.
std::vector<DampedMode>
compute_damped_modes(Vibration& vibration,
                     const std::vector<time::VibrationMode>& frozen,
                     const std::vector<time::VibrationMode>& relaxed);
} // namespace taut::structure
