#pragma once

#include <string>

namespace taut
{
/// `text` without white space at either end.
std::string trim(const std::string& text);

/// Whether the whole of `text` (white space around it aside) is one number, and
/// then the number in `value`. "inf" and "-inf" are numbers, "nan", "3 kPa" and
/// an empty text are not.
bool read_number(const std::string& text, double& value);

/// The shortest text that reads back as exactly `value`.
std::string number_text(double value);
} // namespace taut
