#include <taut/material/at_temperature.h>

#include <cmath>

namespace taut::material
{
namespace
{
void move_permittivity(ConstantPermittivity&, double, double) {}

/// By d(A/T)/dT = -A/T^2.
void move_permittivity(StretchPermittivity& law, const double temperature,
                       const double step)
{
  law.high_temperature -= step * law.dipole / (temperature * temperature);
}
/// All moduli of springs and networks, and all relaxation times.
void scale(Elastomer& elastomer, const double stiffer, const double slower)
{
  for (Spring& spring : elastomer.springs)
    spring = scale_moduli(spring, stiffer);
  for (Network& network : elastomer.networks)
  {
    network.spring = scale_moduli(network.spring, stiffer);
    network.relaxation_time *= slower;
  }
}

/// The factor of a law `step` along its tangent.
template <class Law>
double extrapolate(const Law& law, const double argument, const double step)
{
  return compute_factor(law, argument) +
         step * compute_factor_derivative(law, argument);
}
} // namespace

bool is_constant(const ThermalLaws& laws)
{
  return std::holds_alternative<ConstantLaw>(laws.modulus) &&
         std::holds_alternative<ConstantLaw>(laws.relaxation_time);
}

Elastomer make_at_temperature(const Elastomer& elastomer,
                              const ThermalLaws& laws, const double temperature,
                              const double step)
{
  Elastomer result = elastomer;
  scale(result, extrapolate(laws.modulus, temperature, step),
        compute_factor(laws.relaxation_time, temperature));
  std::visit([&](auto& law) { move_permittivity(law, temperature, step); },
             result.dielectric.permittivity);
  return result;
}

bool is_constant(const HumidityLaws& laws)
{
  return std::holds_alternative<ConstantLaw>(laws.modulus) &&
         std::holds_alternative<ConstantLaw>(laws.relaxation_time) &&
         std::holds_alternative<ConstantLaw>(laws.permittivity);
}

Elastomer make_at_humidity(const Elastomer& elastomer, const HumidityLaws& laws,
                           const double humidity, const double step)
{
  Elastomer result = elastomer;
  scale(result, extrapolate(laws.modulus, humidity, step),
        compute_factor(laws.relaxation_time, humidity));
  const double factor = extrapolate(laws.permittivity, humidity, step);
  std::visit([factor](auto& law) { law = scale(law, factor); },
             result.dielectric.permittivity);
  return result;
}

double compute_thermal_energy(const ThermalLaws& laws, const double density,
                              const double temperature)
{
  return density * laws.heat_capacity *
         (temperature - laws.reference -
          temperature * std::log(temperature / laws.reference));
}
} // namespace taut::material
