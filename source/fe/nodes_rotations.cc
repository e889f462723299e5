#include <taut/fe/nodes.h>
#include <taut/fe/vector3.h>

namespace taut::fe
{
namespace
{
using Vector3 = std::array<double, 3>;
using Form = std::array<double, 16>;

/// The symmetric form N with force . R(Q) arm = Q . N Q/|Q|^2.
Form make_form(const Vector3& force, const Vector3& arm)
{
  const double along = dot(force, arm);
  const Vector3 moment = cross(arm, force);
  Form form;
  form[0] = along;
  for (unsigned int i = 0; i < 3; ++i)
  {
    form[1 + i] = form[4 * (1 + i)] = moment[i];
    for (unsigned int j = 0; j < 3; ++j)
      form[4 * (1 + i) + 1 + j] =
          force[i] * arm[j] + arm[i] * force[j] - (i == j) * along;
  }
  return form;
}

Quaternion multiply(const Form& form, const Quaternion& q)
{
  Quaternion product{};
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      product[i] += form[4 * i + j] * q[j];
  return product;
}

double dot(const Quaternion& a, const Quaternion& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}
} // namespace

Quaternion get_quaternion(const Rotation& rotation, const NodalVector& values)
{
  return {entry(values, 3 * rotation.scalar()),
          entry(values, 3 * rotation.vector),
          entry(values, 3 * rotation.vector + 1),
          entry(values, 3 * rotation.vector + 2)};
}

ArmDerivative compute_arm_derivative(const Quaternion& q, const Vector3& arm)
{
  const double square = dot(q, q);
  ArmDerivative derivative;
  for (unsigned int i = 0; i < 3; ++i)
  {
    Vector3 unit{};
    unit[i] = 1;
    const Quaternion product = multiply(make_form(unit, arm), q);
    const double value = dot(q, product) / square;
    derivative.by_scalar[i] = 2 * (product[0] - value * q[0]) / square;
    for (unsigned int j = 0; j < 3; ++j)
      derivative.by_vector[3 * i + j] =
          2 * (product[1 + j] - value * q[1 + j]) / square;
  }
  return derivative;
}

std::array<double, 16> compute_arm_curvature(const Quaternion& q,
                                             const Vector3& arm,
                                             const Vector3& force)
{
  const Form form = make_form(force, arm);
  const double square = dot(q, q);
  const Quaternion product = multiply(form, q);
  const double value = dot(q, product) / square;
  Form curvature;
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      curvature[4 * i + j] =
          2 / square *
          (form[4 * i + j] - (i == j) * value -
           2 * (product[i] * q[j] + q[i] * product[j]) / square +
           4 * value * q[i] * q[j] / square);
  return curvature;
}
} // namespace taut::fe
