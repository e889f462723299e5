#include <taut/base/exceptions.h>
#include <taut/material/scalar_law.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace taut::material
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
} // namespace

Factor compute(const ConstantLaw&, double)
{
  return {1., 0.};
}

Factor compute(const PolynomialLaw& law, const double argument)
{
  const double x = argument - law.reference;
  double value = 0, derivative = 0;
  for (std::size_t i = law.coefficients.size(); i-- > 0;)
  {
    derivative = derivative * x + value;
    value = value * x + law.coefficients[i];
  }
  return {1 + value * x, value + derivative * x};
}

Factor compute(const TableLaw& law, const double argument)
{
  const auto& x = law.arguments;
  // The slope at a row is that of the interval above it.
  const std::size_t above =
      std::upper_bound(x.begin() + 1, x.end() - 1, argument) - x.begin();
  const double slope =
      (law.factors[above] - law.factors[above - 1]) / (x[above] - x[above - 1]);
  return {law.factors[above - 1] + slope * (argument - x[above - 1]), slope};
}

LawRange get_range(const ConstantLaw&)
{
  return {-infinity, infinity};
}

LawRange get_range(const PolynomialLaw& law)
{
  return {law.lowest, law.highest};
}

LawRange get_range(const TableLaw& law)
{
  return {law.arguments.front(), law.arguments.back()};
}

void require_in_range(const LawRange& range, const double argument,
                      const std::string& name, const std::string& unit)
{
  if (argument >= range.lowest && argument <= range.highest)
    return;
  std::ostringstream message;
  message << "the " << name << " is " << argument << unit
          << ", its law holds from " << range.lowest << " to " << range.highest
          << unit;
  throw StepRejected(message.str());
}
} // namespace taut::material
