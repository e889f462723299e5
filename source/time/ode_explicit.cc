#include <taut/base/exceptions.h>

#include <arkode/arkode_butcher_erk.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "ode_stepper.h"

namespace taut::time
{
namespace
{
using State = std::vector<double>;

struct FreeTable
{
  void operator()(ARKodeButcherTableMem* const table) const
  {
    ARKodeButcherTable_Free(table);
  }
};
using Table = std::unique_ptr<ARKodeButcherTableMem, FreeTable>;

/// Order 5, and 4 for the error; chosen by measurement: its error estimate is
/// reliable where those of the tables of order 6 and 8 are blind to a
/// right-hand side that depends mostly on time.
Table make_table()
{
  Table table(ARKodeButcherTable_LoadERK(ARKODE_DORMAND_PRINCE_7_4_5));
  if (!table)
    throw SolverFailed("ARKODE has no table of Dormand and Prince's method");
  return table;
}

class ExplicitStepper : public OdeStepper
{
public:
  ExplicitStepper(const OdeProblem& problem, const OdeOptions& options,
                  OdeStatistics& statistics)
      : problem_(problem), options_(options), statistics_(statistics),
        table_(make_table()), stages_(table_->stages, State(problem.size)),
        stage_state_(problem.size)
  {
  }

  void start(const double time, const double end, const State& y) override
  {
    time_ = step_start_ = time;
    end_ = end;
    state_ = old_state_ = y;
    old_rate_.resize(y.size());
    rate_.resize(y.size());
    evaluate(time, state_, rate_);
    step_ = choose_first_step();
  }

  void advance() override
  {
    for (;;)
    {
      const bool last = step_ >= (end_ - time_) * (1 - 1e-12);
      const double h = last ? end_ - time_ : step_;
      const double end = last ? end_ : time_ + h;
      bool accepted = false;
      step_ = std::min(h * try_step(h, accepted), options_.largest_step);
      if (accepted)
        return accept(end);
      ++statistics_.rejected;
      if (time_ + step_ / 8 == time_)
        throw SolverFailed("the time step vanished at t = " +
                           std::to_string(time_) + ": " + reason_);
    }
  }

  double step_start() const override
  {
    return step_start_;
  }
  double time() const override
  {
    return time_;
  }
  const State& state() const override
  {
    return state_;
  }

  /// Repeats the step with another length, which is as accurate as the step.
  void interpolate(const double time, State& y) override
  {
    if (time == time_)
      y = state_;
    else
    {
      stages_[0] = old_rate_;
      compute_stages(step_start_, old_state_, time - step_start_);
      y = stage_state_;
    }
  }

  /// The cubic through states and rates at both ends.
  void estimate(const double time, State& y) override
  {
    const double h = time_ - step_start_;
    const double s = (time - step_start_) / h, r = 1 - s;
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] = r * r * ((1 + 2 * s) * old_state_[i] + s * h * old_rate_[i]) +
             s * s * ((1 + 2 * r) * state_[i] - r * h * rate_[i]);
  }

private:
  void evaluate(const double time, const State& y, State& rate)
  {
    ++statistics_.evaluations;
    problem_.rate(time, y.data(), rate.data());
  }

  /// result = y + h sum of the first `count` stages by weight.
  void combine(const State& y, const double h, const double* const weights,
               const int count, State& result) const
  {
    result = y;
    for (int j = 0; j < count; ++j)
      if (weights[j] != 0)
        for (std::size_t i = 0; i < y.size(); ++i)
          result[i] += h * weights[j] * stages_[j][i];
  }

  /// All stages but the first, which must be there. The last one is the rate at
  /// the end of the step, so that stage_state_ is then the new state.
  void compute_stages(const double time, const State& y, const double h)
  {
    for (int j = 1; j < table_->stages; ++j)
    {
      combine(y, h, table_->A[j], j, stage_state_);
      evaluate(time + table_->c[j] * h, stage_state_, stages_[j]);
    }
  }

  /// Largest error component of the step in units of the tolerance.
  double measure_error(const double h) const
  {
    double largest = 0;
    for (std::size_t i = 0; i < state_.size(); ++i)
    {
      double error = 0;
      for (int j = 0; j < table_->stages; ++j)
        error += h * (table_->b[j] - table_->d[j]) * stages_[j][i];
      const double tolerance =
          options_.absolute_tolerance +
          options_.relative_tolerance *
              std::max(std::abs(state_[i]), std::abs(stage_state_[i]));
      // Not std::max, which would lose a NaN.
      if (!(std::abs(error) <= largest * tolerance))
        largest = std::abs(error) / tolerance;
    }
    return largest;
  }

  /// A hundredth of the time in which the state changes by itself.
  double choose_first_step() const
  {
    double size = options_.absolute_tolerance, speed = 0;
    for (std::size_t i = 0; i < state_.size(); ++i)
    {
      size = std::max(size, std::abs(state_[i]));
      speed = std::max(speed, std::abs(rate_[i]));
    }
    const double span = std::min(end_ - time_, options_.largest_step);
    return speed > 0 ? std::min(0.01 * size / speed, span) : 0.01 * span;
  }

  /// Makes the stages and returns by how much the next step should be longer.
  double try_step(const double h, bool& accepted)
  {
    try
    {
      stages_[0] = rate_;
      compute_stages(time_, state_, h);
    }
    catch (const StepRejected& rejection)
    {
      reason_ = rejection.what();
      return 0.25;
    }
    const double error = measure_error(h);
    reason_ = "its local error stays above the tolerance";
    if (!std::isfinite(error))
      return 0.2;
    accepted = error <= 1;
    const double change =
        0.9 * std::pow(std::max(error, 1e-10), -1. / table_->q);
    return accepted ? std::clamp(change, 0.9, 5.) : std::max(change, 0.2);
  }

  void accept(const double time)
  {
    ++statistics_.steps;
    step_start_ = time_;
    time_ = time;
    old_state_.swap(state_);
    state_.swap(stage_state_);
    old_rate_.swap(rate_);
    rate_.swap(stages_.back());
  }

  const OdeProblem& problem_;
  const OdeOptions& options_;
  OdeStatistics& statistics_;
  Table table_;
  double time_ = 0;
  double step_start_ = 0;
  double end_ = 0;
  double step_ = 0;
  std::vector<State> stages_;
  State state_, old_state_, rate_, old_rate_, stage_state_;
  std::string reason_;
};
} // namespace

std::unique_ptr<OdeStepper> make_explicit_stepper(const OdeProblem& problem,
                                                  const OdeOptions& options,
                                                  OdeStatistics& statistics)
{
  return std::make_unique<ExplicitStepper>(problem, options, statistics);
}
} // namespace taut::time
