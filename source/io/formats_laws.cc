#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/base/number_text.h>
#include <taut/io/formats.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <boost/algorithm/string.hpp>

namespace taut::io
{
namespace
{
using material::ArrheniusLaw;
using material::ConstantLaw;
using material::PolynomialLaw;
using material::TableLaw;
using material::TemperatureLaw;

const char* const allowed_laws =
    "constant, polynomial(reference, lowest, highest; c1, c2), table(T1: f1, "
    "T2: f2), arrhenius(reference, activation energy), or a named law: "
    "wang_2024_modulus, wang_2024_relaxation, wang_2024_frame_modulus (for the "
    "device of Wang et al., Sci Rep 14:15411, 2024; the numbers are this "
    "project's choice, the paper states none); temperatures in K, ci in 1/K^i, "
    "energy in J/mol";

/// Laws by name. The numbers were chosen such that the statements of the paper
/// on the temperature hold.
const std::vector<std::pair<std::string, TemperatureLaw>>& named_laws()
{
  static const std::vector<std::pair<std::string, TemperatureLaw>> laws = {
      {"constant", ConstantLaw{}},
      {"wang_2024_modulus", PolynomialLaw{299, {-.005}, 273, 373}},
      {"wang_2024_relaxation", ArrheniusLaw{299, 30e3}},
      // ABS softens from 88 C on.
      {"wang_2024_frame_modulus", PolynomialLaw{299, {-.006}, 273, 361}}};
  return laws;
}

[[noreturn]] void refuse(const std::string& text, const std::string& reason)
{
  throw BadInput(fmt::format("'{}' is no law of temperature: {}; allowed are "
                             "{}",
                             text, reason, allowed_laws));
}

double read_one(const std::string& part, const std::string& text)
{
  double value = 0;
  if (!read_number(part, value) || !std::isfinite(value))
    refuse(text, fmt::format("'{}' is not a finite number", part));
  return value;
}

std::vector<double> read_numbers(const std::string& list,
                                 const std::string& text)
{
  std::vector<double> values;
  for (const std::string& part : split_list(list))
    values.push_back(read_one(part, text));
  return values;
}

void require(const bool fulfilled, const std::string& text,
             const std::string& reason)
{
  if (!fulfilled)
    refuse(text, reason);
}

/// A factor that vanishes leaves a film without stiffness.
void require_positive_factor(const PolynomialLaw& law, const std::string& text)
{
  constexpr unsigned int samples = 200;
  for (unsigned int i = 0; i <= samples; ++i)
  {
    const double temperature =
        law.lowest + (law.highest - law.lowest) * i / samples;
    const double factor = material::compute_factor(law, temperature);
    require(factor > 0, text,
            fmt::format("its factor is {:.4g} at {:.6g} K, but must be "
                        "positive in all of its range",
                        factor, temperature));
  }
}

TemperatureLaw read_polynomial(const std::string& inner,
                               const std::string& text)
{
  const std::size_t semicolon = inner.find(';');
  require(semicolon != std::string::npos, text,
          "a ';' must stand before the coefficients");
  const auto range = read_numbers(inner.substr(0, semicolon), text);
  require(range.size() == 3, text,
          "three temperatures must stand before the ';'");
  const PolynomialLaw law{range[0],
                          read_numbers(inner.substr(semicolon + 1), text),
                          range[1], range[2]};
  require(law.lowest > 0 && law.lowest < law.highest, text,
          "its range must run upwards from a temperature above 0 K");
  require_positive_factor(law, text);
  return law;
}

TemperatureLaw read_table(const std::string& inner, const std::string& text)
{
  TableLaw law;
  for (const std::string& row : split_list(inner))
  {
    const std::size_t colon = row.find(':');
    require(colon != std::string::npos, text,
            fmt::format("'{}' is not a row 'temperature: factor'", row));
    law.temperatures.push_back(read_one(row.substr(0, colon), text));
    law.factors.push_back(read_one(row.substr(colon + 1), text));
  }
  require(law.temperatures.size() > 1, text, "a table needs two rows or more");
  require(law.temperatures[0] > 0 &&
              std::adjacent_find(
                  law.temperatures.begin(), law.temperatures.end(),
                  std::greater_equal<double>()) == law.temperatures.end(),
          text, "its temperatures must increase from above 0 K");
  for (const double factor : law.factors)
    require(factor > 0, text, "its factors must be positive");
  return law;
}

TemperatureLaw read_arrhenius(const std::string& inner, const std::string& text)
{
  const auto values = read_numbers(inner, text);
  require(values.size() == 2 && values[0] > 0, text,
          "it needs a reference temperature above 0 K and an activation "
          "energy");
  return ArrheniusLaw{values[0], values[1]};
}

TemperatureLaw read_law(const std::string& text)
{
  using Read = TemperatureLaw (*)(const std::string&, const std::string&);
  static const std::vector<std::pair<std::string, Read>> forms = {
      {"polynomial", read_polynomial},
      {"table", read_table},
      {"arrhenius", read_arrhenius}};
  const std::size_t open = text.find('(');
  const std::string name = boost::trim_copy(text.substr(0, open));
  std::vector<std::string> known;
  for (const auto& [word, law] : named_laws())
  {
    if (word == name && open == std::string::npos)
      return law;
    known.push_back(word);
  }
  for (const auto& [word, read] : forms)
  {
    known.push_back(word);
    if (word != name)
      continue;
    require(open != std::string::npos && text.back() == ')', text,
            "its numbers must stand in brackets");
    return read(text.substr(open + 1, text.size() - open - 2), text);
  }
  refuse(text, fmt::format("the law '{}' is unknown; {}", name,
                           suggest(name, known)));
}

std::string write_list(const std::vector<double>& values)
{
  std::vector<std::string> parts;
  for (const double value : values)
    parts.push_back(number_text(value));
  return boost::algorithm::join(parts, ", ");
}

std::string write_law(const ConstantLaw&)
{
  return "constant";
}

std::string write_law(const PolynomialLaw& law)
{
  return fmt::format("polynomial({}; {})",
                     write_list({law.reference, law.lowest, law.highest}),
                     write_list(law.coefficients));
}

std::string write_law(const TableLaw& law)
{
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < law.factors.size(); ++i)
    rows.push_back(fmt::format("{}: {}", number_text(law.temperatures[i]),
                               number_text(law.factors[i])));
  return fmt::format("table({})", boost::algorithm::join(rows, ", "));
}

std::string write_law(const ArrheniusLaw& law)
{
  return fmt::format("arrhenius({})",
                     write_list({law.reference, law.activation_energy}));
}
} // namespace

Format<TemperatureLaw> temperature_law()
{
  return {[](const std::string& text) { return read_law(text); },
          [](const TemperatureLaw& law) {
            return std::visit([](const auto& one) { return write_law(one); },
                              law);
          },
          allowed_laws, ""};
}
} // namespace taut::io
