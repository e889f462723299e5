#pragma once

#include <taut/time/equilibrium.h>

#include <algorithm>
#include <cmath>
#include <functional>

/// One equation with one unknown, the same on every rank.
class ScalarProblem : public taut::time::EquilibriumProblem
{
public:
  using Function = std::function<double(double load, double x)>;

  ScalarProblem(Function residual, Function slope, const double force)
      : residual_(std::move(residual)), slope_(std::move(slope)), force_(force)
  {
  }

  /// Largest distance from the last linearisation to a state that was tried.
  double longest_step = 0;

  MPI_Comm communicator() const override
  {
    return MPI_COMM_SELF;
  }
  std::size_t n_unknowns() const override
  {
    return 1;
  }

  void compute_residual(const double load, const double* u,
                        double* residual) override
  {
    if (is_prepared_)
      longest_step = std::max(longest_step, std::abs(u[0] - prepared_at_));
    residual[0] = residual_(load, u[0]);
  }

  void prepare(const double load, const double* u) override
  {
    tangent_ = slope_(load, u[0]);
    prepared_at_ = u[0];
    is_prepared_ = true;
  }

  void solve(const double* r, double* d) override
  {
    d[0] = r[0] / tangent_;
  }
  double reference_force() const override
  {
    return force_;
  }

private:
  Function residual_;
  Function slope_;
  double force_;
  double tangent_ = 0;
  double prepared_at_ = 0;
  bool is_prepared_ = false;
};
