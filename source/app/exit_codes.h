#pragma once

/// How the program ends; part of the contract with its users.
namespace taut::app
{
enum ExitCode : int
{
  done = 0,
  broken = 1,        ///< an error that is none of those below
  bad_input = 2,     ///< before any work was done
  solver_failed = 3, ///< all output up to there is valid
  fatal_event = 4,   ///< an event that the case declares fatal
  interrupted = 5    ///< by SIGINT or SIGTERM; --resume goes on
};
} // namespace taut::app
