#pragma once

#include <taut/material/tensors.h>

namespace taut::material
{
template <class Number>
SymmetricTensor2<Number> make_identity()
{
  return {Number(1.), Number(1.), Number(0.)};
}

template <class Number>
Number compute_determinant(const SymmetricTensor2<Number>& a)
{
  return a.xx * a.yy - a.xy * a.xy;
}

/// The inverse of `a`, given the inverse of its determinant.
template <class Number>
SymmetricTensor2<Number> compute_inverse(const SymmetricTensor2<Number>& a,
                                         const Number& inverse_determinant)
{
  return {a.yy * inverse_determinant, a.xx * inverse_determinant,
          -a.xy * inverse_determinant};
}

template <class Number>
SymmetricTensor2<Number> compute_inverse(const SymmetricTensor2<Number>& a)
{
  const Number inverse_determinant = 1. / compute_determinant(a);
  return compute_inverse(a, inverse_determinant);
}

/// a : b = tr(a b).
template <class Number>
Number contract(const SymmetricTensor2<Number>& a,
                const SymmetricTensor2<Number>& b)
{
  return a.xx * b.xx + a.yy * b.yy + 2. * (a.xy * b.xy);
}

/// factor_a a + factor_b b.
template <class Number>
SymmetricTensor2<Number>
combine(const Number& factor_a, const SymmetricTensor2<Number>& a,
        const Number& factor_b, const SymmetricTensor2<Number>& b)
{
  return {factor_a * a.xx + factor_b * b.xx, factor_a * a.yy + factor_b * b.yy,
          factor_a * a.xy + factor_b * b.xy};
}

template <class Number>
SymmetricTensor2<Number> add(const SymmetricTensor2<Number>& a,
                             const SymmetricTensor2<Number>& b)
{
  return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy};
}

/// sum + factor a.
template <class Number>
SymmetricTensor2<Number> add_scaled(const SymmetricTensor2<Number>& sum,
                                    const Number& factor,
                                    const SymmetricTensor2<Number>& a)
{
  return {sum.xx + factor * a.xx, sum.yy + factor * a.yy,
          sum.xy + factor * a.xy};
}

/// a b a, symmetric.
template <class Number>
SymmetricTensor2<Number> sandwich(const SymmetricTensor2<Number>& a,
                                  const SymmetricTensor2<Number>& b)
{
  const Number row_x_x = a.xx * b.xx + a.xy * b.xy;
  const Number row_x_y = a.xx * b.xy + a.xy * b.yy;
  const Number row_y_x = a.xy * b.xx + a.yy * b.xy;
  const Number row_y_y = a.xy * b.xy + a.yy * b.yy;
  return {row_x_x * a.xx + row_x_y * a.xy, row_y_x * a.xy + row_y_y * a.yy,
          row_x_x * a.xy + row_x_y * a.yy};
}

/// The map b -> 2 a b a on the engineering components (b_xx, b_yy, 2 b_xy):
/// symmetric, a_ik a_jl + a_il a_jk.
template <class Number>
Matrix3<Number> make_sandwich_map(const SymmetricTensor2<Number>& a)
{
  const Number xx_xx = 2. * (a.xx * a.xx);
  const Number yy_yy = 2. * (a.yy * a.yy);
  const Number xx_yy = 2. * (a.xy * a.xy);
  const Number xx_xy = 2. * (a.xx * a.xy);
  const Number yy_xy = 2. * (a.yy * a.xy);
  const Number xy_xy = a.xx * a.yy + a.xy * a.xy;
  return {{{{xx_xx, xx_yy, xx_xy}},
           {{xx_yy, yy_yy, yy_xy}},
           {{xx_xy, yy_xy, xy_xy}}}};
}
} // namespace taut::material
