#include <taut/base/rotation.h>

#include <cmath>

#include <boost/math/special_functions/sinc.hpp>

namespace taut
{
namespace
{
double dot(const Quaternion& a, const Quaternion& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// The vector part of q v conj(q)/|q|^2.
Vector3 sandwich(const Quaternion& q, const Vector3& v)
{
  const Quaternion turned =
      multiply(multiply(q, {0., v[0], v[1], v[2]}), conjugate(q));
  const double scale = 1 / dot(q, q);
  return {scale * turned[1], scale * turned[2], scale * turned[3]};
}
} // namespace

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}

Quaternion conjugate(const Quaternion& q)
{
  return {q[0], -q[1], -q[2], -q[3]};
}

double length(const Quaternion& q)
{
  return std::sqrt(dot(q, q));
}

Vector3 rotate(const Quaternion& q, const Vector3& v)
{
  return sandwich(q, v);
}

Vector3 rotate_back(const Quaternion& q, const Vector3& v)
{
  return sandwich(conjugate(q), v);
}

Quaternion make_rotation(const Vector3& rotation_vector)
{
  const auto& [x, y, z] = rotation_vector;
  const double half = 0.5 * std::sqrt(x * x + y * y + z * z);
  const double scale = 0.5 * boost::math::sinc_pi(half);
  return {std::cos(half), scale * x, scale * y, scale * z};
}

double compute_angle(const Quaternion& q, const Vector3& axis)
{
  return 2 * std::atan2(q[1] * axis[0] + q[2] * axis[1] + q[3] * axis[2], q[0]);
}

Vector3 compute_angular_velocity(const Quaternion& q, const Quaternion& q_rate)
{
  const Quaternion product = multiply(conjugate(q), q_rate);
  const double scale = 2 / dot(q, q);
  return {scale * product[1], scale * product[2], scale * product[3]};
}
} // namespace taut
