#pragma once

#include <mpi.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace taut::time
{
/// K phi = s M phi with symmetric matrices; M has no negative eigenvalues and
/// may be zero for some unknowns, which follow the others at once. Vectors are
/// this rank's part. Every method is collective. Errors: StepRejected where a
/// matrix is singular, SolverFailed.
class VibrationProblem
{
public:
  virtual ~VibrationProblem() = default;
  virtual MPI_Comm communicator() const = 0;
  virtual std::size_t n_unknowns() const = 0;
  /// result = M x.
  virtual void multiply_mass(const double* x, double* result) = 0;
  /// Factorises K - shift M and returns its number of negative eigenvalues: as
  /// many s lie below the shift (Sylvester), and one more for each unstable
  /// unknown without mass.
  virtual int factorise(double shift) = 0;
  /// d = (K - shift M)^{-1} r; `r` and `d` may be the same array.
  virtual void solve(const double* r, double* d) = 0;
};

struct VibrationMode
{
  /// s, the square of the angular frequency (1/s^2); negative: unstable.
  double square = 0;
  /// phi with phi . M phi = 1 (1/sqrt(kg) times the unit of an unknown).
  std::vector<double> shape;
};

struct ModeOptions
{
  /// How many, at least 1; fewer are found if there are not as many.
  unsigned int count = 10;
  /// The modes next to this s (1/s^2); nothing: the lowest ones.
  std::optional<double> target;
  /// Of 1/(s - shift), relative.
  double tolerance = 1e-12;
};

struct ModeSearch
{
  /// By increasing s.
  std::vector<VibrationMode> modes;
  /// False if Sylvester's count says that there is a mode between them that was
  /// not found.
  bool complete = true;
};

/// Shift-invert (SLEPc, Krylov-Schur in the inner product of M). For the lowest
/// modes the shift lies below all of them, at the distance of their spread, so
/// that rigid motions and unstable modes are found like others. Errors:
/// SolverFailed if an unknown without mass is unstable, so that no shift is low
/// enough, or if the iteration does not converge.
ModeSearch find_modes(VibrationProblem& problem, const ModeOptions& options);
} // namespace taut::time
