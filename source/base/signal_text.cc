#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/base/number_text.h>
#include <taut/base/signal.h>

#include <limits>
#include <map>

namespace taut
{
namespace
{
const char* const allowed_forms =
    "allowed are a number, ramp(rate = 300, start = 0, limit = inf), "
    "sine(offset = 0, amplitude = 5e3, frequency = 10, phase = 0), "
    "steps(0: 0, 1: 2000), table(0: 0, 1: 5000) and "
    "expression(1e3*sin(20*t); kinks = 0.5, 1), numbers in SI units without "
    "the units";

double to_number(const std::string& text, const std::string& what)
{
  double value = 0;
  if (!read_number(text, value))
    throw BadInput(what +
                   " must be a number in SI units without the unit, "
                   "not '" +
                   trim(text) + "'");
  return value;
}

/// The parts of `text` between separators, at least one.
std::vector<std::string> split(const std::string& text, const char separator)
{
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1)
  {
    end = text.find(separator, begin);
    parts.push_back(trim(text.substr(begin, end - begin)));
  }
  return parts;
}

/// An argument of a form; without a default it must be given.
struct Argument
{
  std::string name;
  bool has_default;
  double value;
};

std::size_t find_argument(const std::vector<Argument>& arguments,
                          const std::string& name, const std::string& form)
{
  std::vector<std::string> known;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    if (arguments[i].name == name)
      return i;
    known.push_back(arguments[i].name);
  }
  throw BadInput("'" + form + "' has no argument '" + name + "'; " +
                 suggest(name, known));
}

void require_complete(const std::vector<Argument>& arguments,
                      const std::vector<bool>& given, const std::string& form)
{
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (!given[i] && !arguments[i].has_default)
      throw BadInput("'" + form + "' needs the argument '" + arguments[i].name +
                     "'; " + allowed_forms);
}

/// Fills in the values from "1, 2, name = 3".
void read_arguments(const std::string& text, const std::string& form,
                    std::vector<Argument>& arguments)
{
  std::vector<bool> given(arguments.size(), false);
  bool named_before = false;
  std::size_t position = 0;
  for (const auto& part : split(text, ','))
  {
    const auto equals = part.find('=');
    const bool named = equals != std::string::npos;
    if (!named && (named_before || position >= arguments.size()))
      throw BadInput("'" + part + "' in '" + form +
                     "' is one argument too many or follows a named one; " +
                     allowed_forms);
    const std::size_t i =
        named ? find_argument(arguments, trim(part.substr(0, equals)), form)
              : position++;
    if (given[i])
      throw BadInput("'" + form + "' is given '" + arguments[i].name +
                     "' twice");
    given[i] = true;
    named_before = named;
    arguments[i].value =
        to_number(named ? part.substr(equals + 1) : part, arguments[i].name);
  }
  require_complete(arguments, given, form);
}

Signal parse_constant(const std::string& text)
{
  return Signal::constant(to_number(text, "the value of 'constant'"));
}

Signal parse_ramp(const std::string& text)
{
  std::vector<Argument> arguments = {
      {"rate", false, 0},
      {"start", true, 0},
      {"limit", true, std::numeric_limits<double>::infinity()}};
  read_arguments(text, "ramp", arguments);
  return Signal::ramp(arguments[0].value, arguments[1].value,
                      arguments[2].value);
}

Signal parse_sine(const std::string& text)
{
  std::vector<Argument> arguments = {{"offset", true, 0},
                                     {"amplitude", false, 0},
                                     {"frequency", false, 0},
                                     {"phase", true, 0}};
  read_arguments(text, "sine", arguments);
  return Signal::sine(arguments[0].value, arguments[1].value,
                      arguments[2].value, arguments[3].value);
}

/// Reads "0: 0, 1: 2000".
void read_points(const std::string& text, std::vector<double>& times,
                 std::vector<double>& values)
{
  for (const auto& part : split(text, ','))
  {
    const auto colon = part.find(':');
    if (colon == std::string::npos)
      throw BadInput("'" + part + "' is not a point 'time: value'; " +
                     allowed_forms);
    times.push_back(to_number(part.substr(0, colon), "a time"));
    values.push_back(to_number(part.substr(colon + 1), "a value"));
  }
}

Signal parse_steps(const std::string& text)
{
  std::vector<double> times, values;
  read_points(text, times, values);
  return Signal::steps(times, values);
}

Signal parse_table(const std::string& text)
{
  std::vector<double> times, values;
  read_points(text, times, values);
  return Signal::table(times, values);
}

Signal parse_expression(const std::string& text)
{
  const auto parts = split(text, ';');
  std::vector<double> kinks;
  if (parts.size() == 2)
  {
    const auto sides = split(parts[1], '=');
    if (sides.size() != 2 || sides[0] != "kinks")
      throw BadInput("'" + parts[1] +
                     "' after the formula must read 'kinks = 0.5, 1'");
    for (const auto& kink : split(sides[1], ','))
      kinks.push_back(to_number(kink, "a kink"));
  }
  if (parts.size() > 2)
    throw BadInput("an expression has one formula and one list of kinks; " +
                   std::string(allowed_forms));
  return Signal::expression(parts[0], kinks);
}

using Form = Signal (*)(const std::string&);

Form find_form(const std::string& name, const std::string& text)
{
  static const std::map<std::string, Form> forms = {
      {"constant", parse_constant}, {"ramp", parse_ramp},
      {"sine", parse_sine},         {"steps", parse_steps},
      {"table", parse_table},       {"expression", parse_expression}};
  const auto form = forms.find(name);
  if (form != forms.end())
    return form->second;
  std::vector<std::string> known;
  for (const auto& entry : forms)
    known.push_back(entry.first);
  const std::string nearest = nearest_name(name, known);
  throw BadInput("'" + text + "' is not a signal; " + allowed_forms +
                 (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}
} // namespace

Signal Signal::parse(const std::string& text)
{
  const std::string form = trim(text);
  double number = 0;
  if (read_number(form, number))
    return constant(number);
  const auto open = form.find('(');
  const std::string name = trim(form.substr(0, open));
  const Form parse_form = find_form(name, form);
  if (open == std::string::npos || form.back() != ')')
    throw BadInput("'" + form + "' needs its arguments in brackets; " +
                   allowed_forms);
  return parse_form(form.substr(open + 1, form.size() - open - 2));
}
} // namespace taut
