#pragma once

#include <petscksp.h>

/// PETSc's global type names (Mat, Vec, PC, IS ...) stay out of headers that
/// others include: use this one in source files and with forward names.
namespace taut::fe
{
/// Throws SolverFailed with PETSc's message unless `code` is 0.
void check_petsc(PetscErrorCode code, const char* call);
} // namespace taut::fe

#define TAUT_PETSC(call) ::taut::fe::check_petsc((call), #call)
