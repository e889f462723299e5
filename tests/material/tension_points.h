#pragma once

#include <taut/material/tension_field.h>

#include <array>
#include <vector>

#include "automatic_differentiation.h"
#include "states.h"

// Points of a film that wrinkles, and their derivatives by differences.
namespace taut::material
{
/// A point of a film with its internal variables held.
struct Point
{
  Elastomer elastomer;
  std::vector<Tensor> A;
  Field field = {0., 300.};
  double delta = 1e-6;

  Wrinkles<double> find(const Tensor& C) const
  {
    return find_wrinkles(elastomer, C, A.data(), field, get_flat_stress(C),
                         get_wrinkle_stiffness(elastomer, delta));
  }
  Tensor get_flat_stress(const Tensor& C) const
  {
    return stress(elastomer, C, A.data(), field);
  }
  Tensor get_stress(const Tensor& C) const
  {
    return compute_wrinkled_stress(find(C), C, get_flat_stress(C));
  }
  double get_energy(const Tensor& C) const
  {
    const auto wrinkles = find(C);
    return energy(elastomer, wrinkles.metric, A.data(), field) +
           compute_wrinkle_energy(wrinkles, C);
  }
  Matrix3<double> get_response(const Tensor& C, const double alpha,
                               Matrix3<double>& D) const
  {
    const auto wrinkles = find(C);
    Tensor S;
    stress_and_stiffness(elastomer, wrinkles.metric, A.data(), field, alpha, S,
                         D);
    return make_wrinkle_response(wrinkles, C, S, D);
  }
  Matrix3<double> get_stiffness(const Tensor& C) const
  {
    Matrix3<double> D;
    const auto N = get_response(C, frozen, D);
    return condense_wrinkles(N, D);
  }
};

inline Point make_neo_hookean(const double field_number = 0.)
{
  Point point{{{NeoHookean{1.}}, {}, {ConstantPermittivity{1.}}, 0.}, {}};
  point.field.nominal_squared =
      field_number * field_number / vacuum_permittivity;
  return point;
}

/// Springs and networks of all kinds, these out of equilibrium and with axes
/// of their own.
inline Point make_viscous(const double nominal_field = 0.)
{
  Point point{make_elastomer(), {}};
  double angle = .2;
  for (std::size_t m = 0; m < point.elastomer.networks.size(); ++m)
    point.A.push_back(make_turned(.8 + .05 * m, 1.15, angle += .4));
  point.field.nominal_squared = nominal_field * nominal_field;
  return point;
}

enum class Kind
{
  taut,
  wrinkled,
  slack
};

inline Kind get_kind(const Wrinkles<double>& wrinkles)
{
  return wrinkles.slack      ? Kind::slack
         : wrinkles.wrinkled ? Kind::wrinkled
                             : Kind::taut;
}

inline Tensor move(const Tensor& C, const unsigned int component,
                   const double step)
{
  return {C.xx + (component == 0) * step, C.yy + (component == 1) * step,
          C.xy + (component == 2) * step};
}

/// Differences of fourth order.
template <class Function>
auto differentiate(const Function& f, const double h)
{
  return (8. * (f(h) - f(-h)) - (f(2. * h) - f(-2. * h))) / (12. * h);
}

/// S = 2 dW_r/dC, (S_xx, S_yy, S_xy), by differences.
inline Tensor differentiate_energy(const Point& point, const Tensor& C)
{
  std::array<double, 3> by_C;
  for (unsigned int i = 0; i < 3; ++i)
    by_C[i] = differentiate(
        [&](const double h) { return point.get_energy(move(C, i, h)); }, 1e-3);
  return {2. * by_C[0], 2. * by_C[1], by_C[2]};
}

inline Matrix3<double> differentiate_stress(const Point& point, const Tensor& C,
                                            const double h)
{
  Matrix3<double> by_C;
  for (unsigned int j = 0; j < 3; ++j)
  {
    const auto by = [&](const auto component)
    {
      return differentiate(
          [&](const double step)
          { return point.get_stress(move(C, j, step)).*component; },
          h);
    };
    by_C[0][j] = by(&Tensor::xx);
    by_C[1][j] = by(&Tensor::yy);
    by_C[2][j] = by(&Tensor::xy);
  }
  return to_strain(by_C);
}
} // namespace taut::material
