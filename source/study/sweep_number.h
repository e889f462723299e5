#pragma once

#include <fmt/format.h>

#include <string>

namespace taut::study
{
/// 15 significant digits: those beyond are noise of the arithmetic.
inline std::string make_number_text(const double value)
{
  return fmt::format("{:.15g}", value);
}
} // namespace taut::study
