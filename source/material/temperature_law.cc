#include <taut/material/temperature_law.h>

#include <cmath>
#include <limits>

namespace taut::material
{
namespace
{
/// R in J/(mol K) (CODATA 2018).
constexpr double gas_constant = 8.31446261815324;

Factor compute(const ArrheniusLaw& law, const double temperature)
{
  const double activation = law.activation_energy / gas_constant;
  const double value =
      std::exp(activation * (1 / temperature - 1 / law.reference));
  return {value, -activation / (temperature * temperature) * value};
}

LawRange get_range(const ArrheniusLaw&)
{
  return {std::numeric_limits<double>::min(),
          std::numeric_limits<double>::infinity()};
}

Factor evaluate(const TemperatureLaw& law, const double temperature)
{
  require_in_range(material::get_range(law), temperature, "temperature", " K");
  return std::visit([=](const auto& one) { return compute(one, temperature); },
                    law);
}
} // namespace

double compute_factor(const TemperatureLaw& law, const double temperature)
{
  return evaluate(law, temperature).value;
}

double compute_factor_derivative(const TemperatureLaw& law,
                                 const double temperature)
{
  return evaluate(law, temperature).derivative;
}

LawRange get_range(const TemperatureLaw& law)
{
  return std::visit([](const auto& one) { return get_range(one); }, law);
}
} // namespace taut::material
