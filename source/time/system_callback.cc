#include "system_callback.h"

namespace taut::time
{
namespace
{
std::string describe(const std::exception_ptr& failure)
{
  if (!failure)
    return "";
  try
  {
    std::rethrow_exception(failure);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  catch (...)
  {
    return "an exception of an unknown type";
  }
}
} // namespace

int CallbackGuard::agree(const int severity,
                         const std::string& message) noexcept
{
  const int worst = communicator_.max(severity);
  if (worst == 1)
    last_rejection_ = communicator_.share(message);
  if (worst < 2)
    return worst;
  const std::string reason = communicator_.share(describe(failure_));
  if (!failure_)
    failure_ = std::make_exception_ptr(SolverFailed(reason));
  return -1;
}

void CallbackGuard::rethrow() const
{
  if (failure_)
    std::rethrow_exception(failure_);
}
} // namespace taut::time
