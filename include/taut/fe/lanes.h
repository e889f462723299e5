#pragma once

#include <algorithm>
#include <cmath>

namespace taut::fe
{
/// Number of cells the film kernel works on at once.
constexpr unsigned int n_lanes = 8;

/// Eight doubles, one per cell of a batch. Only for source files that are
/// compiled for the processor at hand and include nothing of deal.II: the
/// width of the registers changes how this type is passed.
struct Lanes
{
  using Vector = double __attribute__((vector_size(8 * n_lanes)));
  Vector v;

  Lanes() = default;
  Lanes(const double x) : v(x - Vector{}) {}
  explicit Lanes(const Vector& vector) : v(vector) {}

  Lanes& operator+=(const Lanes& b)
  {
    v += b.v;
    return *this;
  }
  Lanes& operator-=(const Lanes& b)
  {
    v -= b.v;
    return *this;
  }
  Lanes& operator*=(const Lanes& b)
  {
    v *= b.v;
    return *this;
  }
  Lanes& operator/=(const Lanes& b)
  {
    v /= b.v;
    return *this;
  }

  friend Lanes operator+(const Lanes& a, const Lanes& b)
  {
    return Lanes(a.v + b.v);
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b)
  {
    return Lanes(a.v - b.v);
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b)
  {
    return Lanes(a.v * b.v);
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b)
  {
    return Lanes(a.v / b.v);
  }
  friend Lanes operator-(const Lanes& a)
  {
    return Lanes(-a.v);
  }
  friend Lanes operator+(const Lanes& a)
  {
    return a;
  }
};

/// `function` applied to each lane.
template <typename Function>
Lanes apply(const Lanes& a, const Function& function)
{
  Lanes result;
  for (unsigned int i = 0; i < n_lanes; ++i)
    result.v[i] = function(a.v[i]);
  return result;
}

inline Lanes sqrt(const Lanes& a)
{
  return apply(a, [](const double x) { return std::sqrt(x); });
}

inline Lanes log(const Lanes& a)
{
  return apply(a, [](const double x) { return std::log(x); });
}

inline Lanes exp(const Lanes& a)
{
  return apply(a, [](const double x) { return std::exp(x); });
}

/// One truth per lane: all bits set, or none.
struct LaneMask
{
  using Bits = decltype(Lanes::Vector{} < Lanes::Vector{});
  Bits v;

  friend LaneMask operator&(const LaneMask& a, const LaneMask& b)
  {
    return {a.v & b.v};
  }
  friend LaneMask operator|(const LaneMask& a, const LaneMask& b)
  {
    return {a.v | b.v};
  }
  friend LaneMask operator!(const LaneMask& a)
  {
    return {~a.v};
  }
};

inline LaneMask is_less(const Lanes& a, const Lanes& b)
{
  return {a.v < b.v};
}

inline Lanes select(const LaneMask& condition, const Lanes& a, const Lanes& b)
{
  return Lanes(condition.v ? a.v : b.v);
}

inline bool any(const LaneMask& condition)
{
  long long bits = 0;
  for (unsigned int i = 0; i < n_lanes; ++i)
    bits |= condition.v[i];
  return bits != 0;
}

/// Largest lane; NaN if any lane is.
inline double largest(const Lanes& a)
{
  double result = a.v[0];
  for (unsigned int i = 1; i < n_lanes; ++i)
    result = (a.v[i] > result || std::isnan(a.v[i])) ? a.v[i] : result;
  return result;
}
} // namespace taut::fe
