// A case file with a mistake, and what must be said about it.
#pragma once

#include <taut/base/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "io/small_case.h"

namespace taut::io::testing
{
/// An edit of a case and what its refusal must say.
struct Refusal
{
  const char* what;
  /// Text of the case, once in it, and what replaces it.
  const char* from;
  const char* to;
  /// Text in the edited file whose line must be named; null if no line can be.
  const char* culprit;
  const char* key;
  /// A part of the message.
  const char* says;
};

inline void PrintTo(const Refusal& refusal, std::ostream* stream)
{
  *stream << refusal.what;
}

inline std::string edit(std::string content, const std::string& from,
                        const std::string& to)
{
  const std::size_t place = content.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return content.replace(place, from.size(), to);
}

inline unsigned int line_of(const std::string& content, const char* culprit)
{
  if (!culprit)
    return 0;
  const std::size_t place = content.find(culprit);
  EXPECT_NE(place, std::string::npos) << culprit;
  return 1 + std::count(content.begin(), content.begin() + place, '\n');
}

/// read(file) must refuse the `content` of the file as it is said.
template <typename Read>
void expect_refused_by(const Read& read, const std::string& file,
                       const std::string& content, const Refusal& refusal)
{
  try
  {
    read(file);
    FAIL() << "accepted: " << refusal.what;
  }
  catch (const BadInput& problem)
  {
    EXPECT_EQ(problem.file(), file);
    EXPECT_EQ(problem.line(), line_of(content, refusal.culprit))
        << problem.what();
    EXPECT_EQ(problem.key(), refusal.key);
    EXPECT_NE(problem.message().find(refusal.says), std::string::npos)
        << problem.what();
  }
}

inline void expect_refused(const std::string& original, const Refusal& refusal)
{
  const std::string content = edit(original, refusal.from, refusal.to);
  const CaseOnDisk disk(content);
  expect_refused_by([](const std::string& file) { read_case(file); },
                    disk.file(), content, refusal);
}
} // namespace taut::io::testing
