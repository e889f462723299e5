#pragma once

#include <taut/base/exceptions.h>
#include <taut/structure/watches.h>

#include <gtest/gtest.h>

#include <string>

/// Events that no device can have.
namespace taut::testing
{
/// Why the events of a system cannot be watched.
inline std::string get_watch_refusal(structure::StructureSystem& system)
{
  structure::Probes probes(system);
  try
  {
    structure::Watches watches(system, probes);
  }
  catch (const BadInput& refusal)
  {
    return refusal.what();
  }
  return "accepted";
}

inline void expect_contains(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text;
}
} // namespace taut::testing
