#include "failure.h"

#include <taut/base/exceptions.h>

#include <chrono>
#include <iostream>
#include <string>
#include <thread>

#include "exit_codes.h"

namespace taut::app
{
namespace
{
using namespace std::chrono_literals;

/// Whether all ranks come here, too, within a moment.
bool all_arrive(const MPI_Comm communicator)
{
  MPI_Request request;
  MPI_Ibarrier(communicator, &request);
  int arrived = 0;
  for (int i = 0; i < 200 && !arrived; ++i)
  {
    MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
    if (!arrived)
      std::this_thread::sleep_for(10ms);
  }
  return arrived != 0;
}

int tell(const MPI_Comm communicator, const ExitCode code,
         const std::string& message)
{
  const bool is_common = all_arrive(communicator);
  int rank;
  MPI_Comm_rank(communicator, &rank);
  if (rank == 0 || !is_common)
    std::cerr << "taut: " + message + "\n" << std::flush;
  if (!is_common)
    MPI_Abort(communicator, code);
  return code;
}

int call(const MPI_Comm communicator, const std::function<int()>& action)
{
  try
  {
    return action();
  }
  catch (const BadInput& error)
  {
    return tell(communicator, bad_input, error.what());
  }
  catch (const SolverFailed& error)
  {
    return tell(communicator, solver_failed, error.what());
  }
  catch (const StepRejected& error)
  {
    return tell(communicator, solver_failed, error.what());
  }
  catch (const std::exception& error)
  {
    return tell(communicator, broken, error.what());
  }
}
} // namespace

int guard(const MPI_Comm communicator, const std::function<int()>& action)
{
  // Whatever the others are waiting for is on another communicator.
  MPI_Comm own;
  MPI_Comm_dup(communicator, &own);
  const int code = call(own, action);
  MPI_Comm_free(&own);
  return code;
}
} // namespace taut::app
