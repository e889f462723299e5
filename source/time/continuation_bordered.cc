#include "continuation_bordered.h"

#include <algorithm>
#include <cmath>

namespace taut::time
{
namespace
{
bool is_first(const MPI_Comm communicator)
{
  int initialized = 0, rank = 0;
  MPI_Initialized(&initialized);
  if (initialized != 0)
    MPI_Comm_rank(communicator, &rank);
  return rank == 0;
}
} // namespace

PathVector add(const PathVector& a, const double factor, const PathVector& b)
{
  PathVector sum = a;
  for (std::size_t i = 0; i < sum.u.size(); ++i)
    sum.u[i] += factor * b.u[i];
  sum.parameter += factor * b.parameter;
  return sum;
}

double dot(const PathVector& a, const PathVector& b, const PathMetric& metric,
           const Communicator& communicator)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.u.size(); ++i)
    sum += a.u[i] * b.u[i];
  return communicator.sum(sum) / std::pow(metric.displacement, 2) +
         a.parameter * b.parameter / std::pow(metric.parameter, 2);
}

BorderedProblem::BorderedProblem(EquilibriumProblem& problem,
                                 const double start, const double end)
    : problem_(problem), start_(std::min(start, end)),
      end_(std::max(start, end)), communicator_(problem.communicator()),
      size_(problem.n_unknowns()),
      holds_parameter_(is_first(problem.communicator()))
{
}

void BorderedProblem::set_plane(const PathPlane& plane,
                                const PathMetric& metric,
                                const PathVector& guess)
{
  plane_ = plane;
  metric_ = metric;
  std::vector<double> unused(size_);
  problem_.compute_residual(guess.parameter, guess.u.data(), unused.data());
  stiffness_ = problem_.reference_force();
}

std::vector<double> BorderedProblem::pack(const PathVector& x) const
{
  std::vector<double> all = x.u;
  if (holds_parameter_)
    all.push_back(x.parameter);
  return all;
}

PathVector BorderedProblem::unpack(const double* x) const
{
  return {std::vector<double>(x, x + size_), get_parameter(x)};
}

double BorderedProblem::get_parameter(const double* x) const
{
  return communicator_.sum(holds_parameter_ ? x[size_] : 0.);
}

std::vector<double>
BorderedProblem::compute_parameter_derivative(const double parameter,
                                              const double* u)
{
  const double step = 1e-5 * (end_ - start_);
  double before = parameter - step, after = parameter + step;
  if (parameter >= start_ && parameter <= end_)
  {
    before = std::max(before, start_);
    after = std::min(after, end_);
  }
  std::vector<double> low(size_), high(size_);
  problem_.compute_residual(before, u, low.data());
  problem_.compute_residual(after, u, high.data());
  for (std::size_t i = 0; i < size_; ++i)
    high[i] = (high[i] - low[i]) / (after - before);
  return high;
}

MPI_Comm BorderedProblem::communicator() const
{
  return problem_.communicator();
}

std::size_t BorderedProblem::n_unknowns() const
{
  return size_ + (holds_parameter_ ? 1 : 0);
}

void BorderedProblem::compute_residual(double /*load*/, const double* x,
                                       double* residual)
{
  const PathVector point = unpack(x);
  problem_.compute_residual(point.parameter, x, residual);
  const double distance =
      dot(plane_.normal, add(point, -1, plane_.origin), metric_, communicator_);
  if (holds_parameter_)
    residual[size_] = stiffness_ * (distance - plane_.distance);
}

void BorderedProblem::prepare(double /*load*/, const double* x)
{
  const double parameter = get_parameter(x);
  by_parameter_ = compute_parameter_derivative(parameter, x);
  problem_.prepare(parameter, x);
  problem_.solve(by_parameter_.data(), by_parameter_.data());
}

void BorderedProblem::solve(const double* r, double* d)
{
  const double off_plane =
      communicator_.sum(holds_parameter_ ? r[size_] : 0.) / stiffness_;
  problem_.solve(r, d);
  const PathVector step{std::vector<double>(d, d + size_), 0};
  PathVector border{by_parameter_, -1};
  const double dp =
      (off_plane - dot(plane_.normal, step, metric_, communicator_)) /
      -dot(plane_.normal, border, metric_, communicator_);
  for (std::size_t i = 0; i < size_; ++i)
    d[i] -= dp * by_parameter_[i];
  if (holds_parameter_)
    d[size_] = dp;
}

double BorderedProblem::reference_force() const
{
  return problem_.reference_force();
}

double BorderedProblem::round_off_force() const
{
  return problem_.round_off_force();
}

bool BorderedProblem::takes_full_steps() const
{
  return problem_.takes_full_steps();
}

void BorderedProblem::forget_iteration()
{
  problem_.forget_iteration();
}

void BorderedProblem::check_equilibrium(double /*load*/, const double* x)
{
  problem_.check_equilibrium(get_parameter(x), x);
}
} // namespace taut::time
