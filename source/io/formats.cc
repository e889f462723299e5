#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/base/number_text.h>
#include <taut/io/formats.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <regex>

#include <boost/algorithm/string.hpp>

namespace taut::io
{
namespace
{
std::string in_unit(const std::string& unit)
{
  return unit == "dimensionless" ? "here the number is dimensionless"
                                 : "here it is " + unit;
}

/// Refuses `3 kPa`, `0.5mm`, `7 %`.
void refuse_unit(const std::string& text, const std::string& unit)
{
  static const std::regex with_unit("([-+.0-9]+(?:[eE][-+]?[0-9]+)?)\\s*"
                                    "([^-+.,0-9\\s].*)");
  std::smatch parts;
  double value = 0;
  if (!read_number(text, value) && std::regex_match(text, parts, with_unit) &&
      read_number(parts[1], value))
    throw BadInput(
        fmt::format("'{}' carries a unit; numbers stand alone, in SI units: {}",
                    text, in_unit(unit)));
}

double read_checked(const std::string& text, const Range& range,
                    const std::string& unit)
{
  refuse_unit(text, unit);
  double value = 0;
  if (!read_number(text, value) || !std::isfinite(value))
    throw BadInput(fmt::format("'{}' is not a finite number; allowed is a "
                               "number {} ({})",
                               text, range.to_text(), unit));
  if (!range.contains(value))
    throw BadInput(fmt::format("{} is out of range; allowed is a number {} "
                               "({})",
                               text, range.to_text(), unit));
  return value;
}

std::vector<std::string> split(const std::string& text)
{
  std::vector<std::string> parts;
  boost::split(parts, text, [](char c) { return c == ','; });
  std::transform(parts.begin(), parts.end(), parts.begin(),
                 [](const std::string& part)
                 { return boost::trim_copy(part); });
  return parts;
}

template <class Numbers>
std::string write_list(const Numbers& values)
{
  std::vector<std::string> parts;
  for (const double value : values)
    parts.push_back(number_text(value));
  return boost::algorithm::join(parts, ", ");
}

template <std::size_t n>
Format<std::array<double, n>> array_of_numbers(const Range& range,
                                               const std::string& unit)
{
  const std::string allowed =
      fmt::format("{} numbers {}, separated by commas", n, range.to_text());
  Format<std::array<double, n>> format;
  format.read = [=](const std::string& text)
  {
    const std::vector<std::string> parts = split(text);
    if (parts.size() != n)
      throw BadInput(
          fmt::format("'{}' is not of this form: {}", text, allowed));
    std::array<double, n> values;
    for (std::size_t i = 0; i < n; ++i)
      values[i] = read_checked(parts[i], range, unit);
    return values;
  };
  format.write = [](const std::array<double, n>& values)
  { return write_list(values); };
  format.allowed = allowed;
  format.unit = unit;
  return format;
}

template <class Integer>
Format<Integer> whole_number(const Integer lowest, const Integer highest)
{
  const bool bounded = highest < std::numeric_limits<Integer>::max();
  const std::string allowed =
      bounded ? fmt::format("a whole number from {} to {}", lowest, highest)
              : fmt::format("a whole number, {} or more", lowest);
  Format<Integer> format;
  format.read = [=](const std::string& text)
  {
    Integer value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || value < lowest ||
        value > highest)
      throw BadInput(fmt::format("'{}' is not {}", text, allowed));
    return value;
  };
  format.write = [](const Integer& value) { return std::to_string(value); };
  format.allowed = allowed;
  return format;
}
} // namespace

bool Range::contains(const double value) const
{
  return open ? value > lowest && value < highest
              : value >= lowest && value <= highest;
}

std::string Range::to_text() const
{
  if (std::isinf(lowest))
    return "of any size";
  if (std::isinf(highest))
    return open ? fmt::format("above {}", lowest)
                : fmt::format("of {} or more", lowest);
  return fmt::format("from {} to {}", lowest, highest);
}

Range any()
{
  return {};
}

Range positive()
{
  return above(0);
}

Range not_negative()
{
  return {0, std::numeric_limits<double>::infinity(), false};
}

Range within(const double lowest, const double highest)
{
  return {lowest, highest, false};
}

Range above(const double lowest)
{
  return {lowest, std::numeric_limits<double>::infinity(), true};
}

Format<double> number(const Range& range, const std::string& unit)
{
  return {[=](const std::string& text)
          { return read_checked(text, range, unit); },
          number_text, "a number " + range.to_text(), unit};
}

Format<std::optional<double>> optional_number(const Range& range,
                                              const std::string& unit,
                                              const std::string& otherwise)
{
  Format<std::optional<double>> format;
  format.read = [=](const std::string& text) -> std::optional<double>
  {
    if (text == otherwise)
      return std::nullopt;
    return read_checked(text, range, unit);
  };
  format.write = [=](const std::optional<double>& value)
  { return value ? number_text(*value) : otherwise; };
  format.allowed =
      fmt::format("a number {}, or '{}'", range.to_text(), otherwise);
  format.unit = unit;
  return format;
}

Format<double> number_or(const Range& range, const std::string& unit,
                         const std::string& otherwise, const double value)
{
  const Format<std::optional<double>> plain =
      optional_number(range, unit, otherwise);
  return {[=](const std::string& text)
          { return plain.read(text).value_or(value); },
          [=](const double& number)
          { return number == value ? otherwise : plain.write(number); },
          plain.allowed, unit};
}

Format<std::vector<double>> numbers(const Range& range, const std::string& unit)
{
  Format<std::vector<double>> format;
  format.read = [=](const std::string& text)
  {
    std::vector<double> values;
    if (text != "none")
      for (const std::string& part : split(text))
        values.push_back(read_checked(part, range, unit));
    return values;
  };
  format.write = [](const std::vector<double>& values)
  { return values.empty() ? "none" : write_list(values); };
  format.allowed = fmt::format("numbers {}, separated by commas, or 'none'",
                               range.to_text());
  format.unit = unit;
  return format;
}

