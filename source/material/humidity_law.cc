#include <taut/material/humidity_law.h>

#include <algorithm>
#include <cmath>

namespace taut::material
{
namespace
{
Factor compute(const ExponentialLaw& law, const double humidity)
{
  const double value = std::exp(law.coefficient * (humidity - law.reference));
  return {value, law.coefficient * value};
}

LawRange get_range(const ExponentialLaw&)
{
  return {0, 1};
}

Factor evaluate(const HumidityLaw& law, const double humidity)
{
  require_in_range(material::get_range(law), humidity, "relative humidity", "");
  return std::visit([=](const auto& one) { return compute(one, humidity); },
                    law);
}
} // namespace

double compute_factor(const HumidityLaw& law, const double humidity)
{
  return evaluate(law, humidity).value;
}

double compute_factor_derivative(const HumidityLaw& law, const double humidity)
{
  return evaluate(law, humidity).derivative;
}

LawRange get_range(const HumidityLaw& law)
{
  const LawRange range =
      std::visit([](const auto& one) { return get_range(one); }, law);
  return {std::max(range.lowest, 0.), std::min(range.highest, 1.)};
}
} // namespace taut::material
