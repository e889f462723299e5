#pragma once

#include <taut/lumped/demes.h>

#include <array>

/// The formulas of demes.h in a form that a compiler can run side by side for
/// several states.
namespace taut::lumped::formulas
{
/// Coefficients of the power series of sin(x)/x in x^2; at |x| = pi the first
/// term left out is 1e-17.
constexpr int n_terms = 14;
using Series = std::array<double, n_terms>;

/// Order 0: of the function; 1: of its derivative over x; 2: of the second one.
constexpr Series make_series(const int order)
{
  Series series{};
  double coefficient = 1;
  for (int i = 0; i < n_terms; ++i)
  {
    series[std::size_t(i)] = order == 0   ? coefficient
                             : order == 1 ? 2 * i * coefficient
                                          : 2 * i * (2 * i - 1) * coefficient;
    coefficient /= -(2. * i + 2) * (2. * i + 3);
  }
  return series;
}

/// Sums of series[i] y^(i - first) from `first` on, for n values of y.
template <int first, std::size_t n>
inline std::array<double, n> sum_series(const Series& series,
                                        const std::array<double, n>& y)
{
  std::array<double, n> sum;
  sum.fill(series[n_terms - 1]);
  for (int term = n_terms - 2; term >= first; --term)
    for (std::size_t i = 0; i < n; ++i)
      sum[i] = series[std::size_t(term)] + y[i] * sum[i];
  return sum;
}

/// f and f' of the chord for |angle| <= pi. The eccentricity needs
/// sin(x) = x f_0 and cos(x) = f_0 + x f_0' only.
template <std::size_t n>
inline void
compute_chords(const std::array<double, n>& angle, const double eccentricity,
               std::array<double, n>& value, std::array<double, n>& slope)
{
  constexpr Series series = make_series(0), series_1 = make_series(1);
  std::array<double, n> square;
  for (std::size_t i = 0; i < n; ++i)
    square[i] = angle[i] * angle[i];
  value = sum_series<0>(series, square);
  slope = sum_series<1>(series_1, square);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double f = value[i], f_1 = angle[i] * slope[i];
    value[i] = f - eccentricity * (angle[i] * f);
    slope[i] = f_1 - eccentricity * (f + angle[i] * f_1);
  }
}

/// Capacitance over that of the undeformed film, g phi lambda^2.
inline double compute_capacitance(const Demes& demes, const double stretch)
{
  return demes.permittivity_factor * demes.permittivity.value(stretch) *
         stretch * stretch;
}

/// Its derivative by the stretch.
inline double compute_capacitance_slope(const Demes& demes,
                                        const double stretch)
{
  return demes.permittivity_factor * stretch *
         (2 * demes.permittivity.value(stretch) +
          demes.permittivity.derivative(stretch) * stretch);
}

inline double compute_electric_force(const Demes& demes, const double stretch,
                                     const double drive)
{
  const double c_1 = compute_capacitance_slope(demes, stretch);
  if (demes.control == DemesControl::voltage)
    return -drive * drive / 2 * c_1;
  const double stored = drive / compute_capacitance(demes, stretch);
  return -stored * stored / 2 * c_1;
}

/// The film's force for the square of the inner stretch.
inline double compute_force(const Demes& demes, const double stretch,
                            const double inner_square, const double drive)
{
  const double square = 1 / (stretch * stretch);
  const double inner = 1 / inner_square;
  const double elastic =
      1 - square * square +
      demes.viscous_ratio * (inner - square * square * inner_square);
  return demes.modulus_factor * stretch * elastic +
         compute_electric_force(demes, stretch, drive);
}
} // namespace taut::lumped::formulas