Format<std::array<double, 2>> two_numbers(const Range& range,
                                          const std::string& unit)
{
  return array_of_numbers<2>(range, unit);
}

Format<std::array<double, 3>> three_numbers(const Range& range,
                                            const std::string& unit)
{
  return array_of_numbers<3>(range, unit);
}

Format<std::map<std::string, double>> named_numbers(const std::string& unit)
{
  const std::string allowed =
      "'name: number' pairs separated by commas, or 'none'";
  Format<std::map<std::string, double>> format;
  format.read = [=](const std::string& text)
  {
    std::map<std::string, double> values;
    if (text == "none")
      return values;
    for (const std::string& part : split(text))
    {
      const std::size_t colon = part.find(':');
      if (colon == std::string::npos || colon == 0)
        throw BadInput(
            fmt::format("'{}' is not of this form: {}", part, allowed));
      const std::string name = boost::trim_copy(part.substr(0, colon));
      const std::string value = boost::trim_copy(part.substr(colon + 1));
      if (!values.emplace(name, read_checked(value, any(), unit)).second)
        throw BadInput(fmt::format("'{}' is given twice", name));
    }
    return values;
  };
  format.write = [](const std::map<std::string, double>& values)
  {
    std::vector<std::string> parts;
    for (const auto& [name, value] : values)
      parts.push_back(fmt::format("{}: {}", name, number_text(value)));
    return parts.empty() ? "none" : boost::algorithm::join(parts, ", ");
  };
  format.allowed = allowed;
  format.unit = unit;
  return format;
}

Format<unsigned int> count(const unsigned int lowest,
                           const unsigned int highest)
{
  return whole_number<unsigned int>(lowest, highest);
}

Format<long> long_count(const long lowest)
{
  return whole_number<long>(lowest, std::numeric_limits<long>::max());
}

Format<int> small_count(const int lowest, const int highest)
{
  return whole_number<int>(lowest, highest);
}

Format<bool> yes_no()
{
  return choice<bool>({{"true", true}, {"false", false}});
}

Format<std::string> text(const std::string& allowed)
{
  const auto same = [](const std::string& value) { return value; };
  return {same, same, allowed, ""};
}

Format<std::vector<std::string>> names(const std::string& what)
{
  Format<std::vector<std::string>> format;
  format.read = [=](const std::string& text)
  {
    const std::vector<std::string> parts = split(text);
    for (auto part = parts.begin(); part != parts.end(); ++part)
    {
      if (part->empty())
        throw BadInput(fmt::format("a name is missing; allowed are {}, "
                                   "separated by commas",
                                   what));
      if (std::find(parts.begin(), part, *part) != part)
        throw BadInput(fmt::format("'{}' is listed twice", *part));
    }
    return parts;
  };
  format.write = [](const std::vector<std::string>& values)
  { return boost::algorithm::join(values, ", "); };
  format.allowed = what + ", separated by commas";
  return format;
}

Format<Signal> signal(const std::string& unit)
{
  Format<Signal> format;
  format.read = [=](const std::string& text)
  {
    refuse_unit(text, unit);
    return Signal::parse(text);
  };
  format.write = [](const Signal& value) { return value.to_text(); };
  format.allowed = "a number, or a history of the time in s: ramp, sine, "
                   "steps, table or expression";
  format.unit = unit;
  return format;
}

Format<std::array<bool, 3>> directions()
{
  const std::vector<std::string> axes = {"x", "y", "z"};
  Format<std::array<bool, 3>> format;
  format.read = [=](const std::string& text)
  {
    std::array<bool, 3> values{{false, false, false}};
    if (text == "none")
      return values;
    for (const std::string& part : split(text))
    {
      const auto axis = std::find(axes.begin(), axes.end(), part);
      if (axis == axes.end())
        throw BadInput(fmt::format("'{}' is no direction; allowed are x, y, z, "
                                   "separated by commas, or none",
                                   part));
      values[axis - axes.begin()] = true;
    }
    return values;
  };
  format.write = [=](const std::array<bool, 3>& values)
  {
    std::vector<std::string> parts;
    for (unsigned int i = 0; i < 3; ++i)
      if (values[i])
        parts.push_back(axes[i]);
    return parts.empty() ? "none" : boost::algorithm::join(parts, ", ");
  };
  format.allowed = "x, y, z, separated by commas, or none";
  return format;
}

Format<std::string> one_of(const std::vector<std::string>& texts)
{
  const auto read = [=](const std::string& text)
  {
    if (std::find(texts.begin(), texts.end(), text) == texts.end())
      throw BadInput(
          fmt::format("'{}' is not allowed; {}", text, suggest(text, texts)));
    return text;
  };
  return {read, [](const std::string& text) { return text; },
          boost::algorithm::join(texts, " | "), ""};
}

Format<int> word(const std::vector<std::pair<std::string, int>>& words)
{
  std::vector<std::string> known;
  for (const auto& entry : words)
    known.push_back(entry.first);
  const Format<std::string> plain = one_of(known);
  Format<int> format;
  format.read = [=](const std::string& text)
  {
    const std::string name = plain.read(text);
    return std::find_if(words.begin(), words.end(),
                        [&name](const auto& entry)
                        { return entry.first == name; })
        ->second;
  };
  format.write = [=](const int& wanted)
  {
    for (const auto& [name, value] : words)
      if (value == wanted)
        return name;
    throw BadInput(fmt::format("no word stands for {}", wanted));
  };
  format.allowed = plain.allowed;
  return format;
}
} // namespace taut::io
