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
  const double stiffer =
      compute_factor(laws.modulus, temperature) +
      step * compute_factor_derivative(laws.modulus, temperature);
  const double slower = compute_factor(laws.relaxation_time, temperature);
  Elastomer result = elastomer;
  for (Spring& spring : result.springs)
    spring = scale_moduli(spring, stiffer);
  for (Network& network : result.networks)
  {
    network.spring = scale_moduli(network.spring, stiffer);
    network.relaxation_time *= slower;
  }
  std::visit([&](auto& law) { move_permittivity(law, temperature, step); },
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
