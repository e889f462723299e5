#pragma once

#include <array>

namespace taut::material
{
/// Symmetric second-order tensor in the plane of the film.
template <class Number>
struct SymmetricTensor2
{
  Number xx, yy, xy;
};

/// Linear map between symmetric tensors, acting on the three numbers
/// (xx, yy, xy) of its argument. The conventions, used everywhere:
/// - a stiffness takes the engineering strain increment (dE_xx, dE_yy, 2 dE_xy)
///   with E = (C - 1)/2 and gives (dS_xx, dS_yy, dS_xy): it is symmetric when
///   S derives from an energy;
/// - a derivative with respect to an internal variable A takes
///   (dA_xx, dA_yy, dA_xy), the independent numbers themselves.
template <class Number>
using Matrix3 = std::array<std::array<Number, 3>, 3>;
} // namespace taut::material
