#include "vibration_matrices.h"

#include <taut/fe/petsc.h>

#include <cmath>

namespace taut::structure
{
VibrationMatrices::~VibrationMatrices()
{
  solver_.reset();
  for (Mat* matrix : {&mass_, &stiffness_, &shifted_})
    MatDestroy(matrix);
}

void VibrationMatrices::clear_held(Mat mass) const
{
  for (fe::LocalNode node = 0; node < nodes_.n_owned; ++node)
    for (unsigned int c = 0; c < 3; ++c)
      if (nodes_.dependent[node] || (nodes_.held[node] >> c & 1))
      {
        const PetscInt row = 3 * nodes_.global(node) + c;
        TAUT_PETSC(MatSetValue(mass, row, row, 0., INSERT_VALUES));
      }
  TAUT_PETSC(MatAssemblyBegin(mass, MAT_FINAL_ASSEMBLY));
  TAUT_PETSC(MatAssemblyEnd(mass, MAT_FINAL_ASSEMBLY));
}

/// The identity, but 1 - n n^T on the free components of directors along n.
Mat VibrationMatrices::make_projection(const fe::NodalVector& positions) const
{
  Mat projection = nullptr;
  const PetscInt size = 3 * nodes_.n_owned;
  TAUT_PETSC(MatCreateAIJ(nodes_.partitioner->get_mpi_communicator(), size,
                          size, PETSC_DETERMINE, PETSC_DETERMINE, 3, nullptr, 0,
                          nullptr, &projection));
  for (PetscInt i = 0; i < size; ++i)
  {
    const PetscInt row = 3 * nodes_.first_owned + i;
    TAUT_PETSC(MatSetValue(projection, row, row, 1., ADD_VALUES));
  }
  for (const fe::Bar& bar : nodes_.bars)
  {
    if (bar.director >= nodes_.n_owned)
      continue;
    std::array<double, 3> n{};
    double square = 0;
    for (unsigned int c = 0; c < 3; ++c)
      if (!(nodes_.held[bar.director] >> c & 1))
      {
        n[c] = fe::entry(positions, 3 * bar.director + c);
        square += n[c] * n[c];
      }
    const PetscInt first = 3 * nodes_.global(bar.director);
    for (unsigned int i = 0; i < 3 && square > 0; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        TAUT_PETSC(MatSetValue(projection, first + i, first + j,
                               -n[i] * n[j] / square, ADD_VALUES));
  }
  TAUT_PETSC(MatAssemblyBegin(projection, MAT_FINAL_ASSEMBLY));
  TAUT_PETSC(MatAssemblyEnd(projection, MAT_FINAL_ASSEMBLY));
  return projection;
}

void VibrationMatrices::set_mass(Mat mass, const fe::NodalVector& positions)
{
  TAUT_PETSC(MatDestroy(&mass_));
  TAUT_PETSC(MatDuplicate(mass, MAT_COPY_VALUES, &mass_));
  clear_held(mass_);
  if (nodes_.bars.empty())
    return;
  Mat projection = make_projection(positions), product = nullptr;
  TAUT_PETSC(MatPtAP(mass_, projection, MAT_INITIAL_MATRIX, 1.5, &product));
  TAUT_PETSC(MatDestroy(&projection));
  TAUT_PETSC(MatDestroy(&mass_));
  mass_ = product;
}

double VibrationMatrices::set_stiffness(Mat stiffness)
{
  TAUT_PETSC(MatDestroy(&stiffness_));
  Mat skew = nullptr;
  TAUT_PETSC(MatTranspose(stiffness, MAT_INITIAL_MATRIX, &stiffness_));
  TAUT_PETSC(MatDuplicate(stiffness_, MAT_COPY_VALUES, &skew));
  TAUT_PETSC(MatAXPY(stiffness_, 1., stiffness, DIFFERENT_NONZERO_PATTERN));
  TAUT_PETSC(MatScale(stiffness_, 0.5));
  TAUT_PETSC(MatAXPY(skew, -1., stiffness, DIFFERENT_NONZERO_PATTERN));
  double norm = 0, skew_norm = 0;
  TAUT_PETSC(MatNorm(stiffness, NORM_FROBENIUS, &norm));
  TAUT_PETSC(MatNorm(skew, NORM_FROBENIUS, &skew_norm));
  TAUT_PETSC(MatDestroy(&skew));
  return norm > 0 ? 0.5 * skew_norm / norm : 0.;
}

fe::LinearSolver& VibrationMatrices::factorise(const double shift)
{
  solver_.reset();
  TAUT_PETSC(MatDestroy(&shifted_));
  TAUT_PETSC(MatDuplicate(stiffness_, MAT_COPY_VALUES, &shifted_));
  TAUT_PETSC(MatAXPY(shifted_, -shift, mass_, DIFFERENT_NONZERO_PATTERN));
  solver_ = std::make_unique<fe::LinearSolver>(
      shifted_, fe::LinearSolver::Kind::symmetric);
  solver_->factorise();
  return *solver_;
}
} // namespace taut::structure
