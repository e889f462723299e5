// Factorisations that fail and those after them.
#include <taut/base/exceptions.h>
#include <taut/fe/linear_solver.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/petsc_sparse_matrix.h>

#include <gtest/gtest.h>

#include <array>

namespace taut::fe
{
namespace
{
/// [[a, 1], [1, 1]] on every rank.
class Blocks
{
public:
  explicit Blocks(const double a)
  {
    const unsigned int rank =
        dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int n =
        dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    dealii::IndexSet own(2 * n);
    own.add_range(2 * rank, 2 * rank + 2);
    dealii::DynamicSparsityPattern pattern(2 * n, 2 * n, own);
    for (const auto i : own)
      for (const auto j : own)
        pattern.add(i, j);
    first_ = 2 * rank;
    matrix_.reinit(own, own, pattern, MPI_COMM_WORLD);
    set(a);
  }
  void set(const double a)
  {
    matrix_.set(first_, first_, a);
    matrix_.set(first_, first_ + 1, 1.);
    matrix_.set(first_ + 1, first_, 1.);
    matrix_.set(first_ + 1, first_ + 1, 1.);
    matrix_.compress(dealii::VectorOperation::insert);
  }
  Mat get()
  {
    return matrix_;
  }

private:
  dealii::PETScWrappers::MPI::SparseMatrix matrix_;
  unsigned int first_ = 0;
};

class LinearSolverOf : public ::testing::TestWithParam<LinearSolver::Kind>
{
};

TEST_P(LinearSolverOf, AfterASingularMatrixARegularOneIsSolved)
{
  Blocks blocks(1);
  LinearSolver solver(blocks.get(), GetParam());
  EXPECT_THROW(solver.factorise(), StepRejected);
  blocks.set(3);
  solver.factorise();
  std::array<double, 2> x{{5, 3}};
  solver.solve(x.data(), x.data());
  EXPECT_NEAR(x[0], 1, 1e-14);
  EXPECT_NEAR(x[1], 2, 1e-14);
}

TEST_P(LinearSolverOf, NegativeEigenvaluesAreThoseOfTheMatrix)
{
  // Of determinant -3 on every rank.
  Blocks blocks(-2);
  LinearSolver solver(blocks.get(), GetParam());
  solver.factorise();
  EXPECT_EQ(solver.count_negative_eigenvalues(),
            int(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)));
}

INSTANTIATE_TEST_SUITE_P(Kinds, LinearSolverOf,
                         ::testing::Values(LinearSolver::Kind::symmetric,
                                           LinearSolver::Kind::general));
} // namespace
} // namespace taut::fe
