#pragma once

#include <taut/time/equilibrium.h>

#include <cmath>
#include <functional>
#include <vector>

/// A few equations with a symmetric tangent, spread over all ranks one by one.
class SmallProblem : public taut::time::EquilibriumProblem
{
public:
  using Vector = std::vector<double>;
  using Residual = std::function<Vector(double load, const Vector& x)>;
  /// Rows of the tangent, one after the other.
  using Tangent = std::function<Vector(double load, const Vector& x)>;

  SmallProblem(const std::size_t n, Residual residual, Tangent tangent)
      : n_(n), residual_(std::move(residual)), tangent_(std::move(tangent))
  {
    int n_ranks = 1, rank = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    // The last unknown lies on the first rank, so that ranks differ in size.
    for (std::size_t i = 0; i < n; ++i)
      if ((n - 1 - i) % n_ranks == static_cast<std::size_t>(rank))
        own_.push_back(i);
  }

  MPI_Comm communicator() const override
  {
    return MPI_COMM_WORLD;
  }
  std::size_t n_unknowns() const override
  {
    return own_.size();
  }
  void compute_residual(const double load, const double* u,
                        double* residual) override
  {
    restrict(residual_(load, gather(u)), residual);
  }
  void prepare(const double load, const double* u) override
  {
    factors_ = tangent_(load, gather(u));
    negative_ = 0;
    for (std::size_t k = 0; k < n_; ++k)
    {
      negative_ += at(k, k) < 0;
      for (std::size_t i = k + 1; i < n_; ++i)
      {
        at(i, k) /= at(k, k);
        for (std::size_t j = k + 1; j < n_; ++j)
          at(i, j) -= at(i, k) * at(k, j);
      }
    }
  }
  void solve(const double* r, double* d) override
  {
    Vector x = gather(r);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < i; ++j)
        x[i] -= at(i, j) * x[j];
    for (std::size_t i = n_; i-- > 0;)
    {
      for (std::size_t j = i + 1; j < n_; ++j)
        x[i] -= at(i, j) * x[j];
      x[i] /= at(i, i);
    }
    restrict(x, d);
  }
  std::optional<int> count_negative_eigenvalues() override
  {
    return negative_;
  }
  double reference_force() const override
  {
    return 1;
  }

  /// All unknowns on every rank.
  Vector gather(const double* u) const
  {
    Vector all(n_, 0.);
    for (std::size_t i = 0; i < own_.size(); ++i)
      all[own_[i]] = u[i];
    MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(n_), MPI_DOUBLE,
                  MPI_SUM, MPI_COMM_WORLD);
    return all;
  }
  /// Those of this rank.
  void restrict(const Vector& all, double* u) const
  {
    for (std::size_t i = 0; i < own_.size(); ++i)
      u[i] = all[own_[i]];
  }

private:
  double& at(const std::size_t i, const std::size_t j)
  {
    return factors_[i * n_ + j];
  }

  const std::size_t n_;
  const Residual residual_;
  const Tangent tangent_;
  std::vector<std::size_t> own_;
  Vector factors_;
  int negative_ = 0;
};
