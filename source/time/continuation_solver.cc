#include "continuation_solver.h"

#include <taut/base/exceptions.h>

#include <cmath>

#include <boost/math/tools/roots.hpp>

namespace taut::time
{
PathVector interpolate(const PathState& a, const PathState& b, const double way,
                       const double distance)
{
  const double rest = 1 - way;
  PathVector x = add(a.x, way * way * (3 - 2 * way), add(b.x, -1, a.x));
  x = add(x, distance * way * rest * rest, a.tangent);
  return add(x, -distance * way * way * rest, b.tangent);
}

PathSolver::PathSolver(EquilibriumProblem& problem, const double start,
                       const double end, const EquilibriumOptions& options)
    : problem_(problem), options_(options),
      communicator_(problem.communicator()), bordered_(problem, start, end)
{
  metric_.parameter = std::abs(end - start);
}

double PathSolver::norm(const PathVector& a) const
{
  return std::sqrt(dot(a, a));
}

PathVector PathSolver::make_unit(const PathVector& a) const
{
  const double length = norm(a);
  if (!(length > 0) || !std::isfinite(length))
    throw StepRejected("the path has no direction");
  PathVector unit = a;
  for (double& component : unit.u)
    component /= length;
  unit.parameter /= length;
  return unit;
}

double PathSolver::distance(const PathState& a, const PathState& b) const
{
  return norm(add(b.x, -1, a.x));
}

void PathSolver::find_tangent(PathState& state, const PathVector& forward)
{
  const double parameter = state.x.parameter;
  PathVector tangent{
      bordered_.compute_parameter_derivative(parameter, state.x.u.data()), -1};
  problem_.prepare(parameter, state.x.u.data());
  ++statistics.newton.factorisations;
  state.negative_eigenvalues = problem_.count_negative_eigenvalues();
  problem_.solve(tangent.u.data(), tangent.u.data());
  state.tangent = make_unit(tangent);
  if (dot(state.tangent, forward) < 0)
    state.tangent = add(state.tangent, -2, state.tangent);
}

PathState PathSolver::find(const PathPlane& plane, const PathVector& guess,
                           const PathVector& forward)
{
  bordered_.set_plane(plane, metric_, guess);
  std::vector<double> x = bordered_.pack(guess);
  const auto found = find_equilibrium(bordered_, 0, x.data(), options_);
  statistics.newton.iterations += found.iterations;
  statistics.newton.residuals += found.residuals;
  statistics.newton.factorisations += found.factorisations;
  statistics.newton.final_residual = found.final_residual;
  PathState state;
  state.x = bordered_.unpack(x.data());
  find_tangent(state, forward);
  return state;
}

PathState PathSolver::find_at(const double parameter, const PathVector& guess,
                              const PathVector& forward)
{
  PathVector normal{std::vector<double>(guess.u.size(), 0.), metric_.parameter};
  PathVector origin = guess;
  origin.parameter = parameter;
  PathState state = find({normal, origin, 0}, origin, forward);
  // The plane holds it up to round-off.
  state.x.parameter = parameter;
  return state;
}

PathState PathSolver::find_between(const PathState& a, const PathState& b,
                                   const double distance)
{
  const double chord = this->distance(a, b);
  const double whole = dot(a.tangent, add(b.x, -1, a.x));
  const PathVector guess = interpolate(a, b, distance / whole, chord);
  PathState state = find({a.tangent, a.x, distance}, guess, a.tangent);
  state.arc_length = a.arc_length + this->distance(a, state);
  return state;
}

PathState PathSolver::find_crossing(const PathState& a, const PathState& b,
                                    const double parameter)
{
  const double chord = distance(a, b);
  const auto miss = [&](const double way)
  { return interpolate(a, b, way, chord).parameter - parameter; };
  double way = b.x.parameter == parameter ? 1. : 0.;
  if (miss(0) * miss(1) < 0)
  {
    std::uintmax_t most = 60;
    const auto bracket = boost::math::tools::toms748_solve(
        miss, 0., 1., boost::math::tools::eps_tolerance<double>(40), most);
    way = .5 * (bracket.first + bracket.second);
  }
  const PathVector guess = interpolate(a, b, way, chord);
  PathState state = find_at(parameter, guess, b.tangent);
  if (norm(add(state.x, -1, guess)) > .5 * chord)
    throw StepRejected("the equilibrium between two points of the path lies on "
                       "another branch");
  state.arc_length = a.arc_length + distance(a, state);
  return state;
}

EigenPair PathSolver::find_nearest_eigenvalue(const std::vector<double>& guess)
{
  return time::find_nearest_eigenvalue(problem_, guess);
}

double PathSolver::compute_load_share(const PathVector& x,
                                      const std::vector<double>& mode)
{
  const auto load =
      bordered_.compute_parameter_derivative(x.parameter, x.u.data());
  double product = 0, square = 0;
  for (std::size_t i = 0; i < mode.size(); ++i)
  {
    product += mode[i] * load[i];
    square += load[i] * load[i];
  }
  square = communicator_.sum(square);
  return square > 0 ? std::abs(communicator_.sum(product)) / std::sqrt(square)
                    : 0.;
}

PathVector PathSolver::find_direction_across(const PathVector& x,
                                             const std::vector<double>& mode)
{
  // K w + mode m = - d residual / d parameter and mode . w = 0, by elimination
  // of m.
  PathVector direction{
      bordered_.compute_parameter_derivative(x.parameter, x.u.data()), 1};
  problem_.prepare(x.parameter, x.u.data());
  ++statistics.newton.factorisations;
  std::vector<double> along = mode;
  problem_.solve(direction.u.data(), direction.u.data());
  problem_.solve(along.data(), along.data());
  double of_direction = 0, of_along = 0;
  for (std::size_t i = 0; i < mode.size(); ++i)
  {
    of_direction += mode[i] * direction.u[i];
    of_along += mode[i] * along[i];
  }
  const double share =
      communicator_.sum(of_direction) / communicator_.sum(of_along);
  for (std::size_t i = 0; i < mode.size(); ++i)
    direction.u[i] = -(direction.u[i] - share * along[i]);
  return direction;
}
} // namespace taut::time
