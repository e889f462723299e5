#include <taut/structure/rotary_inertia.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

// The motion of a quaternion against the mechanics of a rigid body.
namespace taut::structure
{
namespace
{
/// A body with a full inertia tensor, turned and turning at random.
class RotaryInertiaTest : public ::testing::Test
{
protected:
  RotaryInertiaTest() : generator_(7)
  {
    inertia_.inertia = {{3, .2, -.3, .2, 2, .1, -.3, .1, 1.5}};
    inertia_.damping = {{.5, .1, 0, .1, .4, 0, 0, 0, .3}};
    inertia_.length = 1.7;
    q_ = draw();
    const double factor = inertia_.length / taut::length(q_);
    for (double& component : q_)
      component *= factor;
    rate_ = draw();
    // Across q: the length stays.
    const double along = dot(q_, rate_) / dot(q_, q_);
    for (unsigned int i = 0; i < 4; ++i)
      rate_[i] -= along * q_[i];
  }

  Quaternion draw()
  {
    std::uniform_real_distribution<double> uniform(-1, 1);
    return {uniform(generator_), uniform(generator_), uniform(generator_),
            uniform(generator_)};
  }
  static double dot(const Quaternion& a, const Quaternion& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  }
  static Quaternion multiply(const Matrix4& a, const Quaternion& b)
  {
    return multiply_free(a, {{true, true, true, true}}, b);
  }
  static Vector3 multiply(const Tensor3& a, const Vector3& b)
  {
    Vector3 product{};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        product[i] += a[3 * i + j] * b[j];
    return product;
  }
  /// In space.
  Vector3 compute_momentum(const Quaternion& q, const Quaternion& rate) const
  {
    return rotate(
        q, multiply(inertia_.inertia, compute_angular_velocity(q, rate)));
  }
  /// q + h rate + h^2/2 acceleration and its rate.
  static std::array<Quaternion, 2> move(const Quaternion& q,
                                        const Quaternion& rate,
                                        const Quaternion& acceleration,
                                        const double h)
  {
    std::array<Quaternion, 2> moved;
    for (unsigned int i = 0; i < 4; ++i)
    {
      moved[0][i] = q[i] + h * rate[i] + h * h / 2 * acceleration[i];
      moved[1][i] = rate[i] + h * acceleration[i];
    }
    return moved;
  }
  /// Central difference of the momentum in space.
  Vector3 compute_momentum_rate(const Quaternion& acceleration) const
  {
    constexpr double h = 1e-6;
    const auto later = move(q_, rate_, acceleration, h);
    const auto earlier = move(q_, rate_, acceleration, -h);
    const Vector3 a = compute_momentum(later[0], later[1]);
    const Vector3 b = compute_momentum(earlier[0], earlier[1]);
    return {(a[0] - b[0]) / (2 * h), (a[1] - b[1]) / (2 * h),
            (a[2] - b[2]) / (2 * h)};
  }

