#include <idas/idas.h>

#include <algorithm>
#include <vector>

#include "integrate_stepper.h"
#include "integrate_weights.h"
#include "system_sundials.h"

namespace taut::time
{
namespace
{
/// cj B - df/dy.
class ResidualMatrix : public MatrixOperations
{
public:
  explicit ResidualMatrix(GuardedSystem& system) : system_(system) {}

  int solve(double* b, double* x) override
  {
    return system_.solve(b, x);
  }

private:
  GuardedSystem& system_;
};

/// What the callbacks of IDA find behind user_data.
struct UserData
{
  GuardedSystem& system;
  ErrorWeights weights;
  std::vector<double> f;
};

UserData& get(void* user_data)
{
  return *static_cast<UserData*>(user_data);
}

/// B y' - f(t, y).
int compute_residual(realtype time, N_Vector state, N_Vector rate,
                     N_Vector residual, void* user_data)
{
  UserData& data = get(user_data);
  double* r = get_data(residual);
  const int evaluated =
      data.system.evaluate(time, get_data(state), data.f.data());
  if (evaluated != 0)
    return evaluated;
  const int multiplied = data.system.multiply_mass(get_data(rate), r);
  for (std::size_t i = 0; i < data.f.size(); ++i)
    r[i] -= data.f[i];
  return multiplied;
}

int prepare(realtype time, realtype cj, N_Vector state, N_Vector /*rate*/,
            N_Vector /*residual*/, SUNMatrix /*matrix*/, void* user_data,
            N_Vector /*t1*/, N_Vector /*t2*/, N_Vector /*t3*/)
{
  return get(user_data).system.prepare(time, get_data(state), cj);
}

int fill_weights(N_Vector /*state*/, N_Vector weights, void* user_data)
{
  const UserData& data = get(user_data);
  data.weights.fill(data.system.layout(), get_data(weights));
  return 0;
}

class IdaStepper : public Stepper
{
public:
  IdaStepper(GuardedSystem& system, const IntegratorOptions& options,
             const Segment& segment);

  double advance() override;
  const double* state() const override
  {
    return state_.data();
  }
  int order() const override;
  void interpolate(double time, double* state) override;
  IntegratorStatistics statistics() const override;

private:
  void compute_consistent_rate();
  void set_up(const IntegratorOptions& options);
  void set_up_algebra(const IntegratorOptions& options);

