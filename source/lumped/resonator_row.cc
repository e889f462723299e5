#include <taut/lumped/resonator_row.h>

#include <algorithm>
#include <cmath>

namespace taut::lumped
{
ResonatorRow make_row(const FrozenResonator& frozen, const double time,
                      const double voltage, const double stretch_1a,
                      const double* const internal)
{
  const Resonator& resonator = frozen.get_resonator();
  const auto a = frozen.respond_a(stretch_1a, voltage);
  const auto b = frozen.respond_b(stretch_1a);
  const double area = stretch_1a * resonator.pre_stretch_2;
  ResonatorRow row;
  row.time = time;
  row.voltage = voltage;
  row.stretch_1a = stretch_1a;
  row.stretch_1b = resonator.get_stretch_1b(stretch_1a);
  row.stress_1a = row.force_1a = a.stress_1;
  row.stress_1b = row.force_1b = b.stress_1;
  row.stress_2a = a.stress_2;
  row.stress_2b = b.stress_2;
  row.breakdown_margin = resonator.strength - voltage * area;
  row.frequency = std::sqrt(
      std::max(0., frozen.compute_frequency_squared(stretch_1a, voltage)));
  row.charge = voltage * area * area;
  row.free_energy = frozen.compute_energy(stretch_1a, voltage);
  row.internal.assign(internal, internal + resonator.n_internal());
  return row;
}
} // namespace taut::lumped
