#pragma once

#include <utility>

namespace taut::material
{
/// Keeps a function argument out of template argument deduction, so that a
/// null pointer can be passed for it.
template <class Type>
struct NotDeduced
{
  using type = Type;
};

/// The largest value that a number holds: itself for a double, the value for a
/// number of automatic differentiation. Types that hold several values bring
/// their own overload, found by argument-dependent lookup.
inline double largest(double number)
{
  return number;
}

template <class Number, class = decltype(std::declval<const Number&>().val())>
double largest(const Number& number)
{
  return largest(number.val());
}
} // namespace taut::material
