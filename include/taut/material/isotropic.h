#pragma once

#include <taut/material/tensor_algebra.h>

// Every isotropic energy of an incompressible film is a function W(t, d) of
// t = tr(C A) and d = det(C A), with A the inverse inelastic metric of a
// viscous network (identity for a spring and for the dielectric): the principal
// invariants of the elastic part diag(C A, 1/det(C A)) are
//   I1 = t + 1/d,   I2 = t/d + d.
// One set of derivatives therefore serves springs, networks and the dielectric.
// Those by d are taken by l = ln d, which makes dl = C^-1 : dC.
namespace taut::material
{
template <class Number>
struct Invariants
{
  Number t; ///< tr(C A)
  Number d; ///< det(C A)
  Number p; ///< 1/d, the square of the elastic thickness stretch

  Number first() const
  {
    return t + p;
  } ///< I1
  Number second() const
  {
    return t * p + d;
  } ///< I2
};

/// Of C alone (A = identity).
template <class Number>
Invariants<Number> compute_invariants(const SymmetricTensor2<Number>& C)
{
  const Number d = compute_determinant(C);
  return {C.xx + C.yy, d, 1. / d};
}

template <class Number>
Invariants<Number> compute_invariants(const SymmetricTensor2<Number>& C,
                                      const SymmetricTensor2<Number>& A)
{
  const Number d = compute_determinant(C) * compute_determinant(A);
  return {contract(C, A), d, 1. / d};
}

/// Derivatives of an energy W(I1).
template <class Number>
struct FirstInvariantDerivatives
{
  Number by_1, by_11;
};

/// Derivatives of an energy W(I1, I2).
template <class Number>
struct InvariantDerivatives
{
  Number by_1, by_2, by_11, by_12, by_22;
};

/// Derivatives of an energy by t and l = ln d.
template <class Number>
struct EnergyDerivatives
{
  Number t, l, tt, tl, ll;
};

/// dI1 = dt - p dl.
template <class Number>
EnergyDerivatives<Number>
compute_energy_derivatives(const FirstInvariantDerivatives<Number>& W,
                           const Invariants<Number>& invariants)
{
  const Number& p = invariants.p;
  const Number l = -(p * W.by_1);
  const Number tl = -(p * W.by_11);
  return {W.by_1, l, W.by_11, tl, -l - p * tl};
}

/// dI1 = dt - p dl, dI2 = p dt + (d - t p) dl.
template <class Number>
EnergyDerivatives<Number>
compute_energy_derivatives(const InvariantDerivatives<Number>& W,
                           const Invariants<Number>& invariants)
{
  const Number& p = invariants.p;
  const Number tp = invariants.t * p;
  const Number q = invariants.d - tp;
  const Number by_1t = W.by_11 + p * W.by_12;
  const Number by_2t = W.by_12 + p * W.by_22;
  const Number by_1l = q * W.by_12 - p * W.by_11;
  const Number by_2l = q * W.by_22 - p * W.by_12;
  return {W.by_1 + p * W.by_2, q * W.by_2 - p * W.by_1, by_1t + p * by_2t,
          q * by_2t - p * by_1t - p * W.by_2,
          p * W.by_1 + (invariants.d + tp) * W.by_2 - p * by_1l + q * by_2l};
}

template <class Number>
EnergyDerivatives<Number> operator+(const EnergyDerivatives<Number>& a,
                                    const EnergyDerivatives<Number>& b)
{
  return {a.t + b.t, a.l + b.l, a.tt + b.tt, a.tl + b.tl, a.ll + b.ll};
}

/// A change of stress, at a change of strain dC, in the tensors that span it:
///   dS = 2 (A (aa A:dC + ac C^-1:dC) + C^-1 (ca A:dC + cc C^-1:dC)
///           - k C^-1 dC C^-1).
template <class Number>
struct StiffnessCoefficients
{
  Number aa, ac, ca, cc, k;
};

/// Elastic: S = 2 (W_t A + W_l C^-1) derived at fixed A.
template <class Number>
StiffnessCoefficients<Number>
make_elastic_coefficients(const EnergyDerivatives<Number>& W)
{
  return {W.tt, W.tl, W.tl, W.ll, W.l};
}

/// Sums stress and stiffness over the parts of an elastomer; what all parts
/// share (the terms in C^-1) enters the tensors only once, at the end.
template <class Number>
class StiffnessSum
{
public:
  /// The part with A = identity.
  StiffnessSum(const EnergyDerivatives<Number>& W,
               const SymmetricTensor2<Number>& inverse_C);

