#pragma once

#include <string>
#include <vector>

namespace taut
{
/// The entry of `known` with the smallest Damerau-Levenshtein distance to
/// `name`, letter case ignored; empty if none comes within half its length.
std::string nearest_name(const std::string& name,
                         const std::vector<std::string>& known);

/// "known are: a, b, c; did you mean 'b'?" for error messages.
std::string suggest(const std::string& name,
                    const std::vector<std::string>& known);
} // namespace taut
