#pragma once

#include <taut/base/exceptions.h>

#include <petscsys.h>

#include <string>

namespace taut::time
{
/// Throws SolverFailed with the library's message unless `code` is 0.
inline void check_slepc(const PetscErrorCode code, const char* call)
{
  if (code == 0)
    return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw SolverFailed(std::string("SLEPc: ") + call + ": " +
                     (text ? text : "unknown error"));
}
} // namespace taut::time

#define TAUT_SLEPC(call) ::taut::time::check_slepc((call), #call)
