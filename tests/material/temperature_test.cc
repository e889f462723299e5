#include <taut/base/exceptions.h>
#include <taut/material/at_temperature.h>

#include "rheometer.h"
#include "states.h"

namespace
{
using namespace taut::material;

ThermalLaws make_laws()
{
  ThermalLaws laws;
  laws.modulus = PolynomialLaw{299., {-.005}, 250., 400.};
  laws.relaxation_time = ArrheniusLaw{299., 30e3};
  return laws;
}

TEST(Temperature, EnergyOfEverySpringScalesWithItsModuli)
{
  for (const Spring& spring : make_springs())
  {
    const Invariants<double> invariants =
        compute_invariants(Tensor{4., 1.3, .2});
    EXPECT_DOUBLE_EQ(compute_energy(scale_moduli(spring, .7), invariants),
                     .7 * compute_energy(spring, invariants));
    EXPECT_DOUBLE_EQ(shear_modulus(scale_moduli(spring, .7)),
                     .7 * shear_modulus(spring));
  }
}

TEST(Temperature, StressWithoutFieldScalesAsTheLaw)
{
  const Elastomer elastomer = make_elastomer();
  const ThermalLaws laws = make_laws();
  for (const State& state : make_states(elastomer.networks.size()))
    for (const double temperature : {280., 299., 340.})
    {
      const double factor = 1. - .005 * (temperature - 299.);
      const Field off = {0., temperature};
      const Elastomer warm = make_at_temperature(elastomer, laws, temperature);
      const Tensor S = stress(elastomer, state.C, state.A.data(), off);
      const Tensor S_warm = stress(warm, state.C, state.A.data(), off);
      expect_near(S_warm, {factor * S.xx, factor * S.yy, factor * S.xy},
                  1e-12 * (std::abs(S.xx) + std::abs(S.yy)));
    }
}

TEST(Temperature, NetworksRelaxAtTheirOwnTimes)
{
  // At a fixed stretch what is left depends on t/T alone.
  const Elastomer cold = make_single_network(NeoHookean{2.});
  const ThermalLaws laws = make_laws();
  const double temperature = 330.;
  const double faster = compute_factor(laws.relaxation_time, temperature);
  Program program;
  program.stretch = [](double) { return 2.; };
  const auto run = [&](const Elastomer& elastomer, const double time)
  {
    return Rheometer({elastomer, Shape::uniaxial}, program)
        .run({time})[0]
        .internal[0];
  };
  expect_near(run(make_at_temperature(cold, laws, temperature), .4 * faster),
              run(cold, .4), 1e-10);
}

TEST(Temperature, StepFollowsTheTangentOfTheEnergy)
{
  const Elastomer elastomer = make_elastomer();
  const ThermalLaws laws = make_laws();
  const double T = 320., step = 1e-3;
  const auto compute =
      [&](const State& state, const double at, const double further)
  {
    return energy(make_at_temperature(elastomer, laws, at, further), state.C,
                  state.A.data(), {make_strong_field().nominal_squared, at});
  };
  for (const State& state : make_states(elastomer.networks.size()))
  {
    const double scale = std::abs(compute(state, T, 0.));
    const double tangent =
        (compute(state, T, 1.) - compute(state, T, -1.)) / 2.;
    const double difference =
        (compute(state, T + step, 0.) - compute(state, T - step, 0.)) /
        (2. * step);
    // Rounding over the step of the difference.
    EXPECT_NEAR(tangent, difference, 1e-11 * scale);
    // Linear in the step.
    EXPECT_NEAR(compute(state, T, 5.) - compute(state, T, 0.), 5. * tangent,
                1e-12 * scale);
  }
}

TEST(Temperature, OutsideTheRangeThereIsNoElastomer)
{
  EXPECT_THROW(make_at_temperature(make_elastomer(), make_laws(), 401.),
               taut::StepRejected);
}

TEST(Temperature, LawsAreConstantUnlessOneIsNot)
{
  ThermalLaws laws;
  EXPECT_TRUE(is_constant(laws));
  laws.relaxation_time = ArrheniusLaw{299., 30e3};
  EXPECT_FALSE(is_constant(laws));
  laws = {};
  laws.modulus = PolynomialLaw{299., {-.005}, 250., 400.};
  EXPECT_FALSE(is_constant(laws));
}

TEST(Temperature, ThermalEnergyHasTheHeatCapacityAsItsCurvature)
{
  ThermalLaws laws;
  laws.heat_capacity = 2000.;
  laws.reference = 299.;
  const auto compute = [&](const double temperature)
  { return compute_thermal_energy(laws, 960., temperature); };
  EXPECT_DOUBLE_EQ(compute(299.), 0.);
  // -T d^2 W/dT^2 = rho c_0; differences of energies of 1e6 with a step of 1.
  const double T = 330.;
  EXPECT_NEAR(-T * (compute(T + 1.) - 2. * compute(T) + compute(T - 1.)),
              960. * 2000., 20.);
}
} // namespace
