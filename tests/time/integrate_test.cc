#include <taut/base/exceptions.h>
#include <taut/time/integrate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oscillators.h"

using namespace taut;
using namespace taut::time;

namespace
{
constexpr double frequency = 50;
const double k = std::pow(2 * M_PI * frequency, 2);

/// Relaxation times below, near and far above the period, and a member a
/// thousand times faster that is at rest.
std::vector<Oscillator> make_members(const double scale = 1)
{
  std::vector<Oscillator> members = {
      {1, k, .3 * k, 1e-2, 0, {{1e-3, 0, 1e-3}}},
      {2, 3 * k, .5 * k, 1, 2., {{0, .2, 0}}},
      {1, 1.5 * k, .2 * k, 1e-4, 0, {{5e-4, .1, 0}}},
      {1, 1e6 * k, 0, 1, 0, {{0, 0, 0}}}};
  for (Oscillator& member : members)
  {
    member.mass *= scale;
    member.stiffness *= scale;
    member.viscous_stiffness *= scale;
    member.drag *= scale;
  }
  return members;
}

Oscillators make_system(const double scale = 1)
{
  return Oscillators(make_members(scale), Oscillators::Kind::inertial,
                     MPI_COMM_WORLD);
}

IntegratorOptions make_options(const double tolerance,
                               const Method method = Method::esdirk4)
{
  IntegratorOptions options;
  options.method = method;
  options.position_tolerance = tolerance;
  options.first_step = 1e-7;
  return options;
}

Schedule make_schedule(const double end, const int n_outputs = 0)
{
  Schedule schedule;
  schedule.end = end;
  for (int i = 1; i <= n_outputs; ++i)
    schedule.output_times.push_back(end * i / n_outputs);
  return schedule;
}

/// Norm over all ranks of the error of block 0 (u), 1 (v) or 2 (a).
double compute_error(const Oscillators& system, const double time,
                     const double* state, const int block)
{
  const std::size_t n = system.n_members();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    sum += std::pow(state[block * n + i] - system.get_exact(i, time)[block], 2);
  return std::sqrt(system.sum(sum));
}

/// Relative error of the displacements after five periods.
double measure_accuracy(const Method method, const double tolerance)
{
  Oscillators system = make_system();
  std::vector<double> state = system.make_start();
  integrate(system, state.data(), make_schedule(.1),
            make_options(tolerance, method), {}, {});
  return compute_error(system, .1, state.data(), 0) / 1e-3;
}

/// Largest error of block 0, 1 or 2 at many outputs of a run whose steps all
/// have the length h.
double measure_dense_output(const Method method, const double h,
                            const int block)
{
  Oscillators system({{1, k, .3 * k, 1e-2, 0, {{1e-3, 0, 1e-3}}}},
                     Oscillators::Kind::inertial);
  std::vector<double> state = system.make_start();
  // So loose that only largest_step limits the steps; the problem is linear,
  // so Newton is exact all the same.
  IntegratorOptions options = make_options(1, method);
  options.first_step = options.largest_step = h;
  double error = 0;
  Observer observer;
  observer.output = [&](const double time, const double* y)
  { error = std::max(error, compute_error(system, time, y, block)); };
  integrate(system, state.data(), make_schedule(.02, 997), options, {},
            observer);
  return error;
}

double measure_order(const Method method, const int block)
{
  const double h = .02 / 64;
  return std::log2(measure_dense_output(method, h, block) /
                   measure_dense_output(method, h / 2, block));
}
} // namespace

TEST(Integrate, ErrorFollowsTheTolerance)
{
  // A local error of tol/1e-3 of the amplitude in each of the few hundred
  // steps, each made after the last: below 1e3 tol/1e-3 at the end.
  for (const Method method : {Method::esdirk4, Method::esdirk3, Method::bdf})
  {
    const double coarse = measure_accuracy(method, 1e-8);
    const double fine = measure_accuracy(method, 1e-10);
    EXPECT_LT(coarse, 1e-2);
    EXPECT_LT(fine, 1e-4);
    EXPECT_GT(fine, 0);
  }
}

TEST(Integrate, DenseOutputHasTheOrderOfMethodAndHermite)
{
  // Displacements and internal variables: method of order 4 (3), cubic
  // Hermite of order 4. Velocities: derivative of the cubic, order 3.
  EXPECT_NEAR(measure_order(Method::esdirk4, 0), 4, .3);
  EXPECT_NEAR(measure_order(Method::esdirk4, 1), 3, .3);
  EXPECT_NEAR(measure_order(Method::esdirk4, 2), 4, .3);
  EXPECT_NEAR(measure_order(Method::esdirk3, 0), 3, .3);
}

