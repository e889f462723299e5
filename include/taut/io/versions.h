#pragma once

#include <map>
#include <string>

namespace taut::io
{
/// Version of Taut itself.
std::string get_taut_version();

/// Versions of Taut and of the libraries that decide its numbers: taut,
/// deal.II, PETSc, SUNDIALS, gmsh, and the file of the BLAS that really runs.
std::map<std::string, std::string> get_versions();
} // namespace taut::io
