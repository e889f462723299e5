#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/base/number_text.h>
#include <taut/io/formats.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/algorithm/string.hpp>

namespace taut::io
{
namespace
{
using material::ArrheniusLaw;
using material::ConstantLaw;
using material::ExponentialLaw;
using material::HumidityLaw;
using material::PolynomialLaw;
using material::TableLaw;
using material::TemperatureLaw;

/// A text that stands for a law, and the scalar that the law is of.
struct LawText
{
  std::string text;
  std::string scalar;  ///< "temperature"
  std::string allowed; ///< texts
  /// A phrase for the interval, and the interval; open below.
  std::string interval;
  double lowest, highest;
};

const char* const allowed_temperature_laws =
    "constant, polynomial(reference, lowest, highest; c1, c2), table(T1: f1, "
    "T2: f2), arrhenius(reference, activation energy), or a named law: "
    "wang_2024_modulus, wang_2024_relaxation, wang_2024_frame_modulus (for the "
    "device of Wang et al., Sci Rep 14:15411, 2024; the numbers are this "
    "project's choice, the paper states none); temperatures in K, ci in 1/K^i, "
    "energy in J/mol";

const char* const allowed_humidity_laws =
    "constant, polynomial(reference, lowest, highest; c1, c2), table(h1: f1, "
    "h2: f2) or exponential(reference, k), which is exp(k (h - reference)); "
    "relative humidities h from 0 to 1";

LawText make_temperature_text(const std::string& text)
{
  return {text,
          "temperature",
          allowed_temperature_laws,
          "above 0 K",
          std::numeric_limits<double>::min(),
          std::numeric_limits<double>::max()};
}

LawText make_humidity_text(const std::string& text)
{
  return {text, "humidity", allowed_humidity_laws, "from 0 to 1", 0, 1};
}

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

[[noreturn]] void refuse(const LawText& law, const std::string& reason)
{
  throw BadInput(fmt::format("'{}' is no law of {}: {}; allowed are {}",
                             law.text, law.scalar, reason, law.allowed));
}

double read_one(const std::string& part, const LawText& text)
{
  double value = 0;
  if (!read_number(part, value) || !std::isfinite(value))
    refuse(text, fmt::format("'{}' is not a finite number", part));
  return value;
}

std::vector<double> read_numbers(const std::string& list, const LawText& text)
{
  std::vector<double> values;
  for (const std::string& part : split_list(list))
    values.push_back(read_one(part, text));
  return values;
}

void require(const bool fulfilled, const LawText& text,
             const std::string& reason)
{
  if (!fulfilled)
    refuse(text, reason);
}

void require_inside(const double lowest, const double highest,
                    const LawText& text, const std::string& what)
{
  require(lowest >= text.lowest && highest <= text.highest, text,
          fmt::format("{} must lie {}", what, text.interval));
}

/// A factor that vanishes leaves a film without stiffness.
void require_positive_factor(const PolynomialLaw& law, const LawText& text)
{
  constexpr unsigned int samples = 200;
  for (unsigned int i = 0; i <= samples; ++i)
  {
    const double argument =
        law.lowest + (law.highest - law.lowest) * i / samples;
    const double factor = material::compute(law, argument).value;
    require(factor > 0, text,
            fmt::format("its factor is {:.4g} at {:.6g}, but must be positive "
                        "in all of its range",
                        factor, argument));
  }
}

PolynomialLaw read_polynomial(const std::string& inner, const LawText& text)
{
  const std::size_t semicolon = inner.find(';');
  require(semicolon != std::string::npos, text,
          "a ';' must stand before the coefficients");
  const auto range = read_numbers(inner.substr(0, semicolon), text);
  require(range.size() == 3, text,
          fmt::format("three values of the {} must stand before the ';'",
                      text.scalar));
  const PolynomialLaw law{range[0],
                          read_numbers(inner.substr(semicolon + 1), text),
                          range[1], range[2]};
  require(law.lowest < law.highest, text, "its range must run upwards");
  require_inside(law.lowest, law.highest, text, "its range");
  require_positive_factor(law, text);
  return law;
}

TableLaw read_table(const std::string& inner, const LawText& text)
{
  TableLaw law;
  for (const std::string& row : split_list(inner))
  {
    const std::size_t colon = row.find(':');
    require(colon != std::string::npos, text,
            fmt::format("'{}' is not a row '{}: factor'", row, text.scalar));
    law.arguments.push_back(read_one(row.substr(0, colon), text));
    law.factors.push_back(read_one(row.substr(colon + 1), text));
  }
  require(law.arguments.size() > 1, text, "a table needs two rows or more");
  require(std::adjacent_find(law.arguments.begin(), law.arguments.end(),
                             std::greater_equal<double>()) ==
              law.arguments.end(),
          text, fmt::format("its {} must increase", text.scalar));
  require_inside(law.arguments.front(), law.arguments.back(), text,
                 fmt::format("its {}", text.scalar));
  for (const double factor : law.factors)
    require(factor > 0, text, "its factors must be positive");
  return law;
}

ArrheniusLaw read_arrhenius(const std::string& inner, const LawText& text)
{
  const auto values = read_numbers(inner, text);
  require(values.size() == 2 && values[0] > 0, text,
          "it needs a reference temperature above 0 K and an activation "
          "energy");
  return {values[0], values[1]};
}

ExponentialLaw read_exponential(const std::string& inner, const LawText& text)
{
  const auto values = read_numbers(inner, text);
  require(values.size() == 2, text, "it needs a reference and a coefficient");
  require_inside(values[0], values[0], text, "its reference");
  return {values[0], values[1]};
}

/// A law by the word before its brackets.
template <class Law>
using Forms = std::vector<
    std::pair<std::string, Law (*)(const std::string&, const LawText&)>>;

/// Makes a reader of one law a reader of the variant.
template <class Law, auto read>
Law read_as(const std::string& inner, const LawText& text)
{
  return read(inner, text);
}

template <class Law>
Law read_law(const LawText& law, const Forms<Law>& forms,
             const std::vector<std::pair<std::string, Law>>& named)
{
  const std::string& text = law.text;
  const std::size_t open = text.find('(');
  const std::string name = boost::trim_copy(text.substr(0, open));
  std::vector<std::string> known;
  for (const auto& [word, content] : named)
  {
    if (word == name && open == std::string::npos)
      return content;
    known.push_back(word);
  }
  for (const auto& [word, read] : forms)
  {
    known.push_back(word);
    if (word != name)
      continue;
    require(open != std::string::npos && text.back() == ')', law,
            "its numbers must stand in brackets");
    return read(text.substr(open + 1, text.size() - open - 2), law);
  }
  refuse(law, fmt::format("the law '{}' is unknown; {}", name,
                          suggest(name, known)));
}

TemperatureLaw read_temperature_law(const std::string& text)
{
  static const Forms<TemperatureLaw> forms = {
      {"polynomial", read_as<TemperatureLaw, read_polynomial>},
      {"table", read_as<TemperatureLaw, read_table>},
      {"arrhenius", read_as<TemperatureLaw, read_arrhenius>}};
  return read_law(make_temperature_text(text), forms, named_laws());
}

HumidityLaw read_humidity_law(const std::string& text)
{
  static const Forms<HumidityLaw> forms = {
      {"polynomial", read_as<HumidityLaw, read_polynomial>},
      {"table", read_as<HumidityLaw, read_table>},
      {"exponential", read_as<HumidityLaw, read_exponential>}};
  return read_law(make_humidity_text(text), forms,
                  {{"constant", ConstantLaw{}}});
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
    rows.push_back(fmt::format("{}: {}", number_text(law.arguments[i]),
                               number_text(law.factors[i])));
  return fmt::format("table({})", boost::algorithm::join(rows, ", "));
}

std::string write_law(const ArrheniusLaw& law)
{
  return fmt::format("arrhenius({})",
                     write_list({law.reference, law.activation_energy}));
}

std::string write_law(const ExponentialLaw& law)
{
  return fmt::format("exponential({})",
                     write_list({law.reference, law.coefficient}));
}

template <class Law>
std::string write_any(const Law& law)
{
  return std::visit([](const auto& one) { return write_law(one); }, law);
}
} // namespace

Format<TemperatureLaw> temperature_law()
{
  return {read_temperature_law, write_any<TemperatureLaw>,
          allowed_temperature_laws, ""};
}

Format<HumidityLaw> humidity_law()
{
  return {read_humidity_law, write_any<HumidityLaw>, allowed_humidity_laws, ""};
}
} // namespace taut::io
