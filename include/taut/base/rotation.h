#pragma once

#include <array>

// Rotations as quaternions, scalar part first. A quaternion of any length > 0
// stands for the rotation of its direction.
namespace taut
{
using Quaternion = std::array<double, 4>;
using Vector3 = std::array<double, 3>;

/// a b.
Quaternion multiply(const Quaternion& a, const Quaternion& b);
/// The quaternion of the inverse rotation, of the same length.
Quaternion conjugate(const Quaternion& q);
double length(const Quaternion& q);
/// R(q/|q|) v.
Vector3 rotate(const Quaternion& q, const Vector3& v);
/// R(q/|q|)^T v.
Vector3 rotate_back(const Quaternion& q, const Vector3& v);
/// The unit quaternion of a rotation vector (rad); exact series near 0.
Quaternion make_rotation(const Vector3& rotation_vector);
/// The angle (rad) about `axis` (a unit vector) of a rotation whose vector lies
/// along it, between -2 pi and 2 pi: continuous over a full turn, because the
/// sign of q counts.
double compute_angle(const Quaternion& q, const Vector3& axis);
/// Angular velocity in the section's axes, 2 vec(conj(q) q')/|q|^2 (rad/s).
Vector3 compute_angular_velocity(const Quaternion& q, const Quaternion& q_rate);
} // namespace taut
