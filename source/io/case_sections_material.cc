#include <taut/base/nearest_name.h>
#include <taut/io/case_sections.h>

namespace taut::io
{
namespace
{
/// A law by the word that selects it; `declare` makes it the content of the
/// variant and declares its constants.
template <class Variant>
struct Law
{
  std::string name;
  void (*declare)(Section& section, Variant& target);
};

const Format<double>& modulus()
{
  static const Format<double> format = number(positive(), "Pa");
  return format;
}

const Format<double>& coefficient()
{
  static const Format<double> format = number(any(), "Pa");
  return format;
}

/// The selector of springs: one line group per law.
const std::vector<Law<material::Spring>>& spring_laws()
{
  using material::Spring;
  static const std::vector<Law<Spring>> laws = {
      {"neo-Hookean",
       [](Section& section, Spring& target)
       {
         auto& law = target.emplace<material::NeoHookean>();
         section.required("Shear modulus", law.shear_modulus, modulus(), "G");
       }},
      {"Mooney-Rivlin",
       [](Section& section, Spring& target)
       {
         auto& law = target.emplace<material::MooneyRivlin>();
         const Format<double> not_below_zero = number(not_negative(), "Pa");
         section.required("First coefficient", law.first_coefficient,
                          not_below_zero, "c1 of c1 (I1 - 3) + c2 (I2 - 3)");
         section.required("Second coefficient", law.second_coefficient,
                          not_below_zero, "c2");
       }},
      {"Gent",
       [](Section& section, Spring& target)
       {
         auto& law = target.emplace<material::Gent>();
         section.required("Shear modulus", law.shear_modulus, modulus(), "G");
         section.required("Limit", law.limit,
                          number(positive(), "dimensionless"),
                          "J_lim, the value of I1 - 3 that is never reached");
       }},
      {"Yeoh",
       [](Section& section, Spring& target)
       {
         auto& law = target.emplace<material::Yeoh>();
         section.required("First coefficient", law.first_coefficient, modulus(),
                          "c1 of c1 x + c2 x^2 + c3 x^3, x = I1 - 3");
         section.required("Second coefficient", law.second_coefficient,
                          coefficient(), "c2");
         section.required("Third coefficient", law.third_coefficient,
                          coefficient(), "c3");
       }},
      {"Arruda-Boyce", [](Section& section, Spring& target)
       {
         auto& law = target.emplace<material::ArrudaBoyce>();
         section.required("Shear modulus", law.shear_modulus, modulus(),
                          "G of long chains; the modulus at small strain is "
                          "larger");
         section.required("Limit stretch", law.limit_stretch,
                          number(above(1), "dimensionless"),
                          "stretch of a chain at full length");
       }}};
  return laws;
}

const std::vector<Law<material::PermittivityLaw>>& permittivity_laws()
{
  using material::PermittivityLaw;
  static const std::vector<Law<PermittivityLaw>> laws = {
      {"constant",
       [](Section& section, PermittivityLaw& target)
       {
         auto& law = target.emplace<material::ConstantPermittivity>();
         law.relative = 1;
         section.optional("Relative permittivity", law.relative,
                          number({1, 1e6}, "dimensionless"), "eps_r");
       }},
      {"stretch-dependent", [](Section& section, PermittivityLaw& target)
       {
         auto& law = target.emplace<material::StretchPermittivity>();
         const Format<double> pure = number(any(), "dimensionless");
         section.optional("High-temperature permittivity", law.high_temperature,
                          number(not_negative(), "dimensionless"),
                          "eps_inf of eps_r = (eps_inf + A/T)(1 + a x + b x^2 "
                          "+ c x^3), x = lambda_1 + lambda_2 - 2");
         section.optional("Dipole constant", law.dipole,
                          number(not_negative(), "K"), "A");
         section.optional("Linear coefficient", law.linear, pure, "a");
         section.optional("Quadratic coefficient", law.quadratic, pure, "b");
         section.optional("Cubic coefficient", law.cubic, pure, "c");
       }}};
  return laws;
}

const std::vector<Law<material::RelaxationLaw>>& relaxation_laws()
{
  using material::RelaxationLaw;
  static const std::vector<Law<RelaxationLaw>> laws = {
      {"constant", [](Section&, RelaxationLaw& target)
       { target.emplace<material::ConstantRelaxation>(); }},
      {"stress-activated",
       [](Section& section, RelaxationLaw& target)
       {
         auto& law = target.emplace<material::StressActivatedRelaxation>();
         section.required("Activation stress", law.activation_stress,
                          number(positive(), "Pa"),
                          "sigma_0 of T = T_0 exp(-tau_e/sigma_0), tau_e the "
                          "equivalent Kirchhoff stress of the network");
       }},
      {"stretch-activated", [](Section& section, RelaxationLaw& target)
       {
         auto& law = target.emplace<material::StretchActivatedRelaxation>();
         section.required("Activation coefficient", law.coefficient,
                          number(not_negative(), "dimensionless"),
                          "k of T = T_0 exp(-k (I1 - 3)), I1 of the network's "
                          "elastic part");
       }}};
  return laws;
}

const std::vector<Law<material::FibreLaw>>& fibre_laws()
{
  using material::FibreLaw;
  static const std::vector<Law<FibreLaw>> laws = {
      {"quadratic",
       [](Section& section, FibreLaw& target)
       {
         auto& law = target.emplace<material::QuadraticFibres>();
         section.required("Stiffness", law.stiffness, modulus(),
                          "k1 of W = k1/2 e^2, e = I4 - 1 without dispersion");
       }},
      {"exponential", [](Section& section, FibreLaw& target)
       {
         auto& law = target.emplace<material::ExponentialFibres>();
         section.required("Stiffness", law.stiffness, modulus(),
                          "k1 of W = k1/(2 k2) (exp(k2 e^2) - 1)");
         section.required("Exponent", law.exponent,
                          number(positive(), "dimensionless"), "k2");
       }}};
  return laws;
}

/// Declares the key that selects a law, and the constants of the selected one.
template <class Variant>
void declare_law(Section& section, const CaseText& text, const std::string& key,
                 const std::vector<Law<Variant>>& laws, std::string& selected,
                 Variant& target, const std::string& meaning)
{
  std::vector<std::string> known;
  for (const Law<Variant>& law : laws)
    known.push_back(law.name);
  const Format<std::string> format = one_of(known);
  if (selected.empty())
    section.required(key, selected, format, meaning);
  else
    section.optional(key, selected, format, meaning);
  const Entry* entry = text.find(section.path(), key);
  const std::string name = entry ? entry->value : selected;
  for (const Law<Variant>& law : laws)
    if (law.name == name)
      return law.declare(section, target);
  text.refuse(section.path(), key,
              name.empty() ? "the law must be given; " + suggest(name, known)
                           : "unknown law; " + suggest(name, known));
}

using material::FlowLaw;

void declare_network(Section& section, const CaseText& text, NamedNetwork& item)
{
  declare_law(section, text, "Law", spring_laws(), item.law,
              item.network.spring, "law of the spring behind the dashpot");
  section.required("Relaxation time", item.network.relaxation_time,
                   number(positive(), "s"),
                   "viscosity at rest over the small-strain modulus of the "
                   "spring");
  declare_law(section, text, "Relaxation law", relaxation_laws(),
              item.relaxation_law, item.network.relaxation,
              "how the relaxation time T, that at rest being T_0, depends on "
              "the state of the network");
  section.optional(
      "Flow", item.network.flow,
      choice<FlowLaw>({{"isotropic", FlowLaw::isotropic},
                       {"held width", FlowLaw::held_width}}),
      "whether every direction flows alike, or only the one along Axis of the "
      "film, as in Eq. 23 of Wang et al. (2024): for films whose width is "
      "held");
}

void declare_fibre_family(Section& section, const CaseText& text,
                          NamedFibreFamily& item)
{
  declare_law(section, text, "Law", fibre_laws(), item.law, item.family.law,
              "energy of the fibres");
  section.optional("Angle", item.angle, number(any(), "rad"),
                   "of the fibres, from Axis of the film, counted towards its "
                   "second material axis");
  section.optional("Tension only", item.family.tension_only, yes_no(),
                   "whether the fibres buckle instead of carrying compression");
  section.optional("Dispersion", item.family.dispersion,
                   number(within(0, 1. / 3.), "dimensionless"),
                   "kappa of e = kappa I1 + (1 - 3 kappa) I4 - 1, from 0 (all "
                   "along Angle) to 1/3 (all directions alike)");
  section.optional("Rest stretch", item.family.rest_stretch,
                   number(positive(), "dimensionless"),
                   "stretch of the film along the fibres at which they are "
                   "unstrained: 1 for fibres that are stretched with the film "
                   "into its frame");
}

void declare_humidity_laws(Section section, material::HumidityLaws& laws)
{
  section.optional("Modulus", laws.modulus, humidity_law(),
                   "factor on all moduli of springs and networks");
  section.optional("Relaxation time", laws.relaxation_time, humidity_law(),
                   "factor on all relaxation times");
  section.optional("Permittivity", laws.permittivity, humidity_law(),
                   "factor on the relative permittivity");
}

void declare_temperature_laws(Section section, material::ThermalLaws& laws)
{
  section.optional("Modulus", laws.modulus, temperature_law(),
                   "factor on all moduli of springs and networks");
  section.optional("Relaxation time", laws.relaxation_time, temperature_law(),
                   "factor on all relaxation times");
  section.optional("Heat capacity", laws.heat_capacity,
                   number(not_negative(), "J/(kg K)"),
                   "c0 of the thermal energy rho c0 ((T - T0) - T ln(T/T0))");
  section.optional("Reference temperature", laws.reference,
                   number(positive(), "K"), "T0 of the thermal energy");
}

void declare_dielectric(Section section, const CaseText& text,
                        MaterialDraft& material)
{
  declare_law(section, text, "Permittivity", permittivity_laws(),
              material.permittivity_law, material.dielectric.permittivity,
              "law of the permittivity");
  section.optional("Breakdown strength",
                   material.dielectric.breakdown.reference,
                   number_or(positive(), "V/m", "none",
                             std::numeric_limits<double>::infinity()),
                   "largest true field that the film stands, where all "
                   "factors of its law are 1");
  section.optional("Breakdown law", material.dielectric.breakdown.factors,
                   strength_factors(),
                   "what multiplies the strength: stretch^r, "
                   "(thickness/h0)^-n with the current thickness, "
                   "(rate/R0)^m with the rate of voltage over undeformed "
                   "thickness kept within the bounds, or a law of the film's "
                   "temperature; outside the range of a law an event of "
                   "breakdown ends the run");
}

void declare_material(Declarations& all, Section& section, const CaseText& text,
                      MaterialDraft& material)
{
  section.required("Density", material.density, number(positive(), "kg/m^3"),
                   "mass per volume");
  declare_list(all, text, section.path(), "Spring",
               "an elastic law; springs of a material stand side by side",
               material.springs,
               [&text](Section& inner, NamedSpring& item)
               {
                 declare_law(inner, text, "Law", spring_laws(), item.law,
                             item.spring, "law of the spring");
               });
  declare_list(all, text, section.path(), "Network",
               "a spring in series with a dashpot, beside the springs",
               material.networks,
               [&text](Section& inner, NamedNetwork& item)
               { declare_network(inner, text, item); });
  declare_list(all, text, section.path(), "Fibre family",
               "fibres of one direction in the film's plane",
               material.fibre_families,
               [&text](Section& inner, NamedFibreFamily& item)
               { declare_fibre_family(inner, text, item); });
  SectionPath dielectric = section.path();
  dielectric.push_back("Dielectric");
  all.allow_section(section.path(), "Dielectric", false);
  declare_dielectric(all.section(dielectric, "the electrical part"), text,
                     material);
  SectionPath temperature = section.path();
  temperature.push_back("Temperature laws");
  all.allow_section(section.path(), "Temperature laws", false);
  declare_temperature_laws(
      all.section(temperature, "how the properties, which hold at the "
                               "references of the laws, follow the temperature "
                               "of the film"),
      material.thermal);
  SectionPath humidity = section.path();
  humidity.push_back("Humidity laws");
  all.allow_section(section.path(), "Humidity laws", false);
  declare_humidity_laws(
      all.section(humidity, "how the properties, which hold at the references "
                            "of the laws, follow the relative humidity"),
      material.humidity_laws);
}
} // namespace

void declare_materials(Declarations& all, const CaseText& text,
                       std::vector<MaterialDraft>& materials)
{
  declare_list(all, text, {}, "Material",
               "what films are made of: springs, viscous networks and a "
               "dielectric; films refer to it by its name",
               materials,
               [&](Section& section, MaterialDraft& material)
               { declare_material(all, section, text, material); });
}
} // namespace taut::io
