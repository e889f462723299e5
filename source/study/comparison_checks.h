#pragma once

#include <taut/base/nearest_name.h>
#include <taut/study/case.h>

#include <algorithm>
#include <string>
#include <vector>

/// What all readings of a film case as a lumped model share.
namespace taut::study
{
/// Throws BadInput at the line of the entry.
[[noreturn]] void refuse(const Case& film_case, const std::string& kind,
                         const structure::Named& entry,
                         const std::string& message);
/// At the section Comparison.
[[noreturn]] void refuse(const Case& film_case, const std::string& message);

template <class Entry>
const Entry& find(const Case& film_case, const std::vector<Entry>& entries,
                  const std::string& name, const std::string& kind)
{
  std::vector<std::string> names;
  for (const Entry& entry : entries)
    names.push_back(entry.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    refuse(film_case,
           "there is no " + kind + " '" + name + "'; " + suggest(name, names));
  return entries[found - names.begin()];
}

/// Refuses every entry that is none of the `known` ones.
template <class Entry>
void check_no_others(const Case& film_case, const std::string& kind,
                     const std::vector<Entry>& entries,
                     const std::vector<std::string>& known)
{
  for (const Entry& entry : entries)
    if (std::find(known.begin(), known.end(), entry.name) == known.end())
      refuse(film_case, kind, entry,
             "the lumped model of the comparison has no place for it");
}

/// Refuses pressures, edge loads, gravity and supports that move.
void check_loads(const Case& film_case);
} // namespace taut::study
