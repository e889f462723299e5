#include <taut/base/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "members.h"

using namespace taut;
using namespace taut::time;

namespace
{
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
