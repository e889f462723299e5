#include <taut/base/exceptions.h>

#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <utility>

#include "ode_stepper.h"

namespace taut::time
{
namespace
{
void check(const int flag, const char* const call)
{
  if (flag < 0)
    throw SolverFailed(std::string(call) + " failed with flag " +
                       std::to_string(flag));
}

template <typename Pointer>
Pointer check_made(const Pointer pointer, const char* const call)
{
  if (pointer == nullptr)
    throw SolverFailed(std::string(call) + " failed");
  return pointer;
}

/// What CVODE works with, made together and freed together.
struct Workspace
{
  explicit Workspace(const std::size_t size)
  {
    check(SUNContext_Create(nullptr, &context), "SUNContext_Create");
    state = check_made(N_VNew_Serial(size, context), "N_VNew_Serial");
    matrix = check_made(SUNDenseMatrix(size, size, context), "SUNDenseMatrix");
    solver =
        check_made(SUNLinSol_Dense(state, matrix, context), "SUNLinSol_Dense");
    cvode = check_made(CVodeCreate(CV_BDF, context), "CVodeCreate");
  }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  ~Workspace()
  {
    CVodeFree(&cvode);
    SUNLinSolFree(solver);
    SUNMatDestroy(matrix);
    N_VDestroy(state);
    SUNContext_Free(&context);
  }

  SUNContext context = nullptr;
  N_Vector state = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver solver = nullptr;
  void* cvode = nullptr;
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
    work_ = std::make_unique<Workspace>(problem_.size);
    step_start_ = time_ = time;
    end_ = end;
    state_ = y;
    std::copy(y.begin(), y.end(), N_VGetArrayPointer(work_->state));
    set_up();
  }

  void advance() override
  {
    step_start_ = time_;
    const int flag =
        CVode(work_->cvode, end_, work_->state, &time_, CV_ONE_STEP);
    if (failure_)
      std::rethrow_exception(std::exchange(failure_, nullptr));
    if (flag < 0 || !(time_ > step_start_))
      throw SolverFailed("CVODE gave up at t = " + std::to_string(time_) +
                         ": " + reason_);
    const double* const y = N_VGetArrayPointer(work_->state);
    std::copy(y, y + state_.size(), state_.begin());
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
    N_Vector view = check_made(
        N_VMake_Serial(y.size(), y.data(), work_->context), "N_VMake_Serial");
    const int flag = CVodeGetDky(work_->cvode, time, 0, view);
    N_VDestroy(view);
    check(flag, "CVodeGetDky");
  }

  void estimate(const double time, std::vector<double>& y) override
  {
    interpolate(time, y);
  }

private:
  void set_up()
  {
    void* const cvode = work_->cvode;
    check(CVodeInit(cvode, evaluate, time_, work_->state), "CVodeInit");
    check(CVodeSetUserData(cvode, this), "CVodeSetUserData");
    check(CVodeSetErrHandlerFn(cvode, keep_message, this),
          "CVodeSetErrHandlerFn");
    check(CVodeSStolerances(cvode, options_.relative_tolerance,
                            options_.absolute_tolerance),
          "CVodeSStolerances");
    check(CVodeSetLinearSolver(cvode, work_->solver, work_->matrix),
          "CVodeSetLinearSolver");
    check(CVodeSetStopTime(cvode, end_), "CVodeSetStopTime");
    if (std::isfinite(options_.largest_step))
      check(CVodeSetMaxStep(cvode, options_.largest_step), "CVodeSetMaxStep");
  }

  /// No exception may cross CVODE: StepRejected asks for a smaller step, all
  /// others are kept for `advance`.
  static int evaluate(const double time, N_Vector y, N_Vector rate, void* self)
  {
    auto& stepper = *static_cast<ImplicitStepper*>(self);
    try
    {
      ++stepper.statistics_.evaluations;
      stepper.problem_.rate(time, N_VGetArrayPointer(y),
                            N_VGetArrayPointer(rate));
      return 0;
    }
    catch (const StepRejected& rejection)
    {
      ++stepper.statistics_.rejected;
      stepper.reason_ = rejection.what();
      return 1;
    }
    catch (...)
    {
      stepper.failure_ = std::current_exception();
      return -1;
    }
  }

  static void keep_message(const int code, const char*, const char*,
                           char* const message, void* self)
  {
    auto& stepper = *static_cast<ImplicitStepper*>(self);
    if (code < 0)
      stepper.reason_ += std::string(" (") + message + ")";
  }

  const OdeProblem& problem_;
  const OdeOptions& options_;
  OdeStatistics& statistics_;
  std::unique_ptr<Workspace> work_;
  double time_ = 0;
  double step_start_ = 0;
  double end_ = 0;
  std::vector<double> state_;
  std::string reason_;
  std::exception_ptr failure_;
};
} // namespace

std::unique_ptr<OdeStepper> make_implicit_stepper(const OdeProblem& problem,
                                                  const OdeOptions& options,
                                                  OdeStatistics& statistics)
{
  return std::make_unique<ImplicitStepper>(problem, options, statistics);
}
} // namespace taut::time
