#include <taut/base/exceptions.h>
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
    const std::vector<std::string> parts = split_list(text);
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
  return fmt::format(open ? "between {} and {}" : "from {} to {}", lowest,
                     highest);
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

Range between(const double lowest, const double highest)
{
  return {lowest, highest, true};
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

Format<double> number_or(const Range& range, const std::string& unit,
                         const std::string& otherwise, const double value)
{
  const Format<std::optional<double>> plain =
      optionally(number(range, unit), otherwise);
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
      for (const std::string& part : split_list(text))
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
    for (const std::string& part : split_list(text))
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

} // namespace taut::io