TEST(Integrate, EnergyIsConservedWithTheDissipatedScalar)
{
  for (const Method method : {Method::esdirk4, Method::esdirk3})
  {
    Oscillators system = make_system();
    std::vector<double> state = system.make_start();
    const double start = system.compute_energy(state.data());
    integrate(system, state.data(), make_schedule(.1),
              make_options(1e-10, method), {}, {});
    const double end = system.compute_energy(state.data());
    const bool owns_scalar = system.layout().scalars > 0;
    const double dissipated = system.sum(owns_scalar ? state.back() : 0);
    EXPECT_LT(end, .9 * start);
    // As accurate as the displacements, 1e-7 of which are a local error.
    EXPECT_NEAR((end + dissipated) / start, 1, 1e-5);
  }
}

TEST(Integrate, OutputAndEventsNeverChangeTheSteps)
{
  std::vector<double> states[2];
  long steps[2];
  for (const int many : {0, 1})
  {
    Oscillators system = make_system();
    states[many] = system.make_start();
    std::vector<Watch> watches;
    if (many)
      watches.push_back({"time", [](const double time, const double*)
                         { return .0123 - time; }});
    steps[many] = integrate(system, states[many].data(),
                            make_schedule(.05, many ? 1000 : 1),
                            make_options(1e-9), watches, {})
                      .statistics.steps;
  }
  EXPECT_EQ(steps[0], steps[1]);
  EXPECT_EQ(states[0], states[1]);
}

TEST(Integrate, OutputsAreMadeOnceAtTheTimesAsked)
{
  Oscillators system = make_system();
  std::vector<double> state = system.make_start();
  Schedule schedule = make_schedule(.01, 7);
  schedule.output_times.insert(schedule.output_times.begin(), {-1, 0});
  schedule.output_times.push_back(.02);
  std::vector<double> times;
  Observer observer;
  observer.output = [&](const double time, const double*)
  { times.push_back(time); };
  integrate(system, state.data(), schedule, make_options(1e-8), {}, observer);
  ASSERT_EQ(times.size(), 8u);
  EXPECT_EQ(times.front(), 0);
  for (int i = 1; i <= 7; ++i)
    EXPECT_DOUBLE_EQ(times[i], .01 * i / 7);
}

TEST(Integrate, ScalarsControlNothing)
{
  // Scaling masses and forces by a power of two changes only the scalar, in
  // exact arithmetic and in floating point.
  std::vector<double> states[2];
  long steps[2];
  for (const int i : {0, 1})
  {
    Oscillators system = make_system(i == 0 ? 1 : std::pow(2., 60));
    states[i] = system.make_start();
    steps[i] = integrate(system, states[i].data(), make_schedule(.05),
                         make_options(1e-9), {}, {})
                   .statistics.steps;
    if (system.layout().scalars > 0)
    {
      EXPECT_GT(states[i].back(), 0);
      states[i].pop_back();
    }
  }
  EXPECT_EQ(steps[0], steps[1]);
  EXPECT_EQ(states[0], states[1]);
}

namespace
{
/// One oscillator and many scalars that nothing changes.
class Padded : public Oscillators
{
public:
  explicit Padded(const std::size_t padding)
      : Oscillators({{1, k, 0, 1, 0, {{1e-3, 0, 0}}}}, Kind::inertial),
        padding_(padding)
  {
  }

  StateLayout layout() const override
  {
    StateLayout layout = Oscillators::layout();
    layout.scalars += padding_;
    return layout;
  }

  void evaluate(const double time, const double* state, double* f) override
  {
    std::fill_n(f, layout().size(), 0.);
    Oscillators::evaluate(time, state, f);
  }

  void multiply_mass(const double* x, double* result) override
  {
    Oscillators::multiply_mass(x, result);
    copy_padding(x, result);
  }

  void solve_mass(const double* b, double* x) override
  {
    Oscillators::solve_mass(b, x);
    copy_padding(b, x);
  }

  void solve(const double* r, double* d) override
  {
    std::fill_n(d + Oscillators::layout().size(), padding_, 0.);
    Oscillators::solve(r, d);
  }

private:
  void copy_padding(const double* from, double* to) const
  {
    const std::size_t begin = Oscillators::layout().size();
    std::copy_n(from + begin, padding_, to + begin);
  }

  std::size_t padding_;
};

double measure_padded_error(const std::size_t padding)
{
  Padded system(padding);
  std::vector<double> state = system.make_start();
  integrate(system, state.data(), make_schedule(.1), make_options(1e-9), {},
            {});
  return std::abs(state[0] - system.get_exact(0, .1)[0]);
}
} // namespace

TEST(Integrate, OtherBlocksDoNotThinOutTheErrorOfThePositions)
{
  // Were the norm a mean over all entries, three hundred more of them would
  // loosen the tolerance by a factor of ten.
  EXPECT_NEAR(measure_padded_error(300) / measure_padded_error(0), 1, 1e-3);
}

