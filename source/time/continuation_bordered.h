#pragma once

#include <taut/time/equilibrium.h>

#include <vector>

#include "system_communicator.h"

namespace taut::time
{
/// A point of a path or a direction there: displacements of this rank (m) and
/// the parameter, which every rank knows.
struct PathVector
{
  std::vector<double> u;
  double parameter = 0;
};

/// a + factor b.
PathVector add(const PathVector& a, double factor, const PathVector& b);

/// What makes displacements and the parameter comparable: lengths on a path are
/// measured in these units.
struct PathMetric
{
  double displacement = 1; ///< norm of u (m)
  double parameter = 1;
};

double dot(const PathVector& a, const PathVector& b, const PathMetric& metric,
           const Communicator& communicator);

/// The points x = (u, parameter) with normal . (x - origin) = distance.
struct PathPlane
{
  PathVector normal; ///< of length 1
  PathVector origin;
  double distance = 0;
};

/// An equilibrium problem in which the parameter is one more unknown, the last
/// of the first rank, and one more equation says on which plane the point lies.
/// Its tangent is solved by elimination of the border, with two solutions of
/// the problem's own one.
class BorderedProblem : public EquilibriumProblem
{
public:
  /// Derivatives by the parameter are taken inside `start`, `end` for points
  /// inside: signals have kinks there.
  BorderedProblem(EquilibriumProblem& problem, double start, double end);

  /// The plane is held with the forces at `guess`.
  void set_plane(const PathPlane& plane, const PathMetric& metric,
                 const PathVector& guess);

  /// x as this rank's array of unknowns, and back.
  std::vector<double> pack(const PathVector& x) const;
  PathVector unpack(const double* x) const;

  /// d residual / d parameter at x, by differences.
  std::vector<double> compute_parameter_derivative(double parameter,
                                                   const double* u);

  MPI_Comm communicator() const override;
  std::size_t n_unknowns() const override;
  void compute_residual(double load, const double* x,
                        double* residual) override;
  void prepare(double load, const double* x) override;
  void solve(const double* r, double* d) override;
  double reference_force() const override;
  double round_off_force() const override;
  bool takes_full_steps() const override;
  void forget_iteration() override;
  void check_equilibrium(double load, const double* x) override;

private:
  double get_parameter(const double* x) const;

  EquilibriumProblem& problem_;
  const double start_, end_;
  const Communicator communicator_;
  const std::size_t size_;
  const bool holds_parameter_;
  PathPlane plane_;
  PathMetric metric_;
  double stiffness_ = 1;             ///< of the plane (N)
  std::vector<double> by_parameter_; ///< tangent^{-1} d residual / d parameter
};
} // namespace taut::time
