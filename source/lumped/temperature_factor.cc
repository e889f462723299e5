#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/base/number_text.h>
#include <taut/lumped/temperature_factor.h>

#include <cmath>

namespace taut::lumped
{
namespace
{
/// R (J/(mol K)).
constexpr double gas_constant = 8.314462618;
constexpr double reference = 299;
/// Between these temperatures ABS stays well below its glass transition.
constexpr double lowest = 260, highest = 365;

struct ComputeFactor
{
  double temperature;

  double operator()(const ConstantFactor&) const
  {
    return 1;
  }
  double operator()(const PolynomialFactor& law) const
  {
    if (!(temperature >= law.lowest && temperature <= law.highest))
      throw BadInput("the temperature must lie between " +
                     number_text(law.lowest) + " K and " +
                     number_text(law.highest) +
                     " K, where the law of a property holds, got " +
                     number_text(temperature) + " K");
    double sum = 0;
    const double distance = temperature - law.reference;
    for (auto c = law.coefficients.rbegin(); c != law.coefficients.rend(); ++c)
      sum = distance * (*c + sum);
    return 1 + sum;
  }
  double operator()(const ArrheniusFactor& law) const
  {
    return std::exp(law.activation_energy / gas_constant *
                    (1 / temperature - 1 / law.reference));
  }
  double operator()(const DipoleFactor& law) const
  {
    return (law.a + law.b / temperature) / (law.a + law.b / law.reference);
  }
};

TemperatureFactor make_linear(const double slope)
{
  return PolynomialFactor{reference, {slope}, lowest, highest};
}
} // namespace

double compute_factor(const TemperatureFactor& law, const double temperature)
{
  if (!(temperature > 0) || !std::isfinite(temperature))
    throw BadInput("the temperature must be positive, got " +
                   number_text(temperature) + " K");
  return std::visit(ComputeFactor{temperature}, law);
}

DemesTemperatureLaws make_temperature_laws(const std::string& name)
{
  DemesTemperatureLaws laws;
  laws.permittivity = DipoleFactor{reference, 2.1, 960};
  laws.source = "permittivity: Wang et al., Sci Rep 14:15411 (2024)";
  if (name == "constant")
    return laws;
  if (name != "softening" && name != "entropic")
    throw BadInput("there are no temperature laws '" + name + "'; " +
                   suggest(name, {"constant", "softening", "entropic"}));
  laws.frame_modulus = make_linear(-0.006);
  laws.relaxation_time = ArrheniusFactor{reference, 30e3};
  const bool softening = name == "softening";
  laws.shear_modulus = make_linear(softening ? -0.005 : 1 / reference);
  laws.source += softening ? "; moduli and relaxation time: chosen by Taut"
                           : "; shear modulus: ideal rubber; frame and "
                             "relaxation time: chosen by Taut";
  return laws;
}
} // namespace taut::lumped
