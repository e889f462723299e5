#include <taut/base/exceptions.h>

#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cmath>
#include <string>

#include "system_callback.h"
#include "communicator.h"
#include "ode_stepper.h"
#include "system_sundials.h"

namespace taut::time
{
namespace
{
/// What CVODE works with; destroyed from the last to the first.
struct Workspace
{
  explicit Workspace(std::vector<double>& y)
      : context(make_context()),
        state(make_vector(Communicator(MPI_COMM_SELF), y.size(), y.data(),
                          context.get())),
        matrix(SUNDenseMatrix(size(y), size(y), context.get())),
        solver(SUNLinSol_Dense(state.get(), matrix.get(), context.get())),
        cvode(CVodeCreate(CV_BDF, context.get()))
  {
    check(matrix.get(), "SUNDenseMatrix");
    check(solver.get(), "SUNLinSol_Dense");
    check(cvode.get(), "CVodeCreate");
  }
  static sunindextype size(const std::vector<double>& y)
  {
    return static_cast<sunindextype>(y.size());
  }

  ContextHandle context;
  VectorHandle state;
  MatrixHandle matrix;
  LinearSolverHandle solver;
  SolverMemoryHandle<CVodeFree> cvode;
};

class ImplicitStepper : public OdeStepper
{
public:
  ImplicitStepper(const OdeProblem& problem, const OdeOptions& options,
                  OdeStatistics& statistics)
      : problem_(problem), options_(options), statistics_(statistics)
  {
  }

  void start(const double time, const double end,
             const std::vector<double>& y) override
  {
    step_start_ = time_ = time;
    end_ = end;
    state_ = y;
    work_ = std::make_unique<Workspace>(state_);
    set_up();
  }

  void advance() override
  {
    step_start_ = time_;
    const int flag = CVode(work_->cvode.get(), end_, work_->state.get(), &time_,
                           CV_ONE_STEP);
    guard_.rethrow();
    if (flag < 0 || !(time_ > step_start_))
      throw SolverFailed("CVODE gave up at t = " + std::to_string(time_) +
                         ": " + take_name(CVodeGetReturnFlagName(flag)) + " " +
                         messages_ + guard_.last_rejection());
    guard_.forget();
    ++statistics_.steps;
  }

  double step_start() const override
  {
    return step_start_;
  }
  double time() const override
  {
    return time_;
  }
  const std::vector<double>& state() const override
  {
    return state_;
  }

  void interpolate(const double time, std::vector<double>& y) override
  {
    const auto view = make_vector(Communicator(MPI_COMM_SELF), y.size(),
                                  y.data(), work_->context.get());
    check(CVodeGetDky(work_->cvode.get(), time, 0, view.get()), "CVodeGetDky");
  }

  void estimate(const double time, std::vector<double>& y) override
  {
    interpolate(time, y);
  }

private:
  void set_up()
  {
    void* const cvode = work_->cvode.get();
    check(CVodeInit(cvode, evaluate, time_, work_->state.get()), "CVodeInit");
    check(CVodeSetUserData(cvode, this), "CVodeSetUserData");
    check(CVodeSetErrHandlerFn(cvode, taut_keep_message, &messages_),
          "CVodeSetErrHandlerFn");
    check(CVodeSStolerances(cvode, options_.relative_tolerance,
                            options_.absolute_tolerance),
          "CVodeSStolerances");
    check(CVodeSetLinearSolver(cvode, work_->solver.get(), work_->matrix.get()),
          "CVodeSetLinearSolver");
    check(CVodeSetStopTime(cvode, end_), "CVodeSetStopTime");
    if (std::isfinite(options_.largest_step))
      check(CVodeSetMaxStep(cvode, options_.largest_step), "CVodeSetMaxStep");
  }

  static int evaluate(const double time, N_Vector y, N_Vector rate, void* self)
  {
    auto& stepper = *static_cast<ImplicitStepper*>(self);
    ++stepper.statistics_.evaluations;
    const int code = stepper.guard_(
        [&] { stepper.problem_.rate(time, get_data(y), get_data(rate)); });
    stepper.statistics_.rejected += code > 0;
    return code;
  }

  const OdeProblem& problem_;
  const OdeOptions& options_;
  OdeStatistics& statistics_;
  std::unique_ptr<Workspace> work_;
  double time_ = 0;
  double step_start_ = 0;
  double end_ = 0;
  std::vector<double> state_;
  CallbackGuard guard_{Communicator(MPI_COMM_SELF)};
  std::string messages_;
};
} // namespace

std::unique_ptr<OdeStepper> make_implicit_stepper(const OdeProblem& problem,
                                                  const OdeOptions& options,
                                                  OdeStatistics& statistics)
{
  return std::make_unique<ImplicitStepper>(problem, options, statistics);
}
} // namespace taut::time
