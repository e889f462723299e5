#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/io/formats.h>

#include <deal.II/base/function_parser.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include <boost/algorithm/string.hpp>
#include <boost/algorithm/string/trim_all.hpp>

namespace taut::io
{
std::vector<std::string> split_list(const std::string& text)
{
  std::vector<std::string> parts;
  boost::split(parts, text, [](char c) { return c == ','; });
  std::transform(parts.begin(), parts.end(), parts.begin(),
                 [](const std::string& part)
                 { return boost::trim_copy(part); });
  return parts;
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
    const std::vector<std::string> parts = split_list(text);
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

Format<std::vector<std::string>> names_or_none(const std::string& what)
{
  const auto plain = optionally(names(what), "none");
  Format<std::vector<std::string>> format;
  format.read = [plain](const std::string& text)
  { return plain.read(text).value_or(std::vector<std::string>()); };
  format.write = [plain](const std::vector<std::string>& values)
  { return values.empty() ? "none" : plain.write(values); };
  format.allowed = plain.allowed;
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
    for (const std::string& part : split_list(text))
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
Format<std::string> formula_of_position(const std::string& unit)
{
  const auto read = [](const std::string& text)
  {
    try
    {
      dealii::FunctionParser<3> parser;
      parser.initialize("x,y,z", text, {{"pi", dealii::numbers::PI}});
      parser.value(dealii::Point<3>());
    }
    catch (const dealii::ExceptionBase& error)
    {
      std::ostringstream reason;
      error.print_info(reason);
      throw BadInput(fmt::format("'{}' is no expression in x, y, z: {}", text,
                                 boost::trim_all_copy(reason.str())));
    }
    return text;
  };
  return {read, [](const std::string& text) { return text; },
          "an expression in x, y, z", unit};
}
} // namespace taut::io
