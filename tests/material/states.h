#pragma once

#include <taut/material/elastomer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

// Elastomers and states that the tests of the material share.
namespace taut::material
{
using Tensor = SymmetricTensor2<double>;

inline std::vector<Spring> make_springs()
{
  return {NeoHookean{2e4}, MooneyRivlin{7e3, 2e3}, Gent{2e4, 60.},
          Yeoh{9e3, -100., 3.}, ArrudaBoyce{1.5e4, 5.99}};
}

inline std::vector<RelaxationLaw> make_relaxation_laws()
{
  return {ConstantRelaxation{}, StressActivatedRelaxation{1.5e4},
          StretchActivatedRelaxation{.8}};
}

/// All springs beside each other, and a network with each of them, whose
/// relaxation times take turns in their laws.
inline Elastomer make_elastomer()
{
  Elastomer elastomer = {make_springs(), {}, {StretchPermittivity{}}, 960.};
  const std::vector<RelaxationLaw> laws = make_relaxation_laws();
  double time = .05;
  for (const Spring& spring : make_springs())
    elastomer.networks.push_back(
        {spring, time *= 4., FlowLaw::isotropic,
         laws[elastomer.networks.size() % laws.size()]});
  return elastomer;
}

inline Elastomer make_single_network(const Spring& spring)
{
  return {{}, {{spring, .7}}, {}, 0.};
}

/// One network each, with every spring and every law of the relaxation time.
inline std::vector<Elastomer> make_single_networks()
{
  std::vector<Elastomer> elastomers;
  for (const Spring& spring : make_springs())
    for (const RelaxationLaw& law : make_relaxation_laws())
    {
      elastomers.push_back(make_single_network(spring));
      elastomers.back().networks[0].relaxation = law;
    }
  return elastomers;
}

inline Field make_strong_field()
{
  return {2e14, 320.};
}

/// diag(a^2, b^2) turned by an angle.
inline Tensor make_turned(double a, double b, double angle)
{
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {a * a * c * c + b * b * s * s, a * a * s * s + b * b * c * c,
          (a * a - b * b) * s * c};
}

/// Q a Q^T for the rotation by an angle.
inline Tensor rotate(const Tensor& a, double angle)
{
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * c * a.xx + s * s * a.yy - 2. * s * c * a.xy,
          s * s * a.xx + c * c * a.yy + 2. * s * c * a.xy,
          s * c * (a.xx - a.yy) + (c * c - s * s) * a.xy};
}

struct State
{
  Tensor C;
  std::vector<Tensor> A;
};

/// Reproducible states with stretches 0.7 to 2.5 and elastic stretches of the
/// networks that differ from 1 by up to a half, all directions different.
inline std::vector<State> make_states(std::size_t networks)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> stretch(.7, 2.5), ratio(.7, 1.4),
      angle(0., 3.);
  std::vector<State> states(20);
  for (State& state : states)
  {
    const double a = stretch(generator), b = stretch(generator);
    const double direction = angle(generator);
    state.C = make_turned(a, b, direction);
    for (std::size_t m = 0; m < networks; ++m)
      state.A.push_back(make_turned(ratio(generator) / a, ratio(generator) / b,
                                    direction + .3 * ratio(generator)));
  }
  return states;
}

inline State make_virgin_state(std::size_t networks)
{
  return {make_identity<double>(),
          std::vector<Tensor>(networks, make_identity<double>())};
}

inline void expect_near(const Tensor& a, const Tensor& b, double tolerance)
{
  EXPECT_NEAR(a.xx, b.xx, tolerance);
  EXPECT_NEAR(a.yy, b.yy, tolerance);
  EXPECT_NEAR(a.xy, b.xy, tolerance);
}

inline void expect_near(const Matrix3<double>& a, const Matrix3<double>& b,
                        double tolerance)
{
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      EXPECT_NEAR(a[i][j], b[i][j], tolerance) << i << ", " << j;
}

inline double norm(const Matrix3<double>& a)
{
  double sum = 0.;
  for (const auto& row : a)
    for (const double entry : row)
      sum += entry * entry;
  return std::sqrt(sum);
}

/// |D - D^T|/|D|.
inline double get_asymmetry(const Matrix3<double>& a)
{
  const double xx_yy = a[0][1] - a[1][0];
  const double xx_xy = a[0][2] - a[2][0];
  const double yy_xy = a[1][2] - a[2][1];
  return std::sqrt(2. * (xx_yy * xx_yy + xx_xy * xx_xy + yy_xy * yy_xy)) /
         norm(a);
}

/// The three numbers of a tensor under a map of tensors.h.
inline Tensor multiply(const Matrix3<double>& map, const Tensor& a)
{
  const auto row = [&](unsigned int i)
  { return map[i][0] * a.xx + map[i][1] * a.yy + map[i][2] * a.xy; };
  return {row(0), row(1), row(2)};
}
} // namespace taut::material
