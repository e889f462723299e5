#include <taut/base/exceptions.h>
#include <taut/time/equilibrium.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace taut::time
{
namespace
{
/// Newton's iterations up to which the next step grows.
constexpr unsigned int few_iterations = 5;
constexpr double growth = 1.8;
constexpr double cut_back = 0.5;

void add(EquilibriumStatistics& sum, const EquilibriumStatistics& part)
{
  sum.iterations += part.iterations;
  sum.residuals += part.residuals;
  sum.factorisations += part.factorisations;
  sum.final_residual = part.final_residual;
}

/// The last two equilibria of a path.
class Path
{
public:
  Path(EquilibriumProblem& problem, const double start, double* u,
       const PathOptions& options)
      : problem_(problem), options_(options), load_(start), u_(u),
        previous_(problem.n_unknowns()), trial_(problem.n_unknowns())
  {
  }

  /// Goes to the equilibrium at `load`; false if there is none in reach.
  bool advance(double load);
  double load() const
  {
    return load_;
  }
  /// Of the last step that succeeded.
  const EquilibriumStatistics& statistics() const
  {
    return statistics_;
  }
  /// Why the last step failed.
  const std::string& rejection() const
  {
    return rejection_;
  }

private:
  EquilibriumStatistics try_from_prediction(double load);
  EquilibriumStatistics try_from_last(double load);

  EquilibriumProblem& problem_;
  const PathOptions& options_;
  double load_;
  double* u_;
  double previous_load_ = 0;
  bool previous_known_ = false;
  std::vector<double> previous_;
  std::vector<double> trial_;
  EquilibriumStatistics statistics_;
  std::string rejection_;
};

EquilibriumStatistics Path::try_from_last(const double load)
{
  std::copy_n(u_, trial_.size(), trial_.begin());
  return find_equilibrium(problem_, load, trial_.data(), options_.newton);
}

EquilibriumStatistics Path::try_from_prediction(const double load)
{
  if (!previous_known_)
    return try_from_last(load);
  const double ratio = (load - load_) / (load_ - previous_load_);
  for (std::size_t i = 0; i < trial_.size(); ++i)
    trial_[i] = u_[i] + ratio * (u_[i] - previous_[i]);
  try
  {
    return find_equilibrium(problem_, load, trial_.data(), options_.newton);
  }
  catch (const StepRejected&)
  {
    return try_from_last(load);
  }
}

bool Path::advance(const double load)
{
  try
  {
    statistics_ = try_from_prediction(load);
  }
  catch (const StepRejected& rejection)
  {
    rejection_ = rejection.what();
    return false;
  }
  std::copy_n(u_, trial_.size(), previous_.begin());
  std::copy(trial_.begin(), trial_.end(), u_);
  previous_load_ = load_;
  previous_known_ = true;
  load_ = load;
  return true;
}

void validate(const PathOptions& options)
{
  if (!(options.first_step > 0 && options.smallest_step > 0 &&
        options.largest_step > 0))
    throw BadInput("the steps of a load path must be positive");
}

[[noreturn]] void give_up(const double load, const std::string& reason)
{
  std::ostringstream message;
  message.precision(12);
  message << "no equilibrium beyond load " << load
          << " with the smallest step: " << reason;
  throw SolverFailed(message.str());
}
} // namespace

EquilibriumStatistics
follow_path(EquilibriumProblem& problem, const double start, const double end,
            double* u, const PathOptions& options,
            const std::function<void(double, const double*)>& accepted)
{
  validate(options);
  const double direction = end < start ? -1 : 1;
  EquilibriumStatistics sum;
  Path path(problem, start, u, options);
  double step = std::min(options.first_step, options.largest_step);
  while (path.load() != end)
  {
    const double rest = std::abs(end - path.load());
    const double target = rest <= step ? end : path.load() + direction * step;
    if (path.advance(target))
    {
      add(sum, path.statistics());
      accepted(target, u);
      if (path.statistics().iterations <= few_iterations)
        step = std::min(growth * step, options.largest_step);
      continue;
    }
    step = cut_back * std::min(step, rest);
    if (step < options.smallest_step)
      give_up(path.load(), path.rejection());
  }
  return sum;
}
} // namespace taut::time
