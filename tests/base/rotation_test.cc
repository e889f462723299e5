#include <taut/base/rotation.h>

#include <gtest/gtest.h>

#include <cmath>

namespace taut
{
namespace
{
// Products of a few rounded numbers of order one.
constexpr double rounding = 1e-14;
const double pi = std::acos(-1.);

Quaternion scale(const double factor, const Quaternion& q)
{
  return {factor * q[0], factor * q[1], factor * q[2], factor * q[3]};
}

void expect_near(const Vector3& a, const Vector3& b, const double tolerance)
{
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

TEST(Rotation, TurnsAQuarterAboutAnAxis)
{
  const Quaternion about_z = make_rotation({0, 0, pi / 2});
  expect_near(rotate(about_z, {1, 0, 0}), {0, 1, 0}, rounding);
  expect_near(rotate(about_z, {0, 1, 0}), {-1, 0, 0}, rounding);
  expect_near(rotate(about_z, {0, 0, 1}), {0, 0, 1}, rounding);
}

TEST(Rotation, FollowsTheFormulaOfRodrigues)
{
  // Half the turn that swaps the axes in a circle: x -> y -> z.
  const double third = 2 * pi / 3 / std::sqrt(3.);
  const Quaternion q = make_rotation({third, third, third});
  expect_near(rotate(q, {1, 2, 3}), {3, 1, 2}, rounding);
  const double sixth = third / 2;
  const Quaternion half = make_rotation({sixth, sixth, sixth});
  expect_near(rotate(half, rotate(half, {1, 2, 3})), {3, 1, 2}, rounding);
}

TEST(Rotation, LengthOfTheQuaternionDoesNotMatter)
{
  const Quaternion q = make_rotation({0.3, -1.2, 2.1});
  expect_near(rotate(scale(7, q), {1, 2, 3}), rotate(q, {1, 2, 3}), rounding);
  const Quaternion rate = {0.1, 0.4, -0.3, 0.2};
  expect_near(compute_angular_velocity(scale(7, q), scale(7, rate)),
              compute_angular_velocity(q, rate), rounding);
  EXPECT_NEAR(length(scale(7, q)), 7, 7 * rounding);
}

TEST(Rotation, BackIsTheInverse)
{
  const Quaternion q = scale(2, make_rotation({0.3, -1.2, 2.1}));
  const Vector3 v = {1, 2, 3};
  expect_near(rotate_back(q, rotate(q, v)), v, rounding);
  expect_near(rotate(conjugate(q), v), rotate_back(q, v), rounding);
}

TEST(Rotation, ProductTurnsByTheRightFactorFirst)
{
  const Quaternion a = make_rotation({0.5, 0.1, -2}),
                   b = make_rotation({-1, 0.7, 0.2});
  expect_near(rotate(multiply(a, b), {1, 2, 3}),
              rotate(a, rotate(b, {1, 2, 3})), rounding);
}

TEST(Rotation, SmallVectorsKeepAllTheirDigits)
{
  for (const double angle : {0., 1e-300, 1e-160, 1e-9, 1e-4, 1e-2})
  {
    const Quaternion q = make_rotation({0, angle, 0});
    EXPECT_NEAR(length(q), 1, rounding);
    EXPECT_NEAR(compute_angle(q, {0, 1, 0}), angle, rounding * angle);
  }
}

TEST(Rotation, AngleIsContinuousOverAFullTurn)
{
  const Vector3 axis = {0.6, 0, 0.8};
  for (int i = -19; i <= 19; ++i)
  {
    const double angle = i * pi / 10;
    const Quaternion q = scale(
        3, make_rotation({angle * axis[0], angle * axis[1], angle * axis[2]}));
    EXPECT_NEAR(compute_angle(q, axis), angle, 10 * rounding);
  }
}

TEST(Rotation, AngularVelocityIsThatOfTheSection)
{
  // R = R_z(t) R_x(2 t): in the section's axes R_x^T e_z + 2 e_x.
  const double t = 0.4, step = 1e-5;
  const auto turn = [](const double time)
  {
    return multiply(make_rotation({0, 0, time}),
                    make_rotation({2 * time, 0, 0}));
  };
  Quaternion rate;
  for (unsigned int i = 0; i < 4; ++i)
    rate[i] = (turn(t + step)[i] - turn(t - step)[i]) / (2 * step);
  // Central differences: step^2.
  expect_near(compute_angular_velocity(turn(t), rate),
              {2, std::sin(2 * t), std::cos(2 * t)}, 10 * step * step);
}
} // namespace
} // namespace taut
