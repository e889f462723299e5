#include <taut/fe/vector3.h>
#include <taut/structure/rotary_inertia.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

namespace taut::structure
{
namespace
{
/// Rate (1/s) at which a wrong length of a quaternion is forgotten. Nothing
/// hurries it, and a stiff length would couple to the turning between two
/// linearisations: Newton's method slows down where the turn (rad) in a step h
/// times length_rate h is not small.
constexpr double length_rate = 1;

double dot(const Quaternion& a, const Quaternion& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// The columns Q i, Q j, Q k.
std::array<Quaternion, 3> make_columns(const Quaternion& q)
{
  return {{{-q[1], q[0], q[3], -q[2]},
           {-q[2], -q[3], q[0], q[1]},
           {-q[3], q[2], -q[1], q[0]}}};
}

Vector3 multiply(const Tensor3& a, const Vector3& b)
{
  Vector3 product{};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      product[i] += a[3 * i + j] * b[j];
  return product;
}

Vector3 solve(const Tensor3& a, const Vector3& b)
{
  dealii::Tensor<2, 3> matrix;
  dealii::Tensor<1, 3> right;
  for (unsigned int i = 0; i < 3; ++i)
  {
    right[i] = b[i];
    for (unsigned int j = 0; j < 3; ++j)
      matrix[i][j] = a[3 * i + j];
  }
  const dealii::Tensor<1, 3> x = dealii::invert(matrix) * right;
  return {x[0], x[1], x[2]};
}

Quaternion multiply(const Matrix4& a, const Quaternion& b)
{
  Quaternion product{};
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      product[i] += a[4 * i + j] * b[j];
  return product;
}

void add_outer(const double factor, const Quaternion& a, const Quaternion& b,
               Matrix4& matrix)
{
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      matrix[4 * i + j] += factor * a[i] * b[j];
}
} // namespace

Matrix4 compute_tangential(const Tensor3& tensor, const Quaternion& q)
{
  const auto columns = make_columns(q);
  const double square = dot(q, q);
  Matrix4 result{};
  for (unsigned int k = 0; k < 3; ++k)
    for (unsigned int l = 0; l < 3; ++l)
      add_outer(4 * tensor[3 * k + l] / (square * square), columns[k],
                columns[l], result);
  return result;
}

Matrix4 compute_mass(const RotaryInertia& inertia, const Quaternion& q)
{
  Matrix4 mass = compute_tangential(inertia.inertia, q);
  add_outer(inertia.mean() / dot(q, q), q, q, mass);
  return mass;
}

Matrix4 compute_mass_tangent(const RotaryInertia& inertia, const Quaternion& q,
                             const double alpha)
{
  Matrix4 tangent = compute_mass(inertia, q);
  for (double& entry : tangent)
    entry *= alpha * alpha;
  const Matrix4 damping = compute_tangential(inertia.damping, q);
  for (unsigned int i = 0; i < 16; ++i)
    tangent[i] += alpha * damping[i];
  add_outer((2 * length_rate * alpha + length_rate * length_rate) *
                inertia.mean() / dot(q, q),
            q, q, tangent);
  return tangent;
}

Quaternion compute_free_acceleration(const RotaryInertia& inertia,
                                     const Quaternion& q,
                                     const Quaternion& q_rate)
{
  const double square = dot(q, q);
  const double growth = dot(q, q_rate) / square;
  const Vector3 omega = compute_angular_velocity(q, q_rate);
  const Vector3 spin = fe::cross(omega, multiply(inertia.inertia, omega));
  Vector3 change = solve(inertia.inertia, spin);
  for (double& component : change)
    component *= -1;
  const double relative = square / (inertia.length * inertia.length);
  const double growth_rate =
      -2 * length_rate * growth -
      0.5 * length_rate * length_rate * (relative - 1) / relative -
      2 * growth * growth;
  // Q' = Q Omega/2 + growth Q, differentiated once more.
  const Quaternion turning =
      taut::multiply(q_rate, {0, omega[0], omega[1], omega[2]});
  const Quaternion turning_faster =
      taut::multiply(q, {0, change[0], change[1], change[2]});
  Quaternion result;
  for (unsigned int i = 0; i < 4; ++i)
    result[i] = 0.5 * (turning[i] + turning_faster[i]) + growth_rate * q[i] +
                growth * q_rate[i];
  return result;
}

Quaternion compute_acceleration(const RotaryInertia& inertia,
                                const std::array<bool, 4>& free,
                                const Quaternion& q, const Quaternion& q_rate,
                                const Quaternion& force)
{
  const Matrix4 mass = compute_mass(inertia, q);
  const Quaternion inertial =
      multiply(mass, compute_free_acceleration(inertia, q, q_rate));
  // Held components keep a row of the identity and no force.
  dealii::FullMatrix<double> matrix(dealii::IdentityMatrix(4));
  dealii::Vector<double> right(4), x(4);
  for (unsigned int i = 0; i < 4; ++i)
  {
    if (!free[i])
      continue;
    right[i] = force[i] + inertial[i];
    for (unsigned int j = 0; j < 4; ++j)
      if (free[j])
        matrix(i, j) = mass[4 * i + j];
  }
  matrix.gauss_jordan();
  matrix.vmult(x, right);
  return {x[0], x[1], x[2], x[3]};
}

Quaternion multiply_free(const Matrix4& matrix, const std::array<bool, 4>& free,
                         const Quaternion& x)
{
  Quaternion result{};
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      if (free[i] && free[j])
        result[i] += matrix[4 * i + j] * x[j];
  return result;
}

double compute_kinetic_energy(const RotaryInertia& inertia, const Quaternion& q,
                              const Quaternion& q_rate)
{
  const Vector3 omega = compute_angular_velocity(q, q_rate);
  return 0.5 * fe::dot(omega, multiply(inertia.inertia, omega));
}
} // namespace taut::structure
