#pragma once

#include <taut/base/exceptions.h>

#include <exception>
#include <string>

#include "system_communicator.h"

namespace taut::time
{
/// Runs what a C library calls back, so that no exception crosses its frames
/// and every rank returns the same code.
class CallbackGuard
{
public:
  explicit CallbackGuard(const Communicator& communicator)
      : communicator_(communicator)
  {
  }

  /// The code of SUNDIALS: 0 for success, 1 (try a smaller step) after
  /// StepRejected on any rank, -1 (give up) after any other exception.
  template <class Function>
  int operator()(Function&& function) noexcept
  {
    int severity = 0;
    std::string message;
    try
    {
      function();
    }
    catch (const StepRejected& rejection)
    {
      severity = 1;
      message = rejection.what();
    }
    catch (...)
    {
      severity = 2;
      failure_ = std::current_exception();
    }
    return agree(severity, message);
  }

  /// Throws what ended a callback with -1, if one did.
  void rethrow() const;

  /// Why the last state was rejected; empty if none was since forget().
  const std::string& last_rejection() const
  {
    return last_rejection_;
  }

  void forget()
  {
    last_rejection_.clear();
  }

private:
  int agree(int severity, const std::string& message) noexcept;

  Communicator communicator_;
  std::exception_ptr failure_;
  std::string last_rejection_;
};
} // namespace taut::time
