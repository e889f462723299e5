#pragma once

#include <taut/material/elastomer.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint.hpp>

// A virtual rheometer: homogeneous tests of an elastomer without finite
// elements. Stretches are principal, the first axis is the one that is driven.
namespace taut::material
{
enum class Shape
{
  uniaxial,   ///< no force across
  pure_shear, ///< width held
  equibiaxial ///< both axes equal
};

using Internal = std::vector<SymmetricTensor2<double>>;

struct Specimen
{
  Elastomer elastomer;
  Shape shape;
  double width = 1.; ///< the stretch across that pure shear holds

  Internal make_virgin() const
  {
    return Internal(elastomer.networks.size(), make_identity<double>());
  }
};

/// The answer of a specimen at a given stretch, networks frozen.
struct Answer
{
  SymmetricTensor2<double> metric;
  double stress;        ///< nominal, along the driven axis, in Pa
  double stress_across; ///< nominal, in Pa
  double tangent;       ///< d stress/d stretch in Pa
};

/// Field at 299 K whose (V/H)^2 is given.
inline Field make_field(double nominal_squared)
{
  return {nominal_squared, 299.};
}

inline Answer compute_answer(const Specimen& specimen, const Internal& internal,
                             double stretch, double across, const Field& field)
{
  Answer answer;
  answer.metric = {stretch * stretch, across * across, 0.};
  SymmetricTensor2<double> S;
  Matrix3<double> D;
  stress_and_stiffness(specimen.elastomer, answer.metric, internal.data(),
                       field, frozen, S, D);
  answer.stress = stretch * S.xx;
  answer.stress_across = across * S.yy;
  double stiffness = D[0][0];
  if (specimen.shape == Shape::equibiaxial)
    stiffness += D[0][1];
  if (specimen.shape == Shape::uniaxial)
    stiffness -= D[0][1] * D[1][0] / D[1][1];
  answer.tangent = S.xx + stretch * stretch * stiffness;
  return answer;
}

/// The stretch across at which S_yy = 0: Newton from the incompressible one.
inline double find_free_width(const Specimen& specimen,
                              const Internal& internal, double stretch,
                              const Field& field)
{
  double width = 1. / std::sqrt(stretch);
  for (unsigned int step = 0; step < 60; ++step)
  {
    SymmetricTensor2<double> S;
    Matrix3<double> D;
    const SymmetricTensor2<double> C = {stretch * stretch, width * width, 0.};
    stress_and_stiffness(specimen.elastomer, C, internal.data(), field, frozen,
                         S, D);
    const double change = -S.yy / (D[1][1] * width);
    width += change;
    if (std::abs(change) < 4e-16 * width)
      return width;
    if (step > 30 && std::abs(change) < 1e-14 * width)
      return width;
  }
  throw std::runtime_error("the free width was not found");
}

inline Answer compute_answer(const Specimen& specimen, const Internal& internal,
                             double stretch, const Field& field)
{
  double across = stretch;
  if (specimen.shape == Shape::pure_shear)
    across = specimen.width;
  if (specimen.shape == Shape::uniaxial)
    across = find_free_width(specimen, internal, stretch, field);
  return compute_answer(specimen, internal, stretch, across, field);
}

/// The root of a function between two points of opposite sign, to rounding.
template <class Function>
double find_root(const Function& function, double low, double high)
{
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(52),
      iterations);
  return (bracket.first + bracket.second) / 2.;
}

/// The stretch in [low, high] at which the specimen carries `stress`.
inline double find_stretch(const Specimen& specimen, const Internal& internal,
                           double stress, const Field& field, double low,
                           double high)
{
  return find_root(
      [&](double stretch) {
        return compute_answer(specimen, internal, stretch, field).stress -
               stress;
      },
      low, high);
}

/// What the driven axis is told, in time.
struct Program
{
  std::function<double(double)> stretch; ///< empty if the stress is given
  std::function<double(double)> stress;  ///< nominal, in Pa
  std::function<double(double)> nominal_squared; ///< (V/H)^2; empty for none
};

struct Reading
{
  double stretch;
  double stress; ///< nominal, in Pa
  Internal internal;
};

/// Runs a program from virgin networks and reads at the given times (the
/// program must be smooth between them).
class Rheometer
{
public:
  Rheometer(Specimen specimen, Program program)
      : specimen_(std::move(specimen)), program_(std::move(program))
  {
  }

  std::vector<Reading> run(const std::vector<double>& times) const
  {
    namespace odeint = boost::numeric::odeint;
    // Relative and absolute 1e-12 per step: far below what is compared.
    auto stepper = odeint::make_controlled(
        1e-12, 1e-12, odeint::runge_kutta_dopri5<std::vector<double>>());
    std::vector<double> state = pack(specimen_.make_virgin());
    std::vector<Reading> readings;
    double time = 0.;
    for (const double next : times)
    {
      if (next > time)
        odeint::integrate_adaptive(
            stepper,
            [this](const std::vector<double>& y, std::vector<double>& rate,
                   double t) { compute_rates(y, rate, t); },
            state, time, next, 1e-6 * (next - time));
      time = next;
      readings.push_back(read(unpack(state), time));
    }
    return readings;
  }

