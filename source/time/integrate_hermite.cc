#include "integrate_hermite.h"

namespace taut::time
{
namespace
{
/// y = value[0] y0 + rate[0] y0' + value[1] y1 + rate[1] y1'.
struct Basis
{
  double value[2];
  double rate[2];

  void combine(const std::size_t n, const double* y0, const double* rate0,
               const double* y1, const double* rate1, double* y) const
  {
    for (std::size_t i = 0; i < n; ++i)
      y[i] = value[0] * y0[i] + rate[0] * rate0[i] + value[1] * y1[i] +
             rate[1] * rate1[i];
  }
};

/// The cubic Hermite basis at s in [0, 1] of a step h.
Basis compute_basis(const double s, const double h)
{
  const double r = 1 - s;
  return {{r * r * (1 + 2 * s), s * s * (3 - 2 * s)},
          {h * s * r * r, -h * s * s * r}};
}

/// Its derivative in time.
Basis compute_basis_rate(const double s, const double h)
{
  const double slope = 6 * s * (1 - s) / h;
  return {{-slope, slope}, {(1 - s) * (1 - 3 * s), s * (3 * s - 2)}};
}
} // namespace

void interpolate_hermite(const StateLayout& layout, const StepEnd& begin,
                         const StepEnd& end, const double time, double* state)
{
  const double h = end.time - begin.time;
  const double s = (time - begin.time) / h;
  const Basis basis = compute_basis(s, h);
  const std::size_t n = layout.positions;
  basis.combine(n, begin.state, begin.state + n, end.state, end.state + n,
                state);
  compute_basis_rate(s, h).combine(n, begin.state, begin.state + n, end.state,
                                   end.state + n, state + n);
  const std::size_t rest = 2 * n;
  basis.combine(layout.size() - rest, begin.state + rest, begin.f + rest,
                end.state + rest, end.f + rest, state + rest);
}
} // namespace taut::time
