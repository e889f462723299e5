#pragma once

#include <taut/material/elastomer.h>

#include <Sacado_No_Kokkos.hpp>

// The second, automatic derivative of everything that has a hand-written one.
namespace taut::material
{
/// Six independent numbers: (C_xx, C_yy, C_xy, A_xx, A_yy, A_xy).
using First = Sacado::Fad::SFad<double, 6>;
using Second = Sacado::Fad::SFad<First, 6>;

inline First make_first(double value, int index)
{
  return First(6, index, value);
}

inline Second make_second(double value, int index)
{
  return Second(6, index, make_first(value, index));
}

inline SymmetricTensor2<First> make_first(const SymmetricTensor2<double>& a,
                                          int start)
{
  return {make_first(a.xx, start), make_first(a.yy, start + 1),
          make_first(a.xy, start + 2)};
}

inline SymmetricTensor2<Second> make_second(const SymmetricTensor2<double>& a,
                                            int start)
{
  return {make_second(a.xx, start), make_second(a.yy, start + 1),
          make_second(a.xy, start + 2)};
}

/// The derivatives of the components of a tensor by three of the variables.
inline Matrix3<double> get_jacobian(const SymmetricTensor2<First>& a, int start)
{
  Matrix3<double> result;
  const std::array<const First*, 3> rows = {{&a.xx, &a.yy, &a.xy}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      result[i][j] = rows[i]->dx(start + j);
  return result;
}

/// From derivatives by (C_xx, C_yy, C_xy) to those by the engineering strain
/// (E_xx, E_yy, 2 E_xy): dC_xx = 2 dE_xx, dC_xy = d(2 E_xy).
inline Matrix3<double> to_strain(Matrix3<double> by_C)
{
  for (auto& row : by_C)
  {
    row[0] *= 2.;
    row[1] *= 2.;
  }
  return by_C;
}
} // namespace taut::material
