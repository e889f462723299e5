#pragma once

#include <stdexcept>
#include <string>

namespace taut
{
/// What the user gave cannot be used. Ends the program with exit code 2 before
/// any work is done.
class BadInput : public std::runtime_error
{
public:
  /// A problem that no single line of a file causes.
  explicit BadInput(const std::string& message);

  /// `message` says what is wrong, what is allowed and, where one exists, the
  /// nearest valid name. `line` 0 means unknown, an empty `key` none.
  BadInput(const std::string& message, const std::string& file,
           unsigned int line, const std::string& key);

  /// The message without the position.
  const std::string& message() const
  {
    return message_;
  }
  const std::string& file() const
  {
    return file_;
  }
  unsigned int line() const
  {
    return line_;
  }
  const std::string& key() const
  {
    return key_;
  }

private:
  std::string message_;
  std::string file_;
  unsigned int line_ = 0;
  std::string key_;
};

/// The state that a solver tried is not admissible (a Gent spring beyond its
/// limit, a cell turned inside out): a smaller step may succeed.
class StepRejected : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A solver gave up. Ends the program with exit code 3; everything computed so
/// far stays valid.
class SolverFailed : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace taut
