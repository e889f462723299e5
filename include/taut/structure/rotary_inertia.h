#pragma once

#include <taut/base/rotation.h>

#include <array>

// The motion of a quaternion Q of any length with a constant inertia J in the
// body. With L = (Q i, Q j, Q k) the angular velocity in the body is
// Omega = 2 L^T Q'/|Q|^2 and the kinetic energy (1/2) Q' . M Q' with
//   M = 4 L J L^T/|Q|^4 + m_r Q Q^T/|Q|^2,
// where m_r gives the length of Q, which has no meaning, an inertia of its own.
// The length is held by an oscillator with critical damping that no force acts
// on, so that it takes no part in any balance.
namespace taut::structure
{
using Matrix4 = std::array<double, 16>; ///< row-major, (scalar, vector)
using Tensor3 = std::array<double, 9>;  ///< row-major

struct RotaryInertia
{
  Tensor3 inertia{}; ///< J about x, y, z of the mesh (kg m^2)
  Tensor3 damping{}; ///< resists the angular velocity (kg m^2/s)
  double length = 1; ///< of the stored quaternion (m)

  /// m_r (kg): that of a body with the mean of J in all directions, for which
  /// M is m_r times the identity.
  double mean() const
  {
    return 4 * (inertia[0] + inertia[4] + inertia[8]) / (3 * length * length);
  }
};

/// 4 L T L^T/|Q|^4 (kg, for T in kg m^2).
Matrix4 compute_tangential(const Tensor3& tensor, const Quaternion& q);
/// M.
Matrix4 compute_mass(const RotaryInertia& inertia, const Quaternion& q);
/// alpha^2 M and what the oscillator of the length adds (kg/s^2).
Matrix4 compute_mass_tangent(const RotaryInertia& inertia, const Quaternion& q,
                             double alpha);
/// Q'' without forces: Omega' = - J^{-1} (Omega x J Omega) and the length's
/// oscillator (m/s^2).
Quaternion compute_free_acceleration(const RotaryInertia& inertia,
                                     const Quaternion& q,
                                     const Quaternion& q_rate);
/// Q'' under the force f, conjugate to Q (N), where only the components `free`
/// may change: M_ff Q_f'' = f_f + (M Q''_free)_f; zero on the others.
Quaternion compute_acceleration(const RotaryInertia& inertia,
                                const std::array<bool, 4>& free,
                                const Quaternion& q, const Quaternion& q_rate,
                                const Quaternion& force);
/// M x, of the free components.
Quaternion multiply_free(const Matrix4& matrix, const std::array<bool, 4>& free,
                         const Quaternion& x);
/// (1/2) Omega . J Omega (J).
double compute_kinetic_energy(const RotaryInertia& inertia, const Quaternion& q,
                              const Quaternion& q_rate);
} // namespace taut::structure