  /// One more part.
  void add(const SymmetricTensor2<Number>& A,
           const EnergyDerivatives<Number>& W,
           const StiffnessCoefficients<Number>& coefficients);

  /// A stiffness dS = 4 factor a (a : dE), symmetric.
  void add_square(const Number& factor, const SymmetricTensor2<Number>& a);

  /// S in Pa and D = dS/dE (conventions of tensors.h) in Pa.
  void get(SymmetricTensor2<Number>& S, Matrix3<Number>& D) const;

private:
  SymmetricTensor2<Number> inverse_C_;
  SymmetricTensor2<Number> stress_;      ///< sum of W_t A
  SymmetricTensor2<Number> inverse_row_; ///< what C^-1 is multiplied with
  Matrix3<Number> stiffness_;            ///< sum of A (aa A + ac C^-1)
  Number l_;                             ///< sum of W_l
  Number k_;                             ///< sum of k
};

template <class Number>
StiffnessSum<Number>::StiffnessSum(const EnergyDerivatives<Number>& W,
                                   const SymmetricTensor2<Number>& inverse_C)
    : inverse_C_(inverse_C), stress_{W.t, W.t, Number(0.)},
      inverse_row_{W.tl + W.ll * inverse_C.xx, W.tl + W.ll * inverse_C.yy,
                   W.ll * inverse_C.xy},
      l_(W.l), k_(W.l)
{
  const SymmetricTensor2<Number> row = {W.tt + W.tl * inverse_C.xx,
                                        W.tt + W.tl * inverse_C.yy,
                                        W.tl * inverse_C.xy};
  stiffness_[0] = {{row.xx, row.yy, row.xy}};
  stiffness_[1] = stiffness_[0];
  stiffness_[2] = {{Number(0.), Number(0.), Number(0.)}};
}

template <class Number>
void StiffnessSum<Number>::add(
    const SymmetricTensor2<Number>& A, const EnergyDerivatives<Number>& W,
    const StiffnessCoefficients<Number>& coefficients)
{
  stress_ = add_scaled(stress_, W.t, A);
  l_ = l_ + W.l;
  k_ = k_ + coefficients.k;
  inverse_row_ = add_scaled(add_scaled(inverse_row_, coefficients.ca, A),
                            coefficients.cc, inverse_C_);
  const SymmetricTensor2<Number> row =
      combine(coefficients.aa, A, coefficients.ac, inverse_C_);
  const std::array<Number, 3> column = {{A.xx, A.yy, A.xy}};
  for (unsigned int i = 0; i < 3; ++i)
  {
    stiffness_[i][0] = stiffness_[i][0] + column[i] * row.xx;
    stiffness_[i][1] = stiffness_[i][1] + column[i] * row.yy;
    stiffness_[i][2] = stiffness_[i][2] + column[i] * row.xy;
  }
}

template <class Number>
void StiffnessSum<Number>::add_square(const Number& factor,
                                      const SymmetricTensor2<Number>& a)
{
  const std::array<Number, 3> row = {{a.xx, a.yy, a.xy}};
  for (unsigned int i = 0; i < 3; ++i)
  {
    const Number scaled = factor * row[i];
    for (unsigned int j = 0; j < 3; ++j)
      stiffness_[i][j] = stiffness_[i][j] + scaled * row[j];
  }
}

template <class Number>
void StiffnessSum<Number>::get(SymmetricTensor2<Number>& S,
                               Matrix3<Number>& D) const
{
  const Number two_l = 2. * l_;
  S = combine(Number(2.), stress_, two_l, inverse_C_);
  const Matrix3<Number> sandwich_map = make_sandwich_map(inverse_C_);
  const std::array<Number, 3> column = {
      {4. * inverse_C_.xx, 4. * inverse_C_.yy, 4. * inverse_C_.xy}};
  const std::array<Number, 3> row = {
      {inverse_row_.xx, inverse_row_.yy, inverse_row_.xy}};
  const Number two_k = 2. * k_;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      D[i][j] = 4. * stiffness_[i][j] + column[i] * row[j] -
                two_k * sandwich_map[i][j];
}
} // namespace taut::material
