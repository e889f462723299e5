#pragma once

#include <array>
#include <charconv>
#include <string>

namespace taut::study
{
/// Four significant digits, for sentences.
inline std::string show_number(const double value)
{
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, 4)
                       .ptr;
  return {text.data(), end};
}
} // namespace taut::study
