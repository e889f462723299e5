#include <taut/base/exceptions.h>
#include <taut/material/temperature_law.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace taut::material
{
namespace
{
/// R in J/(mol K) (CODATA 2018).
constexpr double gas_constant = 8.31446261815324;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A factor and its derivative by T (1/K).
struct Factor
{
  double value, derivative;
};

Factor compute(const ConstantLaw&, double)
{
  return {1., 0.};
}

Factor compute(const PolynomialLaw& law, const double temperature)
{
  const double x = temperature - law.reference;
  double value = 0, derivative = 0;
  for (std::size_t i = law.coefficients.size(); i-- > 0;)
  {
    derivative = derivative * x + value;
    value = value * x + law.coefficients[i];
  }
  return {1 + value * x, value + derivative * x};
}

Factor compute(const TableLaw& law, const double temperature)
{
  const auto& T = law.temperatures;
  // The slope at a row is that of the interval above it.
  const std::size_t above =
      std::upper_bound(T.begin() + 1, T.end() - 1, temperature) - T.begin();
  const double slope =
      (law.factors[above] - law.factors[above - 1]) / (T[above] - T[above - 1]);
  return {law.factors[above - 1] + slope * (temperature - T[above - 1]), slope};
}

Factor compute(const ArrheniusLaw& law, const double temperature)
{
  const double activation = law.activation_energy / gas_constant;
  const double value =
      std::exp(activation * (1 / temperature - 1 / law.reference));
  return {value, -activation / (temperature * temperature) * value};
}

TemperatureRange get_range_of(const ConstantLaw&)
{
  return {-infinity, infinity};
}

TemperatureRange get_range_of(const PolynomialLaw& law)
{
  return {law.lowest, law.highest};
}

TemperatureRange get_range_of(const TableLaw& law)
{
  return {law.temperatures.front(), law.temperatures.back()};
}

TemperatureRange get_range_of(const ArrheniusLaw&)
{
  return {std::numeric_limits<double>::min(), infinity};
}

Factor compute(const TemperatureLaw& law, const double temperature)
{
  const auto [lowest, highest] = get_range(law);
  if (!(temperature >= lowest && temperature <= highest))
  {
    std::ostringstream message;
    message << "the temperature is " << temperature << " K, its law holds from "
            << lowest << " to " << highest << " K";
    throw StepRejected(message.str());
  }
  return std::visit([&](const auto& one) { return compute(one, temperature); },
                    law);
}
} // namespace

double compute_factor(const TemperatureLaw& law, const double temperature)
{
  return compute(law, temperature).value;
}

double compute_factor_derivative(const TemperatureLaw& law,
                                 const double temperature)
{
  return compute(law, temperature).derivative;
}

TemperatureRange get_range(const TemperatureLaw& law)
{
  return std::visit([](const auto& one) { return get_range_of(one); }, law);
}
} // namespace taut::material
