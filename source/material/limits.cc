#include <taut/material/limits.h>

#include <optional>
#include <sstream>

namespace taut::material
{
namespace
{
template <class Law>
std::string get_name(const Law&)
{
  return "";
}

std::string get_name(const Gent&)
{
  return "Gent ";
}

std::string get_name(const ArrudaBoyce&)
{
  return "Arruda-Boyce ";
}

std::string get_name(const Spring& spring)
{
  return std::visit([](const auto& law) { return get_name(law); }, spring);
}

std::string write(const double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

/// What follows the name of a quantity.
std::string compare(const double value, const double limit)
{
  if (std::isnan(value))
    return " is not a number, beyond the limit " + write(limit);
  return " = " + write(value) + " is beyond the limit " + write(limit);
}

std::string describe(const Elastomer& elastomer,
                     const LimitedQuantity<double>& limited)
{
  const std::string number = std::to_string(limited.index + 1);
  const std::string beyond = compare(limited.value, limited.limit);
  switch (limited.law)
  {
  case LimitedLaw::spring:
    return "I1" + beyond + " of the " +
           get_name(elastomer.springs[limited.index]) + "spring " + number;
  case LimitedLaw::network_spring:
    return "I1" + beyond + " of the " +
           get_name(elastomer.networks[limited.index].spring) +
           "spring of network " + number;
  case LimitedLaw::fibre_family:
    return "the exponent k2 e^2" + beyond + " of fibre family " + number;
  case LimitedLaw::relaxation_time:
    return "ln(T_0/T)" + beyond + " of the relaxation law of network " + number;
  case LimitedLaw::permittivity:
    break;
  }
  return "the permittivity, multiplied by " + write(-limited.value) +
         " by the stretches, is not positive";
}
} // namespace

std::string describe_limit(const Elastomer& elastomer,
                           const SymmetricTensor2<double>& C,
                           InternalVariables<double> A, const Field& field)
{
  std::optional<LimitedQuantity<double>> worst;
  const auto visit = [&worst](const LimitedQuantity<double>& limited)
  {
    if (!(compute_margin(limited) > 0.) &&
        !(worst && compute_margin(limited) >= compute_margin(*worst)))
      worst = limited;
  };
  visit_energy_limits<double>(elastomer, C, A, field, visit);
  visit_flow_limits<double>(elastomer, C, A, visit);
  return worst ? describe(elastomer, *worst) : "";
}
} // namespace taut::material
