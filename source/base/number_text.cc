#include <taut/base/number_text.h>

#include <charconv>
#include <cmath>
#include <system_error>

namespace taut
{
std::string trim(const std::string& text)
{
  const char* const white = " \t\r\n";
  const auto begin = text.find_first_not_of(white);
  if (begin == std::string::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(white) - begin + 1);
}

bool read_number(const std::string& text, double& value)
{
  const std::string number = trim(text);
  const char* begin = number.data();
  const char* const end = begin + number.size();
  // from_chars knows no plus sign.
  if (number.size() > 1 && number[0] == '+' && number[1] != '-')
    ++begin;
  double result = 0;
  const auto [stop, error] = std::from_chars(begin, end, result);
  if (error != std::errc() || stop != end || std::isnan(result))
    return false;
  value = result;
  return true;
}

std::string number_text(const double value)
{
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return std::string(buffer, result.ptr);
}
} // namespace taut
