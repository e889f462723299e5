#include <taut/lumped/resonator_si.h>

#include <cmath>
#include <numeric>

#include "require.h"

namespace taut::lumped
{
namespace
{
void validate(const ResonatorSI& device)
{
  require_positive(device.length_a, "length of strip A");
  require_positive(device.length_b, "length of strip B");
  require_positive(device.width, "width");
  require_positive(device.thickness, "thickness");
  require_positive(device.equilibrium_modulus,
                   "shear modulus of the ground network");
  for (const double modulus : device.network_moduli)
    require_positive(modulus, "shear modulus of a network");
  require(device.density >= 0, device.density, "density", "zero or positive");
  require(device.bar_mass >= 0, device.bar_mass, "mass of the bar",
          "zero or positive");
  require(device.relative_permittivity >= 1, device.relative_permittivity,
          "relative permittivity", "at least 1");
  require_positive(device.breakdown_field, "breakdown field");
}

double get_total_modulus(const ResonatorSI& device)
{
  return std::accumulate(device.network_moduli.begin(),
                         device.network_moduli.end(),
                         device.equilibrium_modulus);
}
} // namespace

Resonator make_resonator(const ResonatorSI& device)
{
  validate(device);
  const double modulus = get_total_modulus(device);
  const double permittivity =
      device.relative_permittivity * vacuum_permittivity;
  Resonator resonator;
  resonator.length_ratio = device.length_a / device.length_b;
  resonator.equilibrium_fraction = device.equilibrium_modulus / modulus;
  resonator.gent_limit = device.gent_limit;
  resonator.networks =
      make_networks(resonator.equilibrium_fraction, device.network_moduli,
                    device.network_taus, device.tau_meaning);
  resonator.pre_stretch_1 = device.pre_stretch_1;
  resonator.pre_stretch_2 = device.pre_stretch_2;
  resonator.strength =
      device.breakdown_field * std::sqrt(permittivity / modulus);
  const double third = device.density / (3 * modulus);
  resonator.inertia_a = third * device.length_a * device.length_a;
  resonator.inertia_b = third * device.length_b * device.length_b;
  resonator.inertia_bar = device.bar_mass * device.length_a /
                          (modulus * device.width * device.thickness);
  resonator.voltage = device.voltage;
  resonator.voltage_unit = device.thickness * std::sqrt(modulus / permittivity);
  validate(resonator);
  return resonator;
}

ResonatorScales make_scales(const ResonatorSI& device)
{
  const Resonator resonator = make_resonator(device);
  const double modulus = get_total_modulus(device);
  ResonatorScales scales;
  scales.stress = modulus;
  scales.voltage = resonator.voltage_unit;
  scales.force_1 = modulus * device.width * device.thickness;
  scales.force_2a = modulus * device.length_a * device.thickness;
  scales.force_2b = modulus * device.length_b * device.thickness;
  scales.energy = scales.force_1 * device.length_a;
  scales.charge = scales.energy / scales.voltage;
  scales.angular_frequency = std::sqrt(resonator.get_alpha());
  return scales;
}
} // namespace taut::lumped
