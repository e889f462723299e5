#pragma once

#include <taut/base/exceptions.h>
#include <taut/base/signal.h>
#include <taut/material/breakdown_law.h>
#include <taut/material/humidity_law.h>
#include <taut/material/temperature_law.h>

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// How values of a case file are written as text.
namespace taut::io
{
/// A kind of value: its text form, both ways.
template <class T>
struct Format
{
  /// Errors: BadInput that says what is wrong and what is allowed.
  std::function<T(const std::string&)> read;
  /// read(write(x)) is x.
  std::function<std::string(const T&)> write;
  /// What is allowed, as "a number above 0".
  std::string allowed;
  /// "m", or "dimensionless"; empty if the value is no number.
  std::string unit;
};

/// An interval of admissible numbers; finite numbers only, whatever it is.
struct Range
{
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  /// Whether the ends themselves are excluded.
  bool open = false;

  bool contains(double value) const;
  /// "above 0", "from 0 to 1", "between 0 and 1", "of any size"
  std::string to_text() const;
};

Range any();
/// value > 0
Range positive();
/// value >= 0
Range not_negative();
/// lowest <= value <= highest
Range within(double lowest, double highest);
/// lowest < value < highest
Range between(double lowest, double highest);
/// value > lowest
Range above(double lowest);

/// A number in SI units. Text with a unit behind the number, nan and inf are
/// refused.
Format<double> number(const Range& range, const std::string& unit);
/// Like `number`, or the word `otherwise` that stands for `value`.
Format<double> number_or(const Range& range, const std::string& unit,
                         const std::string& otherwise, double value);
/// Numbers separated by commas.
Format<std::vector<double>> numbers(const Range& range,
                                    const std::string& unit);
Format<std::array<double, 2>> two_numbers(const Range& range,
                                          const std::string& unit);
Format<std::array<double, 3>> three_numbers(const Range& range,
                                            const std::string& unit);
/// `name: value, name: value`
Format<std::map<std::string, double>> named_numbers(const std::string& unit);
Format<unsigned int> count(unsigned int lowest, unsigned int highest);
Format<long> long_count(long lowest);
Format<int> small_count(int lowest, int highest);
/// `true` or `false`
Format<bool> yes_no();
Format<std::string> text(const std::string& allowed);
/// At least one name, separated by commas, none twice.
Format<std::vector<std::string>> names(const std::string& what);
/// "none" is an empty list.
Format<std::vector<std::string>> names_or_none(const std::string& what);
/// A time history, see taut::Signal.
Format<Signal> signal(const std::string& unit);
/// How a property depends on the temperature, see material::TemperatureLaw.
/// Errors of read: BadInput also for factors that are not positive in the law's
/// range.
Format<material::TemperatureLaw> temperature_law();
/// What a breakdown strength depends on, see material::BreakdownLaw.
Format<std::vector<material::StrengthFactor>> strength_factors();
/// How a property depends on the relative humidity, likewise.
Format<material::HumidityLaw> humidity_law();
/// Any of x, y, z separated by commas, or `none`.
Format<std::array<bool, 3>> directions();

/// One of the texts. Errors of read: BadInput with the nearest one.
Format<std::string> one_of(const std::vector<std::string>& texts);

/// One of `words`; the first word of a value is the one written.
/// Errors of read: BadInput with the nearest word.
Format<int> word(const std::vector<std::pair<std::string, int>>& words);

/// A muParser expression in x, y, z and pi, as dealii::FunctionParser reads it,
/// with a value in `unit`.
Format<std::string> formula_of_position(const std::string& unit);

/// The parts of a comma-separated list, without blanks around them.
std::vector<std::string> split_list(const std::string& text);

/// What `format` allows, or the word `otherwise` for none.
template <class T>
Format<std::optional<T>> optionally(const Format<T>& format,
                                    const std::string& otherwise)
{
  Format<std::optional<T>> result;
  result.read = [=](const std::string& text) -> std::optional<T>
  {
    if (text == otherwise)
      return std::nullopt;
    try
    {
      return format.read(text);
    }
    catch (const BadInput& problem)
    {
      throw BadInput(problem.message() + ", or '" + otherwise + "'");
    }
  };
  result.write = [=](const std::optional<T>& value)
  { return value ? format.write(*value) : otherwise; };
  result.allowed = format.allowed + ", or '" + otherwise + "'";
  result.unit = format.unit;
  return result;
}

/// One of `words` that stand for the values of an enumeration.
template <class Enumeration>
Format<Enumeration>
choice(const std::vector<std::pair<std::string, Enumeration>>& words)
{
  std::vector<std::pair<std::string, int>> numbered;
  for (const auto& [name, value] : words)
    numbered.emplace_back(name, static_cast<int>(value));
  const Format<int> plain = word(numbered);
  Format<Enumeration> format;
  format.read = [plain](const std::string& text)
  { return static_cast<Enumeration>(plain.read(text)); };
  format.write = [plain](const Enumeration& value)
  { return plain.write(static_cast<int>(value)); };
  format.allowed = plain.allowed;
  return format;
}
} // namespace taut::io
