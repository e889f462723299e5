#include <taut/io/versions.h>

#include <deal.II/base/config.h>

#include <dlfcn.h>
#include <fmt/format.h>
#include <gmsh.h>
#include <petscversion.h>

#include <filesystem>

namespace taut::io
{
namespace
{
/// The shared library in which the loader found BLAS: libblas.so.3 stands for
/// any implementation.
std::string find_blas()
{
  const void* routine = dlsym(RTLD_DEFAULT, "dgemm_");
  Dl_info info;
  if (!routine || dladdr(routine, &info) == 0)
    return "unknown";
  std::error_code error;
  const auto file = std::filesystem::canonical(info.dli_fname, error);
  return error ? std::string(info.dli_fname) : file.string();
}
} // namespace

std::string get_taut_version()
{
  return TAUT_VERSION;
}

std::map<std::string, std::string> get_versions()
{
  return {{"taut", get_taut_version()},
          {"deal.II", DEAL_II_PACKAGE_VERSION},
          {"PETSc", fmt::format("{}.{}.{}", PETSC_VERSION_MAJOR,
                                PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR)},
          {"SUNDIALS", fmt::format("{}.{}.{}", DEAL_II_SUNDIALS_VERSION_MAJOR,
                                   DEAL_II_SUNDIALS_VERSION_MINOR,
                                   DEAL_II_SUNDIALS_VERSION_PATCH)},
          {"gmsh", GMSH_API_VERSION},
          {"BLAS", find_blas()}};
}
} // namespace taut::io