  GuardedSystem& system_;
  UserData data_;
  double stop_;
  double begin_time_;
  double end_time_;
  std::vector<double> state_;
  std::vector<double> rate_;
  /// 1 for a differential, 0 for an algebraic unknown.
  std::vector<double> kinds_;
  std::string message_;
  ResidualMatrix operations_;
  ContextHandle context_;
  VectorHandle state_vector_;
  VectorHandle rate_vector_;
  VectorHandle kind_vector_;
  MatrixHandle matrix_;
  LinearSolverHandle solver_;
  SolverMemoryHandle<IDAFree> memory_;
};

IdaStepper::IdaStepper(GuardedSystem& system, const IntegratorOptions& options,
                       const Segment& segment)
    : system_(system), data_{system,
                             compute_error_weights(system.sizes(), options),
                             std::vector<double>(system.layout().size())},
      stop_(segment.stop), begin_time_(segment.start), end_time_(segment.start),
      state_(segment.state, segment.state + system.layout().size()),
      rate_(state_.size(), 0.), kinds_(state_.size(), 1.), operations_(system),
      context_(make_context()),
      state_vector_(make_vector(system.communicator(), state_.size(),
                                state_.data(), context_.get())),
      rate_vector_(make_vector(system.communicator(), rate_.size(),
                               rate_.data(), context_.get())),
      kind_vector_(make_vector(system.communicator(), kinds_.size(),
                               kinds_.data(), context_.get())),
      matrix_(make_matrix(operations_, context_.get())),
      solver_(make_linear_solver(operations_, context_.get())),
      memory_(IDACreate(context_.get()))
{
  check(memory_.get(), "IDACreate");
  compute_consistent_rate();
  set_up(options);
  set_up_algebra(options);
}

void IdaStepper::compute_consistent_rate()
{
  system_.compute_f(begin_time_, state_.data(), data_.f.data());
  if (system_.is_inertial())
  {
    system_.get_system().solve_mass(data_.f.data(), rate_.data());
    return;
  }
  // The positions follow from an equation, not from a rate: theirs is unknown
  // and the tiny first step forgives a zero.
  const std::size_t n = system_.layout().positions;
  std::copy(data_.f.begin() + n, data_.f.end(), rate_.begin() + n);
  std::fill_n(kinds_.begin(), n, 0.);
}

void IdaStepper::set_up(const IntegratorOptions& options)
{
  void* memory = memory_.get();
  check(IDASetErrHandlerFn(memory, taut_keep_message, &message_),
        "IDASetErrHandlerFn");
  check(IDAInit(memory, compute_residual, begin_time_, state_vector_.get(),
                rate_vector_.get()),
        "IDAInit");
  check(IDASetUserData(memory, &data_), "IDASetUserData");
  check(IDAWFtolerances(memory, fill_weights), "IDAWFtolerances");
  check(IDASetId(memory, kind_vector_.get()), "IDASetId");
  check(IDASetMaxOrd(memory, options.max_order), "IDASetMaxOrd");
  check(IDASetInitStep(memory, options.first_step), "IDASetInitStep");
  if (options.largest_step > 0)
    check(IDASetMaxStep(memory, options.largest_step), "IDASetMaxStep");
  check(IDASetStopTime(memory, stop_), "IDASetStopTime");
  check(IDASetMaxErrTestFails(memory, max_failures_per_step),
        "IDASetMaxErrTestFails");
  check(IDASetMaxConvFails(memory, max_failures_per_step),
        "IDASetMaxConvFails");
}

void IdaStepper::set_up_algebra(const IntegratorOptions& options)
{
  void* memory = memory_.get();
  check(IDASetLinearSolver(memory, solver_.get(), matrix_.get()),
        "IDASetLinearSolver");
  check(IDASetJacFn(memory, prepare), "IDASetJacFn");
  // The symmetric part of the tangent may stand for it: more, slower steps.
  check(IDASetMaxNonlinIters(memory, 10), "IDASetMaxNonlinIters");
  check(IDASetDeltaCjLSetup(memory, options.max_gamma_change),
        "IDASetDeltaCjLSetup");
}

double IdaStepper::advance()
{
  system_.guard().forget();
  begin_time_ = end_time_;
  const int flag =
      IDASolve(memory_.get(), stop_, &end_time_, state_vector_.get(),
               rate_vector_.get(), IDA_ONE_STEP);
  if (flag < 0)
    fail(system_.guard(), begin_time_,
         take_name(IDAGetReturnFlagName(flag)) + ": " + message_);
  require_progress(system_.guard(), begin_time_, end_time_);
  return end_time_;
}

int IdaStepper::order() const
{
  int order = 0;
  check(IDAGetLastOrder(memory_.get(), &order), "IDAGetLastOrder");
  return order;
}

void IdaStepper::interpolate(const double time, double* state)
{
  const VectorHandle result =
      make_vector(system_.communicator(), state_.size(), state, context_.get());
  check(IDAGetDky(memory_.get(), time, 0, result.get()), "IDAGetDky");
}

IntegratorStatistics IdaStepper::statistics() const
{
  void* memory = memory_.get();
  IntegratorStatistics counts;
  check(IDAGetNumErrTestFails(memory, &counts.rejected_by_error),
        "IDAGetNumErrTestFails");
  check(IDAGetNumStepSolveFails(memory, &counts.rejected_by_newton),
        "IDAGetNumStepSolveFails");
  check(IDAGetNumNonlinSolvIters(memory, &counts.newton_iterations),
        "IDAGetNumNonlinSolvIters");
  return counts;
}
} // namespace

std::unique_ptr<Stepper> make_ida_stepper(GuardedSystem& system,
                                          const IntegratorOptions& options,
                                          const Segment& segment)
{
  return std::make_unique<IdaStepper>(system, options, segment);
}
} // namespace taut::time
