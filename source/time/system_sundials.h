#pragma once

#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_nvector.h>

#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>

#include "system_communicator.h"

/// Owners of the C objects of SUNDIALS, and the matrix and linear solver that
/// hand all work to Taut.
namespace taut::time
{
struct ContextDeleter
{
  void operator()(SUNContext context) const
  {
    SUNContext_Free(&context);
  }
};
struct VectorDeleter
{
  void operator()(N_Vector vector) const
  {
    N_VDestroy(vector);
  }
};
struct MatrixDeleter
{
  void operator()(SUNMatrix matrix) const
  {
    SUNMatDestroy(matrix);
  }
};
struct LinearSolverDeleter
{
  void operator()(SUNLinearSolver solver) const
  {
    SUNLinSolFree(solver);
  }
};
struct NonlinearSolverDeleter
{
  void operator()(SUNNonlinearSolver solver) const
  {
    SUNNonlinSolFree(solver);
  }
};

using ContextHandle =
    std::unique_ptr<std::remove_pointer_t<SUNContext>, ContextDeleter>;
using VectorHandle =
    std::unique_ptr<std::remove_pointer_t<N_Vector>, VectorDeleter>;
using MatrixHandle =
    std::unique_ptr<std::remove_pointer_t<SUNMatrix>, MatrixDeleter>;
using LinearSolverHandle =
    std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>,
                    LinearSolverDeleter>;

using NonlinearSolverHandle =
    std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>,
                    NonlinearSolverDeleter>;

/// The memory of one solver: `Free` is its function of the form
/// void Free(void** memory).
template <void (*Free)(void**)>
struct SolverMemoryDeleter
{
  void operator()(void* memory) const
  {
    Free(&memory);
  }
};
template <void (*Free)(void**)>
using SolverMemoryHandle = std::unique_ptr<void, SolverMemoryDeleter<Free>>;

/// A matrix as SUNDIALS uses it. Both methods return SUNDIALS' codes (0, 1 or
/// -1) and never throw.
class MatrixOperations
{
public:
  virtual ~MatrixOperations() = default;
  /// x = A^{-1} b; `b` may be overwritten.
  virtual int solve(double* b, double* x) = 0;
  /// y = A x; only asked of mass matrices.
  virtual int multiply(const double* x, double* y);
};

ContextHandle make_context();

/// A view of `data`, this rank's `size` entries; parallel only if it has to be.
VectorHandle make_vector(const Communicator& communicator, std::size_t size,
                         double* data, SUNContext context);

/// A matrix without entries, of which only `operations` (which must outlive
/// it) knows what it means.
MatrixHandle make_matrix(MatrixOperations& operations, SUNContext context);
LinearSolverHandle make_linear_solver(MatrixOperations& operations,
                                      SUNContext context);

inline double* get_data(N_Vector vector)
{
  return N_VGetArrayPointer(vector);
}

/// Throws SolverFailed if `flag`, returned by the function `name` that sets up
/// a solver, is not 0.
void check(int flag, const char* name);
/// Same for a function that returns an object.
void check(const void* object, const char* name);

/// The name that a solver's GetReturnFlagName gives (and leaves to be freed).
std::string take_name(char* name);

/// Receives the messages of a solver instead of the standard error stream.
extern "C" void taut_keep_message(int code, const char* module,
                                  const char* function, char* message,
                                  void* text);
} // namespace taut::time
