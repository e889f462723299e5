// The law of docs/adding_a_law.md.
#include <taut/material/spring.h>

#include <docs/adding_a_law/demiray.h>
#include <gtest/gtest.h>

#include "automatic_differentiation.h"

namespace
{
using namespace taut::material;

TEST(DocumentedLaw, DerivativesAgreeWithAutomaticOnes)
{
  const Demiray law{4e4, .05};
  for (const auto& [t, d] :
       {std::pair<double, double>{2.1, .9}, {4., 1.4}, {9., .8}})
  {
    const Invariants<double> x{t, d, 1. / d};
    const EnergyDerivatives<double> W =
        compute_energy_derivatives(compute_derivatives(law, x), x);
    const Second l = make_second(std::log(d), 1);
    const Second energy = compute_energy(
        law, Invariants<Second>{make_second(t, 0), exp(l), exp(-l)});
    // Round-off of numbers of the order of the modulus.
    const double tolerance = 1e-10 * law.shear_modulus;
    EXPECT_NEAR(W.t, energy.dx(0).val(), tolerance);
    EXPECT_NEAR(W.l, energy.dx(1).val(), tolerance);
    EXPECT_NEAR(W.tt, energy.dx(0).dx(0), tolerance);
    EXPECT_NEAR(W.tl, energy.dx(0).dx(1), tolerance);
    EXPECT_NEAR(W.ll, energy.dx(1).dx(1), tolerance);
  }
}

TEST(DocumentedLaw, EnergyAndStressVanishWithoutStrain)
{
  const Demiray law{4e4, .05};
  const Invariants<double> undeformed{2., 1., 1.};
  EXPECT_EQ(compute_energy(law, undeformed), 0.);
  const EnergyDerivatives<double> W = compute_energy_derivatives(
      compute_derivatives(law, undeformed), undeformed);
  EXPECT_EQ(W.t + W.l, 0.);
}
} // namespace
