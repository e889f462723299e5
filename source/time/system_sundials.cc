#include "system_sundials.h"

#include <taut/base/exceptions.h>

#include <nvector/nvector_parallel.h>
#include <nvector/nvector_serial.h>

#include <cstdlib>

namespace taut::time
{
namespace
{
MatrixOperations& get_operations(void* content)
{
  return *static_cast<MatrixOperations*>(content);
}

SUNMatrix_ID get_matrix_id(SUNMatrix /*matrix*/)
{
  return SUNMATRIX_CUSTOM;
}

int do_nothing(SUNMatrix /*matrix*/)
{
  return 0;
}

int copy_nothing(SUNMatrix /*from*/, SUNMatrix /*to*/)
{
  return 0;
}

int multiply(SUNMatrix matrix, N_Vector x, N_Vector y)
{
  return get_operations(matrix->content).multiply(get_data(x), get_data(y));
}

SUNMatrix clone_matrix(SUNMatrix matrix)
{
  SUNMatrix clone = SUNMatNewEmpty(matrix->sunctx);
  if (clone == nullptr)
    return nullptr;
  clone->content = matrix->content;
  SUNMatCopyOps(matrix, clone);
  return clone;
}

void destroy_matrix(SUNMatrix matrix)
{
  // The content is not ours to free.
  SUNMatFreeEmpty(matrix);
}

SUNLinearSolver_Type get_solver_type(SUNLinearSolver /*solver*/)
{
  return SUNLINEARSOLVER_DIRECT;
}

int set_up_solver(SUNLinearSolver /*solver*/, SUNMatrix /*matrix*/)
{
  return SUNLS_SUCCESS;
}

int solve(SUNLinearSolver solver, SUNMatrix /*matrix*/, N_Vector x, N_Vector b,
          realtype /*tolerance*/)
{
  const int code =
      get_operations(solver->content).solve(get_data(b), get_data(x));
  if (code == 0)
    return SUNLS_SUCCESS;
  return code > 0 ? SUNLS_PACKAGE_FAIL_REC : SUNLS_PACKAGE_FAIL_UNREC;
}

int free_solver(SUNLinearSolver solver)
{
  SUNLinSolFreeEmpty(solver);
  return SUNLS_SUCCESS;
}
} // namespace

int MatrixOperations::multiply(const double* /*x*/, double* /*y*/)
{
  return -1;
}

ContextHandle make_context()
{
  SUNContext context = nullptr;
  check(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  return ContextHandle(context);
}

VectorHandle make_vector(const Communicator& communicator,
                         const std::size_t size, double* data,
                         SUNContext context)
{
  const auto length = static_cast<sunindextype>(size);
  VectorHandle vector(
      communicator.is_parallel()
          ? N_VMake_Parallel(communicator.get(), length,
                             communicator.sum(static_cast<long long>(size)),
                             data, context)
          : N_VMake_Serial(length, data, context));
  check(vector.get(), "N_VMake");
  return vector;
}

MatrixHandle make_matrix(MatrixOperations& operations, SUNContext context)
{
  MatrixHandle matrix(SUNMatNewEmpty(context));
  check(matrix.get(), "SUNMatNewEmpty");
  matrix->content = &operations;
  matrix->ops->getid = get_matrix_id;
  matrix->ops->clone = clone_matrix;
  matrix->ops->destroy = destroy_matrix;
  matrix->ops->zero = do_nothing;
  matrix->ops->copy = copy_nothing;
  matrix->ops->matvec = multiply;
  return matrix;
}

LinearSolverHandle make_linear_solver(MatrixOperations& operations,
                                      SUNContext context)
{
  LinearSolverHandle solver(SUNLinSolNewEmpty(context));
  check(solver.get(), "SUNLinSolNewEmpty");
  solver->content = &operations;
  solver->ops->gettype = get_solver_type;
  solver->ops->setup = set_up_solver;
  solver->ops->solve = solve;
  solver->ops->free = free_solver;
  return solver;
}

void check(const int flag, const char* name)
{
  if (flag != 0)
    throw SolverFailed(std::string(name) + " returned " + std::to_string(flag));
}

void check(const void* object, const char* name)
{
  if (object == nullptr)
    throw SolverFailed(std::string(name) + " returned nothing");
}

std::string take_name(char* name)
{
  const std::unique_ptr<char, void (*)(void*)> owner(name, std::free);
  return name == nullptr ? "an unknown flag" : std::string(name);
}

void taut_keep_message(int /*code*/, const char* /*module*/,
                       const char* /*function*/, char* message, void* text)
{
  *static_cast<std::string*>(text) = message;
}
} // namespace taut::time
