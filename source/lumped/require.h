#pragma once

#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>

#include <cmath>
#include <string>

namespace taut::lumped
{
/// Errors: BadInput that says what `range` allows unless `allowed` and finite.
inline void require(const bool allowed, const double value,
                    const std::string& name, const std::string& range)
{
  if (!allowed || !std::isfinite(value))
    throw BadInput("the " + name + " must be " + range + ", got " +
                   number_text(value));
}

inline void require_positive(const double value, const std::string& name)
{
  require(value > 0, value, name, "positive");
}
} // namespace taut::lumped
