#pragma once

#include <utility>

namespace taut::material
{
/// Laws with an exponential function hold below this exponent, in which it
/// reaches 5e21: far beyond what can be measured, and far from overflow.
constexpr double largest_exponent = 50.;

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

/// Comparison and choice by value. A type that holds several values brings its
/// own overloads, which compare and choose value by value; their masks know
/// `&`, `|` and `!`.
template <class Number>
bool is_less(const Number& a, const Number& b)
{
  return a < b;
}

template <class Number>
Number select(bool condition, const Number& a, const Number& b)
{
  return condition ? a : b;
}

/// Whether a condition holds for one value at least.
inline bool any(bool condition)
{
  return condition;
}

/// What is_less gives: one truth per value.
template <class Number>
using Mask = decltype(is_less(std::declval<const Number&>(),
                              std::declval<const Number&>()));
} // namespace taut::material
