#pragma once

#include <taut/fe/film_kernel.h>
#include <taut/fe/lanes.h>
#include <taut/fe/vector3.h>
#include <taut/material/tension_field.h>

#include <type_traits>

// Shared by the parts of the film kernel, which are compiled for the processor
// at hand: must include nothing of deal.II.

namespace taut::fe
{
using Tensor = material::SymmetricTensor2<Lanes>;
using Vector = std::array<Lanes, 3>;

inline const Lanes* as_lanes(const double* x)
{
  return reinterpret_cast<const Lanes*>(x);
}

inline Lanes* as_lanes(double* x)
{
  return reinterpret_cast<Lanes*>(x);
}

inline Tensor* as_tensors(double* x)
{
  return reinterpret_cast<Tensor*>(x);
}

inline const Tensor* as_tensors(const double* x)
{
  return reinterpret_cast<const Tensor*>(x);
}

/// The two columns of F = sum_a x_a (x) G_a.
struct DeformationGradient
{
  Vector f1, f2;
};

template <unsigned int n_nodes>
inline DeformationGradient make_deformation_gradient(const Lanes* gradients,
                                                     const Lanes* x)
{
  DeformationGradient F;
  for (unsigned int d = 0; d < 3; ++d)
    F.f1[d] = F.f2[d] = Lanes(0.);
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (unsigned int d = 0; d < 3; ++d)
    {
      F.f1[d] += x[3 * a + d] * gradients[2 * a];
      F.f2[d] += x[3 * a + d] * gradients[2 * a + 1];
    }
  return F;
}

inline Tensor make_metric(const DeformationGradient& F)
{
  return {dot(F.f1, F.f1), dot(F.f2, F.f2), dot(F.f1, F.f2)};
}

/// forces_a += w F S G_a.
template <unsigned int n_nodes>
inline void add_forces(const Lanes* gradients, const DeformationGradient& F,
                       const Tensor& S, const Lanes& w, Lanes* forces)
{
  Vector p1, p2;
  for (unsigned int d = 0; d < 3; ++d)
  {
    p1[d] = w * (F.f1[d] * S.xx + F.f2[d] * S.xy);
    p2[d] = w * (F.f1[d] * S.xy + F.f2[d] * S.yy);
  }
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (unsigned int d = 0; d < 3; ++d)
      forces[3 * a + d] +=
          p1[d] * gradients[2 * a] + p2[d] * gradients[2 * a + 1];
}

/// Whether some lane of a film wrinkles; S is the stress of its metric and
/// `margin` that of material::limit_margin.
inline bool wrinkles(const BatchLaw& law, const Tensor& S, const double margin)
{
  return law.wrinkle_stiffness > 0 &&
         (!(margin > 0) || any(!material::is_taut(S, law.wrinkle_stiffness)));
}

inline bool wrinkles(const BatchLaw& law, const Tensor& C, const Tensor* A,
                     const Tensor& S)
{
  return law.wrinkle_stiffness > 0 &&
         wrinkles(law, S,
                  material::limit_margin(*law.elastomer, C, A, law.field));
}

inline material::Wrinkles<Lanes> find_wrinkles(const BatchLaw& law,
                                               const Tensor& C, const Tensor* A,
                                               const Tensor& S)
{
  return material::find_wrinkles(*law.elastomer, C, A, law.field, S,
                                 law.wrinkle_stiffness);
}

/// Calls `function` with the number of nodes as a compile-time constant.
template <typename Function>
auto with_nodes(const unsigned int n_nodes, const Function& function)
{
  if (n_nodes == 9)
    return function(std::integral_constant<unsigned int, 9>());
  return function(std::integral_constant<unsigned int, 4>());
}
} // namespace taut::fe
