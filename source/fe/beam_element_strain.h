#pragma once

#include <taut/base/rotation.h>

#include <array>

// Strains of a beam at a point as functions of the 11 numbers (x', q, q').
namespace taut::fe
{
/// x' and q' are derivatives by the arc length of the reference state (1/m).
struct BeamPointState
{
  Vector3 slope;    ///< x'
  Quaternion q;     ///< q, of any length
  Quaternion twist; ///< q'
};

/// A combination of strains, in the axes of the reference state:
///   n . (R(q/|q|)^T x') + m . 2 vec(conj(q) q')/|q|^2.
/// With unit vectors it is one strain, with stress resultants the strain power.
struct StrainCombination
{
  Vector3 n, m;
};

using BeamGradient = std::array<double, 11>;
using BeamHessian = std::array<BeamGradient, 11>;

double compute_value(const StrainCombination& combination,
                     const BeamPointState& state);
/// Its derivatives by (x', q, q').
BeamGradient compute_gradient(const StrainCombination& combination,
                              const BeamPointState& state);
/// Its second derivatives by (x', q, q').
BeamHessian compute_hessian(const StrainCombination& combination,
                            const BeamPointState& state);
} // namespace taut::fe