TEST(Integrate, StopsExactlyAtAJumpOfTheLoad)
{
  const double jump = .0123, load = 10, omega = std::sqrt(k);
  Oscillators system({{1, k, 0, 1, 0, {{0, 0, 0}}}},
                     Oscillators::Kind::inertial);
  system.set_load({[](double) { return 0.; }, [=](double) { return load; }},
                  {jump});
  std::vector<double> state = system.make_start();
  Schedule schedule = make_schedule(.05);
  // The same time but for round-off: one stop.
  schedule.restart_times = {jump * (1 + 1e-14)};
  int n_ends_at_jump = 0, n_checkpoints = 0;
  Observer observer;
  observer.step = [&](const Step& step, const IntegratorStatistics&)
  {
    EXPECT_TRUE(step.end() <= jump || step.start() >= jump);
    n_ends_at_jump += step.end() == jump;
  };
  observer.checkpoint = [&](const double time, const double*)
  {
    EXPECT_EQ(time, jump);
    ++n_checkpoints;
  };
  integrate(system, state.data(), schedule, make_options(1e-10), {}, observer);
  EXPECT_EQ(n_ends_at_jump, 1);
  EXPECT_EQ(n_checkpoints, 1);
  EXPECT_EQ(system.piece, 1u);
  const double exact = load / k * (1 - std::cos(omega * (.05 - jump)));
  // A hundred steps with local errors of the tolerance.
  EXPECT_NEAR(state[0], exact, 100 * 1e-10);
}

TEST(Integrate, ResumedRunEqualsTheWholeRun)
{
  for (const Method method : {Method::esdirk4, Method::bdf})
    for (const bool by_steps : {false, true})
    {
      Oscillators system = make_system();
      std::vector<double> whole = system.make_start();
      Schedule schedule = make_schedule(.05);
      if (by_steps)
        schedule.restart_every_steps = 37;
      else
        schedule.restart_times = {.0171, .03};
      double saved_time = 0;
      std::vector<double> saved;
      Observer observer;
      observer.checkpoint = [&](const double time, const double* state)
      {
        if (saved.empty())
          saved.assign(state, state + whole.size());
        if (saved_time == 0)
          saved_time = time;
      };
      integrate(system, whole.data(), schedule, make_options(1e-9, method), {},
                observer);
      ASSERT_FALSE(saved_time == 0);
      schedule.start = saved_time;
      integrate(system, saved.data(), schedule, make_options(1e-9, method), {},
                {});
      // The same operations in the same order: equal to the last digit.
      EXPECT_EQ(saved, whole);
    }
}

TEST(Integrate, InterruptionEndsInGoodOrder)
{
  Oscillators system = make_system();
  std::vector<double> state = system.make_start();
  int n_steps = 0;
  double last_output = 0, last_step = 0;
  Observer observer;
  observer.step = [&](const Step& step, const IntegratorStatistics&)
  {
    ++n_steps;
    last_step = step.end();
  };
  observer.interrupted = [&] { return n_steps == 20; };
  observer.output = [&](const double time, const double*)
  { last_output = time; };
  const RunResult result = integrate(system, state.data(), make_schedule(.1),
                                     make_options(1e-9), {}, observer);
  EXPECT_EQ(result.outcome, Outcome::interrupted);
  EXPECT_EQ(n_steps, 20);
  EXPECT_EQ(result.time, last_step);
  EXPECT_EQ(result.time, last_output);
  EXPECT_LT(compute_error(system, result.time, state.data(), 0), 1e-6);
}

TEST(Integrate, RefusesWrongOptions)
{
  const auto attempt = [](const auto& spoil)
  {
    Oscillators system = make_system();
    std::vector<double> state = system.make_start();
    IntegratorOptions options = make_options(1e-8);
    Schedule schedule = make_schedule(.1);
    spoil(options, schedule);
    integrate(system, state.data(), schedule, options, {}, {});
  };
  using Options = IntegratorOptions;
  EXPECT_THROW(attempt([](Options& o, Schedule&) { o.position_tolerance = 0; }),
               BadInput);
  EXPECT_THROW(
      attempt([](Options& o, Schedule&) { o.internal_tolerance = -1; }),
      BadInput);
  EXPECT_THROW(attempt([](Options& o, Schedule&) { o.weight_of_rates = 0; }),
               BadInput);
  EXPECT_THROW(attempt([](Options& o, Schedule&) { o.velocity_time = 0; }),
               BadInput);
  EXPECT_THROW(attempt([](Options& o, Schedule&) { o.first_step = 0; }),
               BadInput);
  EXPECT_THROW(attempt([](Options& o, Schedule&) { o.largest_step = -1; }),
               BadInput);
  EXPECT_THROW(attempt([](Options& o, Schedule&) { o.max_order = 6; }),
               BadInput);
  EXPECT_THROW(attempt([](Options& o, Schedule&) { o.max_gamma_change = 1; }),
               BadInput);
  EXPECT_THROW(attempt([](Options&, Schedule& s) { s.end = s.start; }),
               BadInput);
}