  std::mt19937 generator_;
  RotaryInertia inertia_;
  Quaternion q_, rate_;
};

TEST_F(RotaryInertiaTest, MassGivesTheKineticEnergy)
{
  EXPECT_NEAR(.5 * dot(rate_, multiply(compute_mass(inertia_, q_), rate_)),
              compute_kinetic_energy(inertia_, q_, rate_), 1e-14);
}

TEST_F(RotaryInertiaTest, LengthHasTheMeanInertiaAndNoPartInTheRotation)
{
  const Quaternion product = multiply(compute_mass(inertia_, q_), q_);
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(product[i], inertia_.mean() * q_[i], 1e-14);
  auto growing = rate_;
  for (unsigned int i = 0; i < 4; ++i)
    growing[i] += .8 * q_[i];
  EXPECT_NEAR(compute_kinetic_energy(inertia_, q_, growing),
              compute_kinetic_energy(inertia_, q_, rate_), 1e-14);
}

TEST_F(RotaryInertiaTest, MassOfEqualInertiasIsAMultipleOfTheIdentity)
{
  RotaryInertia sphere;
  sphere.inertia = {{2, 0, 0, 0, 2, 0, 0, 0, 2}};
  sphere.length = inertia_.length;
  const auto mass = compute_mass(sphere, q_);
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      EXPECT_NEAR(mass[4 * i + j], i == j ? sphere.mean() : 0., 1e-13);
}

TEST_F(RotaryInertiaTest, DampingTakesItsPower)
{
  const Vector3 omega = compute_angular_velocity(q_, rate_);
  const Vector3 torque = multiply(inertia_.damping, omega);
  EXPECT_NEAR(
      dot(rate_, multiply(compute_tangential(inertia_.damping, q_), rate_)),
      omega[0] * torque[0] + omega[1] * torque[1] + omega[2] * torque[2],
      1e-14);
}

TEST_F(RotaryInertiaTest, FreeMotionKeepsTheMomentumInSpace)
{
  const auto rate =
      compute_momentum_rate(compute_free_acceleration(inertia_, q_, rate_));
  for (const double component : rate)
    EXPECT_NEAR(component, 0, 1e-8);
}

TEST_F(RotaryInertiaTest, TorqueChangesTheMomentumInSpace)
{
  // A torque m in space does the work m . omega: its force is 2 m Q/|Q|^2.
  const Vector3 torque{.7, -.4, .9};
  auto force = taut::multiply({0, torque[0], torque[1], torque[2]}, q_);
  for (double& component : force)
    component *= 2 / dot(q_, q_);
  const auto rate = compute_momentum_rate(compute_acceleration(
      inertia_, {{true, true, true, true}}, q_, rate_, force));
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(rate[i], torque[i], 1e-8);
}

TEST_F(RotaryInertiaTest, HeldComponentsLeaveAPendulum)
{
  // Scalar and z part free: a rotation about z with J_zz alone.
  inertia_.inertia = {{3, 0, 0, 0, 2, 0, 0, 0, 1.5}};
  const std::array<bool, 4> free{{true, false, false, true}};
  const double angle = .6, spin = .9, torque = 2.1, l = inertia_.length;
  const Quaternion q{l * std::cos(angle / 2), 0, 0, l * std::sin(angle / 2)};
  const Quaternion rate{-spin / 2 * q[3], 0, 0, spin / 2 * q[0]};
  const Quaternion force{-2 * torque * q[3] / (l * l), 0, 0,
                         2 * torque * q[0] / (l * l)};
  const auto acceleration =
      compute_acceleration(inertia_, free, q, rate, force);
  const double faster = torque / 1.5;
  EXPECT_NEAR(acceleration[0], -faster / 2 * q[3] - spin * spin / 4 * q[0],
              1e-12);
  EXPECT_EQ(acceleration[1], 0);
  EXPECT_EQ(acceleration[2], 0);
  EXPECT_NEAR(acceleration[3], faster / 2 * q[0] - spin * spin / 4 * q[3],
              1e-12);
}

TEST_F(RotaryInertiaTest, WrongLengthReturnsWithCriticalDamping)
{
  // s = |Q|^2/l^2 obeys s'' = - a s' - b (s - 1) with a^2 = 4 b.
  const auto compute_change = [&](const double square, const double growth)
  {
    Quaternion q = q_, rate = rate_;
    const double factor = inertia_.length * std::sqrt(square / dot(q_, q_));
    for (unsigned int i = 0; i < 4; ++i)
    {
      q[i] *= factor;
      rate[i] = factor * rate[i] + growth / (2 * square) * q[i];
    }
    return 2 *
           (dot(q, compute_free_acceleration(inertia_, q, rate)) +
            dot(rate, rate)) /
           (inertia_.length * inertia_.length);
  };
  const double b = -compute_change(1.1, 0) / .1;
  EXPECT_GT(b, 0);
  EXPECT_NEAR(compute_change(.9, 0), .1 * b, 1e-8 * b);
  const double a = -compute_change(1, .3) / .3;
  EXPECT_NEAR(a * a, 4 * b, 1e-8 * b);
  EXPECT_NEAR(compute_change(1, 0), 0, 1e-8 * b);
}

TEST_F(RotaryInertiaTest, TangentIsThatOfMassAndDampingForRotations)
{
  constexpr double alpha = 12;
  const auto tangent =
      multiply(compute_mass_tangent(inertia_, q_, alpha), rate_);
  const auto mass = multiply(compute_mass(inertia_, q_), rate_);
  const auto damping =
      multiply(compute_tangential(inertia_.damping, q_), rate_);
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(tangent[i], alpha * alpha * mass[i] + alpha * damping[i],
                1e-8 * std::abs(alpha * alpha * mass[i]));
}
} // namespace
} // namespace taut::structure
