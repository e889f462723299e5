#include <taut/base/nearest_name.h>
#include <taut/base/number_text.h>
#include <taut/io/formats.h>

#include <fmt/format.h>

#include <boost/algorithm/string.hpp>

namespace taut::io
{
namespace
{
using material::HumidityStrength;
using material::RateStrength;
using material::StrengthFactor;
using material::StretchStrength;
using material::TemperatureStrength;
using material::ThicknessStrength;
using material::ValidRange;

const char* const allowed_factors =
    "constant, or factors joined by '*': stretch(r; lowest, highest), "
    "thickness(h0, n; lowest, highest), rate(R0, m; lowest, highest), "
    "temperature(a law of temperature), humidity(a law of humidity); stretch "
    "is the root of the area "
    "stretch, h0 in m, R0 in V/(m s)";

[[noreturn]] void refuse_strength(const std::string& text,
                                  const std::string& reason)
{
  throw BadInput(fmt::format("'{}' is no law of the breakdown strength: {}; "
                             "allowed are {}",
                             text, reason, allowed_factors));
}

/// The numbers of a factor: `n_constants`, then a range.
struct Numbers
{
  std::vector<double> constants;
  ValidRange range;
};

std::vector<double> read_list(const std::string& list, const std::size_t n,
                              const std::string& text)
{
  std::vector<double> values;
  try
  {
    values = numbers(any(), "").read(list);
  }
  catch (const BadInput& problem)
  {
    refuse_strength(text, problem.message());
  }
  if (values.size() != n)
    refuse_strength(text, fmt::format("'{}' has {} numbers in place of {}",
                                      list, values.size(), n));
  return values;
}

Numbers read_constants_and_range(const std::string& inner,
                                 const std::size_t n_constants,
                                 const std::string& text)
{
  const std::size_t semicolon = inner.find(';');
  if (semicolon == std::string::npos)
    refuse_strength(text,
                    "a ';' must stand before the range in which it holds");
  const auto range = read_list(inner.substr(semicolon + 1), 2, text);
  return {read_list(inner.substr(0, semicolon), n_constants, text),
          {range[0], range[1]}};
}

StrengthFactor read_stretch(const std::string& inner, const std::string& text)
{
  const Numbers numbers = read_constants_and_range(inner, 1, text);
  return StretchStrength{numbers.constants[0], numbers.range};
}

StrengthFactor read_thickness(const std::string& inner, const std::string& text)
{
  const Numbers numbers = read_constants_and_range(inner, 2, text);
  return ThicknessStrength{numbers.constants[0], numbers.constants[1],
                           numbers.range};
}

StrengthFactor read_rate(const std::string& inner, const std::string& text)
{
  const Numbers numbers = read_constants_and_range(inner, 2, text);
  return RateStrength{numbers.constants[0], numbers.constants[1],
                      numbers.range};
}

StrengthFactor read_temperature(const std::string& inner, const std::string&)
{
  return TemperatureStrength{temperature_law().read(inner)};
}

StrengthFactor read_humidity(const std::string& inner, const std::string&)
{
  return HumidityStrength{humidity_law().read(inner)};
}

StrengthFactor read_factor(const std::string& part, const std::string& text)
{
  using Read = StrengthFactor (*)(const std::string&, const std::string&);
  static const std::vector<std::pair<std::string, Read>> forms = {
      {"stretch", read_stretch},
      {"thickness", read_thickness},
      {"rate", read_rate},
      {"temperature", read_temperature},
      {"humidity", read_humidity}};
  const std::size_t open = part.find('(');
  const std::string name = boost::trim_copy(part.substr(0, open));
  std::vector<std::string> known;
  for (const auto& [word, read] : forms)
  {
    known.push_back(word);
    if (word != name)
      continue;
    if (open == std::string::npos || part.back() != ')')
      refuse_strength(
          text,
          fmt::format("what '{}' depends on must stand in brackets", name));
    return read(part.substr(open + 1, part.size() - open - 2), text);
  }
  refuse_strength(text, fmt::format("the factor '{}' is unknown; {}", name,
                                    suggest(name, known)));
}

std::vector<StrengthFactor> read_factors(const std::string& text)
{
  std::vector<StrengthFactor> factors;
  if (text == "constant")
    return factors;
  std::vector<std::string> parts;
  boost::split(parts, text, [](const char c) { return c == '*'; });
  for (const std::string& part : parts)
    factors.push_back(read_factor(boost::trim_copy(part), text));
  return factors;
}

std::string write_range(const ValidRange& range)
{
  return number_text(range.lowest) + ", " + number_text(range.highest);
}

std::string write_factor(const StretchStrength& law)
{
  return fmt::format("stretch({}; {})", number_text(law.exponent),
                     write_range(law.range));
}

std::string write_factor(const ThicknessStrength& law)
{
  return fmt::format("thickness({}, {}; {})", number_text(law.reference),
                     number_text(law.exponent), write_range(law.range));
}

std::string write_factor(const RateStrength& law)
{
  return fmt::format("rate({}, {}; {})", number_text(law.reference),
                     number_text(law.exponent), write_range(law.bounds));
}

std::string write_factor(const TemperatureStrength& law)
{
  return fmt::format("temperature({})", temperature_law().write(law.law));
}

std::string write_factor(const HumidityStrength& law)
{
  return fmt::format("humidity({})", humidity_law().write(law.law));
}

std::string write_factors(const std::vector<StrengthFactor>& factors)
{
  if (factors.empty())
    return "constant";
  std::vector<std::string> parts;
  for (const StrengthFactor& factor : factors)
    parts.push_back(
        std::visit([](const auto& law) { return write_factor(law); }, factor));
  return boost::algorithm::join(parts, " * ");
}
} // namespace

Format<std::vector<StrengthFactor>> strength_factors()
{
  return {read_factors, write_factors, allowed_factors, ""};
}
} // namespace taut::io
