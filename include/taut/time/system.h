#pragma once

#include <mpi.h>

#include <cstddef>
#include <string>
#include <vector>

namespace taut::time
{
/// Sizes of the blocks of this rank's part of the state, in their order in the
/// flat vector y = [positions | velocities | internal | globals | scalars].
struct StateLayout
{
  /// Free position unknowns u (m).
  std::size_t positions = 0;
  /// Velocities of the same unknowns (m/s): as many as positions, or none in a
  /// quasi-static system.
  std::size_t velocities = 0;
  /// Internal variables A of the viscous networks (dimensionless).
  std::size_t internal = 0;
  /// Unknowns of the whole system with rates of their own, such as charges in
  /// circuits, scaled so that 1 is large; on rank 0 only.
  std::size_t globals = 0;
  /// Time integrals that nothing depends on, such as dissipated energy (J);
  /// on rank 0 only. They are integrated but not error-controlled.
  std::size_t scalars = 0;

  std::size_t size() const
  {
    return positions + velocities + internal + globals + scalars;
  }
};

/// A system of ordinary differential and algebraic equations as the
/// integrators see it. With velocities
///   u' = v,   M v' = force(t, u, v, A, g),   A' = rate(t, u, A),
///   g' = rate(t, u, A, g),   s' = rate(t, y)
/// and without (quasi-static)
///   0 = force(t, u, A, g),   the rest as before.
/// In short  B y' = f(t, y)  with the constant matrix B = diag(1, M, 1, 1, 1)
/// or diag(0, 1, 1, 1). Vectors are this rank's part, of length
/// layout().size().
///
/// Every method is collective. Errors of every method: StepRejected where the
/// state is not admissible (a smaller step may help), SolverFailed where
/// nothing helps.
class System
{
public:
  virtual ~System() = default;

  virtual MPI_Comm communicator() const = 0;
  virtual StateLayout layout() const = 0;

  /// f(t, y).
  virtual void evaluate(double time, const double* state, double* f) = 0;

  /// result = B x, every block included.
  virtual void multiply_mass(const double* x, double* result) = 0;

  /// Solves B x = b in the velocity block, copies the other blocks. Only for
  /// systems with velocities.
  virtual void solve_mass(const double* b, double* x) = 0;

  /// Linearises at (t, y) and factorises alpha B - df/dy (approximately: the
  /// symmetric part of the condensed tangent may stand for it). `alpha` (1/s)
  /// is kept and used by every later `solve`.
  virtual void prepare(double time, const double* state, double alpha) = 0;

  /// d = (alpha B - df/dy)^{-1} r with the matrix of the last `prepare`.
  /// `r` and `d` may be the same array.
  virtual void solve(const double* r, double* d) = 0;

  /// Called at a stop time: the right-hand side jumps from its value just
  /// before `time` to the one just after. Adds to the scalars what the jump
  /// does at once (such as the work of a voltage step); a quasi-static system
  /// also finds the new equilibrium.
  virtual void pass_stop_time(double time, double* state) = 0;

  /// Times in (start, end) at which f or its derivative jumps, increasing.
  virtual std::vector<double> stop_times(double start, double end) const = 0;
};
} // namespace taut::time
