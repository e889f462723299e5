#pragma once

#include <mpi.h>

#include <functional>

namespace taut::app
{
/// Calls `action` and gives its result, or the exit code of the exception that
/// it ends with, which is told in one line on standard error. Where only some
/// ranks fail, the others, which may wait for them for ever, are ended too.
/// Collective.
int guard(MPI_Comm communicator, const std::function<int()>& action);
} // namespace taut::app