  static std::vector<double> pack(const Internal& internal)
  {
    std::vector<double> state;
    for (const SymmetricTensor2<double>& A : internal)
      state.insert(state.end(), {A.xx, A.yy, A.xy});
    return state;
  }

  static Internal unpack(const std::vector<double>& state)
  {
    Internal internal(state.size() / 3);
    for (std::size_t i = 0; i < internal.size(); ++i)
      internal[i] = {state[3 * i], state[3 * i + 1], state[3 * i + 2]};
    return internal;
  }

private:
  Field get_field(double time) const
  {
    return make_field(program_.nominal_squared ? program_.nominal_squared(time)
                                               : 0.);
  }

  double get_stretch(const Internal& internal, double time) const
  {
    if (program_.stretch)
      return program_.stretch(time);
    // The branch next to the undeformed state, where the tangent is positive.
    double stretch = 1.;
    for (unsigned int step = 0; step < 60; ++step)
    {
      const Answer answer =
          compute_answer(specimen_, internal, stretch, get_field(time));
      const double change =
          (program_.stress(time) - answer.stress) / answer.tangent;
      stretch += change;
      if (std::abs(change) < 1e-14 * stretch)
        return stretch;
    }
    throw std::runtime_error("no stretch carries the prescribed stress");
  }

  Reading read(const Internal& internal, double time) const
  {
    const double stretch = get_stretch(internal, time);
    const Answer answer =
        compute_answer(specimen_, internal, stretch, get_field(time));
    return {stretch, answer.stress, internal};
  }

  void compute_rates(const std::vector<double>& state,
                     std::vector<double>& rate, double time) const
  {
    const Internal internal = unpack(state);
    const double stretch = get_stretch(internal, time);
    const Answer answer =
        compute_answer(specimen_, internal, stretch, get_field(time));
    Internal A_rate(internal.size());
    rates(specimen_.elastomer, answer.metric, internal.data(), A_rate.data());
    rate = pack(A_rate);
  }

  Specimen specimen_;
  Program program_;
};

/// The time at which a specimen under constant stress and voltage, virgin at
/// time 0, reaches a vanishing tangent. The stretch is the independent
/// variable: dt/dl = -tangent/(stress rate of the flow), which ends at a
/// maximum of t(l) where integration over time would meet a square root.
inline double find_pull_in_time(const Specimen& specimen, double stress,
                                const Field& field, double highest_stretch)
{
  namespace odeint = boost::numeric::odeint;
  using State = std::vector<double>; // internal variables, then time
  const auto tangent = [&](const State& state, double stretch)
  {
    const Internal internal =
        Rheometer::unpack(State(state.begin(), state.end() - 1));
    return compute_answer(specimen, internal, stretch, field).tangent;
  };
  const auto slope = [&](const State& state, State& by_stretch, double stretch)
  {
    const Internal internal =
        Rheometer::unpack(State(state.begin(), state.end() - 1));
    const Answer answer = compute_answer(specimen, internal, stretch, field);
    Internal A_rate(internal.size());
    rates(specimen.elastomer, answer.metric, internal.data(), A_rate.data());
    const double flow =
        stretch * stress_change(specimen.elastomer, answer.metric,
                                internal.data(), A_rate.data())
                      .xx;
    by_stretch = Rheometer::pack(A_rate);
    by_stretch.push_back(1.);
    for (double& entry : by_stretch)
      entry *= -answer.tangent / flow;
  };
  State state = Rheometer::pack(specimen.make_virgin());
  state.push_back(0.);
  const double start = find_stretch(specimen, specimen.make_virgin(), stress,
                                    field, 1., highest_stretch);
  auto stepper = odeint::make_dense_output(1e-13, 1e-13,
                                           odeint::runge_kutta_dopri5<State>());
  stepper.initialize(state, start, 1e-4 * start);
  std::pair<double, double> step = stepper.do_step(slope);
  while (tangent(stepper.current_state(), step.second) > 0.)
  {
    if (!(step.second < 2. * highest_stretch))
      throw std::runtime_error("no pull-in at the stretches looked at");
    step = stepper.do_step(slope);
  }
  const double end = find_root(
      [&](double stretch)
      {
        State inside(state.size());
        stepper.calc_state(stretch, inside);
        return tangent(inside, stretch);
      },
      step.first, step.second);
  stepper.calc_state(end, state);
  return state.back();
}
} // namespace taut::material
