#include <taut/base/exceptions.h>
#include <taut/material/breakdown_law.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace taut::material
{
namespace
{
void require_within(const ValidRange& range, const double value,
                    const std::string& quantity)
{
  if (value >= range.lowest && value <= range.highest)
    return;
  std::ostringstream message;
  message << "the " << quantity << " is " << value
          << ", the law of the breakdown strength holds from " << range.lowest
          << " to " << range.highest;
  throw StepRejected(message.str());
}

double compute_factor(const StretchStrength& law, const BreakdownState& state)
{
  const double stretch = std::sqrt(state.area_stretch);
  require_within(law.range, stretch, "root of the area stretch");
  return std::pow(stretch, law.exponent);
}

double compute_factor(const ThicknessStrength& law, const BreakdownState& state)
{
  require_within(law.range, state.thickness, "thickness (m)");
  return std::pow(state.thickness / law.reference, -law.exponent);
}

double compute_factor(const TemperatureStrength& law,
                      const BreakdownState& state)
{
  return compute_factor(law.law, state.temperature);
}

double compute_factor(const HumidityStrength& law, const BreakdownState& state)
{
  return compute_factor(law.law, state.humidity);
}

double compute_factor(const RateStrength& law, const BreakdownState& state)
{
  const double rate = std::min(std::max(state.field_rate, law.bounds.lowest),
                               law.bounds.highest);
  return std::pow(rate / law.reference, law.exponent);
}
} // namespace

double compute_strength(const BreakdownLaw& law, const BreakdownState& state)
{
  double strength = law.reference;
  for (const StrengthFactor& factor : law.factors)
    strength *= std::visit(
        [&](const auto& one) { return compute_factor(one, state); }, factor);
  return strength;
}
} // namespace taut::material
