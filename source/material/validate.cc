#include <taut/base/exceptions.h>
#include <taut/material/validate.h>

#include <cmath>
#include <sstream>
#include <string>

namespace taut::material
{
namespace
{
/// Comparisons are written such that a value that is not a number is refused.
void require(bool fulfilled, const std::string& where,
             const std::string& quantity, double value,
             const std::string& allowed)
{
  if (fulfilled)
    return;
  std::ostringstream message;
  message << where << ": the " << quantity << " is " << value << ", it must be "
          << allowed;
  throw BadInput(message.str());
}

void require_positive(const std::string& where, const std::string& quantity,
                      double value)
{
  require(value > 0. && std::isfinite(value), where, quantity, value,
          "positive and finite");
}

void require_not_negative(const std::string& where, const std::string& quantity,
                          double value)
{
  require(value >= 0. && std::isfinite(value), where, quantity, value,
          "0 or more and finite");
}

void require_finite(const std::string& where, const std::string& quantity,
                    double value)
{
  require(std::isfinite(value), where, quantity, value, "finite");
}

void validate(const NeoHookean& spring, const std::string& where)
{
  require_positive(where, "shear modulus (Pa)", spring.shear_modulus);
}

void validate(const MooneyRivlin& spring, const std::string& where)
{
  require_not_negative(where, "first coefficient (Pa)",
                       spring.first_coefficient);
  require_not_negative(where, "second coefficient (Pa)",
                       spring.second_coefficient);
  require_positive(where, "shear modulus (Pa)", shear_modulus(spring));
}

void validate(const Gent& spring, const std::string& where)
{
  require_positive(where, "shear modulus (Pa)", spring.shear_modulus);
  require_positive(where, "limit J_lim", spring.limit);
}

void validate(const Yeoh& spring, const std::string& where)
{
  require_positive(where, "first coefficient (Pa)", spring.first_coefficient);
  require_finite(where, "second coefficient (Pa)", spring.second_coefficient);
  require_finite(where, "third coefficient (Pa)", spring.third_coefficient);
}

void validate(const ArrudaBoyce& spring, const std::string& where)
{
  require_positive(where, "shear modulus (Pa)", spring.shear_modulus);
  require(spring.limit_stretch > 1. && std::isfinite(spring.limit_stretch),
          where, "limit stretch", spring.limit_stretch,
          "larger than 1 and finite");
}

void validate(const Spring& spring, const std::string& where)
{
  std::visit([&](const auto& law) { validate(law, where); }, spring);
}

void validate(const ConstantRelaxation&, const std::string&) {}

void validate(const StressActivatedRelaxation& law, const std::string& where)
{
  require_positive(where, "activation stress (Pa)", law.activation_stress);
}

void validate(const StretchActivatedRelaxation& law, const std::string& where)
{
  require_not_negative(where, "coefficient of the relaxation law",
                       law.coefficient);
}

void validate(const Network& network, const std::string& where)
{
  validate(network.spring, where);
  require_positive(where, "relaxation time (s)", network.relaxation_time);
  std::visit([&](const auto& law) { validate(law, where); },
             network.relaxation);
  if (network.flow == FlowLaw::held_width && !is_constant(network.relaxation))
    throw BadInput(where + ": the relaxation time of a network that flows at a "
                           "held width is constant");
}

void validate(const QuadraticFibres& law, const std::string& where)
{
  require_positive(where, "stiffness k1 (Pa)", law.stiffness);
}

void validate(const ExponentialFibres& law, const std::string& where)
{
  require_positive(where, "stiffness k1 (Pa)", law.stiffness);
  require_positive(where, "exponent k2", law.exponent);
}

void validate(const FibreFamily& family, const std::string& where)
{
  std::visit([&](const auto& law) { validate(law, where); }, family.law);
  const double length = std::hypot(family.direction[0], family.direction[1]);
  require(std::abs(length - 1.) < 1e-12, where, "length of the direction",
          length, "1");
  require(family.dispersion >= 0. && family.dispersion <= 1. / 3., where,
          "dispersion", family.dispersion, "from 0 to 1/3");
  require_positive(where, "rest stretch", family.rest_stretch);
  require(family.dispersion == 0. || family.rest_stretch == 1., where,
          "rest stretch", family.rest_stretch, "1 if the fibres are dispersed");
}

void validate(const ConstantPermittivity& law)
{
  require(law.relative >= 1. && std::isfinite(law.relative), "dielectric",
          "relative permittivity", law.relative,
          "1 (vacuum) or more and finite");
}

void validate(const StretchPermittivity& law)
{
  const std::string where = "dielectric";
  require_not_negative(where, "permittivity at high temperature",
                       law.high_temperature);
  require_not_negative(where, "dipole coefficient (K)", law.dipole);
  require_positive(where, "sum of permittivity and dipole coefficient",
                   law.high_temperature + law.dipole);
  require_finite(where, "linear stretch coefficient", law.linear);
  require_finite(where, "quadratic stretch coefficient", law.quadratic);
  require_finite(where, "cubic stretch coefficient", law.cubic);
}

const std::string strength = "law of the breakdown strength";

void validate(const ValidRange& range, const std::string& quantity)
{
  require_not_negative(strength, "lowest " + quantity, range.lowest);
  require(range.highest > range.lowest, strength, "highest " + quantity,
          range.highest, "above the lowest");
}

void validate(const StretchStrength& law)
{
  require_finite(strength, "exponent of the stretch", law.exponent);
  validate(law.range, "stretch");
}

void validate(const ThicknessStrength& law)
{
  require_positive(strength, "reference thickness (m)", law.reference);
  require_finite(strength, "exponent of the thickness", law.exponent);
  validate(law.range, "thickness (m)");
}

/// Their numbers were checked when they were read.
void validate(const TemperatureStrength&) {}
void validate(const HumidityStrength&) {}

void validate(const RateStrength& law)
{
  require_positive(strength, "reference rate (V/(m s))", law.reference);
  require_finite(strength, "exponent of the rate", law.exponent);
  require_positive(strength, "lowest rate (V/(m s))", law.bounds.lowest);
  validate(law.bounds, "rate (V/(m s))");
}

void validate(const Dielectric& dielectric)
{
  std::visit([](const auto& law) { validate(law); }, dielectric.permittivity);
  require(dielectric.breakdown.reference > 0., "dielectric",
          "breakdown strength (V/m)", dielectric.breakdown.reference,
          "positive (infinity for none)");
  for (const StrengthFactor& factor : dielectric.breakdown.factors)
    std::visit([](const auto& law) { validate(law); }, factor);
}
} // namespace

void validate(const Elastomer& elastomer)
{
  if (elastomer.springs.empty() && elastomer.networks.empty())
    throw BadInput("the elastomer has neither a spring nor a network, it needs "
                   "at least one");
  require_not_negative("elastomer", "density (kg/m^3)", elastomer.density);
  unsigned int number = 0;
  for (const Spring& spring : elastomer.springs)
    validate(spring, "spring " + std::to_string(++number));
  number = 0;
  for (const Network& network : elastomer.networks)
    validate(network, "network " + std::to_string(++number));
  number = 0;
  for (const FibreFamily& family : elastomer.fibres)
    validate(family, "fibre family " + std::to_string(++number));
  validate(elastomer.dielectric);
}
} // namespace taut::material
