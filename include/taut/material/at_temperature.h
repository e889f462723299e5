#pragma once

#include <taut/material/elastomer.h>
#include <taut/material/humidity_law.h>
#include <taut/material/temperature_law.h>

namespace taut::material
{
/// Whether moduli and relaxation times are the same at all temperatures.
bool is_constant(const ThermalLaws& laws);

/// Whether nothing depends on the humidity.
bool is_constant(const HumidityLaws& laws);

/// The elastomer at a temperature T (K): moduli of springs and networks and
/// relaxation times multiplied by the factors of their laws. With `step` (K),
/// moduli and permittivity go on along their tangents at T: their energies are
/// linear in them, so that the energy is linear in the step, with the slope
/// dW/dT at T. Fibres and the stresses and
/// strains that activate flow stay as they are. Errors: StepRejected outside
/// the range of a law.
Elastomer make_at_temperature(const Elastomer& elastomer,
                              const ThermalLaws& laws, double temperature,
                              double step = 0.);

/// The elastomer at a relative humidity h, likewise, and its permittivity
/// multiplied by the factor of its law. Errors: StepRejected outside the range
/// of a law.
Elastomer make_at_humidity(const Elastomer& elastomer, const HumidityLaws& laws,
                           double humidity, double step = 0.);

/// rho c_0 ((T - T_0) - T ln(T/T_0)) in J/m^3, the free energy of heat.
double compute_thermal_energy(const ThermalLaws& laws, double density,
                              double temperature);
} // namespace taut::material
