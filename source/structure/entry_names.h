#pragma once

#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/structure/description.h>

#include <algorithm>

namespace taut::structure
{
template <typename Entry>
std::vector<std::string> get_names(const std::vector<Entry>& entries)
{
  std::vector<std::string> names;
  for (const auto& entry : entries)
    names.push_back(entry.name);
  return names;
}

/// The index of what an event is of. Errors: BadInput with the nearest name.
inline std::size_t find_name(const EventDescription& event,
                             const std::string& what,
                             const std::vector<std::string>& names)
{
  const auto found = std::find(names.begin(), names.end(), event.of);
  if (found == names.end())
    throw BadInput("there is no " + what + " '" + event.of + "'; " +
                       suggest(event.of, names),
                   "", event.source_line, "Event " + event.name);
  return found - names.begin();
}
} // namespace taut::structure
