#pragma once

#include <taut/material/limits.h>
#include <taut/material/wrinkles.h>

// The search for the wrinkles that make the energy smallest, by safeguarded
// Newton iterations on all values of a number at once.
namespace taut::material
{
/// The film with all springs neo-Hookean, S = pull - (push + field) C^-1, from
/// which the search starts: its natural width is known.
template <class Number>
struct NeoHookeanTwin
{
  NeoHookeanTwin(const Elastomer& elastomer, const SymmetricTensor2<Number>& C,
                 InternalVariables<Number> A, const Field& electric)
      : pull{Number(0.), Number(0.), Number(0.)}, push(0.)
  {
    for (const Spring& spring : elastomer.springs)
      add(shear_modulus(spring), make_identity<Number>());
    for (const Network& network : elastomer.networks)
      add(shear_modulus(network.spring), *A++);
    field = electric.nominal_squared *
            charge_density(elastomer, C, electric, 1.) / compute_determinant(C);
  }

  SymmetricTensor2<Number> pull; ///< sum of G A (Pa)
  Number push;                   ///< sum of G/det A (Pa), times 1/det C
  Number field;                  ///< eps (V/H)^2 (Pa), times det C

private:
  void add(const double modulus, const SymmetricTensor2<Number>& A)
  {
    pull = add_scaled(pull, Number(modulus), A);
    push = push + modulus / compute_determinant(A);
  }
};

template <class Number>
Number get_smaller_number(const Number& a, const Number& b)
{
  return select(is_less(a, b), a, b);
}

template <class Number>
Number get_larger_number(const Number& a, const Number& b)
{
  return select(is_less(a, b), b, a);
}

/// A C^-1-orthonormal pair, of which the first is an eigenvector of S in this
/// metric with the smaller eigenvalue.
template <class Number>
WrinkleDirections<Number> find_directions(const SymmetricTensor2<Number>& C,
                                          const SymmetricTensor2<Number>& S)
{
  using std::sqrt;
  // Columns of the Cholesky factor of C.
  const Number length = sqrt(C.xx);
  const Line<Number> first = {length, C.xy / length};
  const Line<Number> second = {Number(0.), sqrt(C.yy - first.y * first.y)};
  const Number half_difference =
      0.5 * (contract(first, S, first) - contract(second, S, second));
  const Number mixed = contract(first, S, second);
  const Number radius =
      sqrt(half_difference * half_difference + mixed * mixed) + 1e-30;
  // The longer one of two forms of the eigenvector.
  const Mask<Number> descends = is_less(half_difference, Number(0.));
  const Number opposite = -mixed, opposite_half = -half_difference;
  const Number longer =
      radius + select(descends, opposite_half, half_difference);
  const Number x = select(descends, longer, opposite);
  const Number y = select(descends, opposite, longer);
  const Number inverse = 1. / sqrt(x * x + y * y);
  const Number c = x * inverse, s = y * inverse;
  return {{c * first.x + s * second.x, c * first.y + s * second.y},
          {c * second.x - s * first.x, c * second.y - s * first.y}};
}

template <class Number>
class WrinkleSearch
{
public:
  /// What is searched for: see find_wrinkles. `internal` outlives the search.
  WrinkleSearch(const Elastomer& elastomer, const SymmetricTensor2<Number>& C,
                InternalVariables<Number> internal, const Field& field,
                double stiffness);

  /// Wrinkles in one direction where `wanted`, S the stress of C; `within`:
  /// whether the film without wrinkles is within its limits.
  Wrinkles<Number> find_one_direction(const SymmetricTensor2<Number>& S,
                                      const Mask<Number>& wanted,
                                      const Mask<Number>& within);

  /// Replaces the wrinkles where `wanted` by those in both directions.
  void find_both_directions(const Mask<Number>& wanted,
                            Wrinkles<Number>& wrinkles);

private:
  using Tensor = SymmetricTensor2<Number>;
  /// A trial of wrinkles in one direction.
  struct Trial
  {
    WrinkleDirections<Number> directions;
    Number amplitude;
  };

  static constexpr unsigned int most_iterations = 40;
  /// Of a Newton step, which leaves the square of it.
  static constexpr double tolerance = 1e-6;
  /// Share of the modulus that the regularising term may carry.
  static constexpr double largest_share = 1e-2;

  Tensor make_metric(const Trial& trial) const;
  Trial make_first_trial(const Tensor& S, const Mask<Number>& within) const;
  Trial make_step(const Trial& trial, const WrinkleEquations<Number>& equations,
                  Mask<Number>& converged, Number& tension) const;
  Tensor make_natural_metric() const;
  Tensor make_step(const Tensor& metric, Mask<Number>& converged) const;
  Mask<Number> is_bounded(const Tensor& metric) const;
  void evaluate(const Tensor& metric, Tensor& T, Matrix3<Number>& D) const;

  static Trial choose_trial(const Mask<Number>& condition, const Trial& a,
                            const Trial& b);
  static Trial retreat(const Trial& trial, const Trial& to);

  const Elastomer& elastomer_;
  const Tensor C_;
  const InternalVariables<Number> internal_;
  const Field field_;
  const NeoHookeanTwin<Number> twin_;
  const double stiffness_; ///< 2 delta G (Pa)
};

template <class Number>
WrinkleSearch<Number>::WrinkleSearch(const Elastomer& elastomer,
                                     const SymmetricTensor2<Number>& C,
                                     InternalVariables<Number> internal,
                                     const Field& field, const double stiffness)
    : elastomer_(elastomer), C_(C), internal_(internal), field_(field),
      twin_(elastomer, C, internal, field), stiffness_(stiffness)
{
}

template <class Number>
SymmetricTensor2<Number>
WrinkleSearch<Number>::make_metric(const Trial& trial) const
{
  const Line<Number>& v = trial.directions.across;
  const Tensor square = {v.x * v.x, v.y * v.y, v.x * v.y};
  return add_scaled(C_, trial.amplitude, square);
}

template <class Number>
auto WrinkleSearch<Number>::choose_trial(const Mask<Number>& condition,
                                         const Trial& a, const Trial& b)
    -> Trial
{
  return {{choose(condition, a.directions.across, b.directions.across),
           choose(condition, a.directions.along, b.directions.along)},
          select(condition, a.amplitude, b.amplitude)};
}

/// Half the way in the width, in the directions that were fine before.
template <class Number>
auto WrinkleSearch<Number>::retreat(const Trial& trial, const Trial& to)
    -> Trial
{
  using std::sqrt;
  return {to.directions,
          sqrt((1. + trial.amplitude) * (1. + to.amplitude)) - 1.};
}

/// With y = 1/(1 + a)^2 the tension of the twin across its wrinkles is
/// pull - field det C - y push/det C, plus 2 delta G v . (1 + a v v^T) v.
template <class Number>
auto WrinkleSearch<Number>::make_first_trial(const Tensor& S,
                                             const Mask<Number>& within) const
    -> Trial
{
  using std::sqrt;
  const auto directions = find_directions(C_, choose(within, S, twin_.pull));
  const Number det = compute_determinant(C_);
  const Number pull =
      contract(directions.across, twin_.pull, directions.across);
  const Number left =
      get_larger_number<Number>(pull - twin_.field * det, 0.05 * pull);
  const Number without_cost = sqrt(twin_.push / (det * left)) - 1.;
  const Number v2 = dot(directions.across, directions.across);
  const Number cost = stiffness_ * v2 * (1. + without_cost * v2);
  const Number square = twin_.push / (det * (left + cost));
  return {directions, sqrt(get_larger_number<Number>(square, Number(1.))) - 1.};
}

template <class Number>
void WrinkleSearch<Number>::evaluate(const Tensor& metric, Tensor& T,
                                     Matrix3<Number>& D) const
{
  Tensor S;
  stress_and_stiffness(elastomer_, metric, internal_, field_, frozen, S, D);
  T = compute_wrinkle_tension(metric, C_, S, stiffness_);
}

/// The amplitude moves in y, in which the tension of a neo-Hookean film is
/// linear, and the angle by a limited amount, downhill. `tension` becomes that
/// after the step, up to the square of the step.
template <class Number>
auto WrinkleSearch<Number>::make_step(const Trial& trial,
                                      const WrinkleEquations<Number>& equations,
                                      Mask<Number>& converged,
                                      Number& tension) const -> Trial
{
  using std::sqrt;
  const Number width = 1. + trial.amplitude;
  const Number least = 1e-9 * contract(trial.directions.along, twin_.pull,
                                       trial.directions.along);
  const Number by_angle = get_larger_number(equations.mixed_angle, least);
  const Number coupling = equations.across_angle / by_angle;
  const Number by_amplitude = get_larger_number<Number>(
      equations.across_amplitude - coupling * equations.mixed_amplitude,
      1e-3 * least / width);
  const Number amplitude =
      (coupling * equations.mixed - equations.across) / by_amplitude;
  const Number angle =
      -(equations.mixed + equations.mixed_amplitude * amplitude) / by_angle;
  tension = equations.along + equations.along_amplitude * amplitude +
            equations.along_angle * angle;
  const Number relative = amplitude / width;
  const Number moved = relative * relative + angle * angle;
  converged = is_less(moved, Number(tolerance * tolerance));
  const Number y_ratio = get_smaller_number<Number>(
      get_larger_number<Number>(1. - 2. * relative, Number(0.05)), Number(20.));
  const Number turn = get_smaller_number<Number>(
      get_larger_number<Number>(angle, Number(-0.4)), Number(0.4));
  const Number c = 1. / sqrt(1. + turn * turn), s = turn * c;
  const auto& [v, u] = trial.directions;
  return {{{c * v.x + s * u.x, c * v.y + s * u.y},
           {c * u.x - s * v.x, c * u.y - s * v.y}},
          get_larger_number<Number>(width / sqrt(y_ratio), Number(1.)) - 1.};
}

/// Whether the springs hold the film's width, not the regularising term alone.
template <class Number>
Mask<Number> WrinkleSearch<Number>::is_bounded(const Tensor& metric) const
{
  const Tensor E = add_scaled(metric, Number(-1.), C_);
  const double bound =
      largest_share * get_lasting_modulus(elastomer_) / stiffness_;
  return is_less(contract(E, E), Number(bound * bound));
}

template <class Number>
Wrinkles<Number>
WrinkleSearch<Number>::find_one_direction(const Tensor& S,
                                          const Mask<Number>& wanted,
                                          const Mask<Number>& flat_within)
{
  Trial trial = make_first_trial(S, flat_within);
  const Trial flat = {trial.directions, Number(0.)};
  Trial fine = choose_trial(flat_within, flat, trial);
  Mask<Number> active = wanted;
  Wrinkles<Number> wrinkles;
  wrinkles.tension = Number(0.);
  for (unsigned int i = 0; i < most_iterations && any(active); ++i)
  {
    const Tensor metric = make_metric(trial);
    const Mask<Number> within =
        is_within_limits(elastomer_, metric, internal_, field_);
    Tensor T;
    Matrix3<Number> D;
    evaluate(metric, T, D);
    const WrinkleEquations<Number> equations(trial.directions, trial.amplitude,
                                             T, D, stiffness_);
    Mask<Number> converged;
    Number tension;
    const Trial next = make_step(trial, equations, converged, tension);
    const Mask<Number> advances = active & within;
    wrinkles.tension = select(advances, tension, wrinkles.tension);
    if (any(active & (!within)))
      trial = choose_trial(within, trial, retreat(trial, fine));
    fine = choose_trial(advances, trial, fine);
    trial = choose_trial(advances, next, trial);
    active = active & !(within & converged);
  }
  wrinkles.metric = make_metric(trial);
  wrinkles.amplitude = trial.amplitude;
  wrinkles.directions = trial.directions;
  wrinkles.slack = is_less(Number(0.), Number(0.));
  wrinkles.admissible = is_bounded(wrinkles.metric) & (!active);
  return wrinkles;
}

/// S = 0 for the twin without field: with Y = C^-1/det C, Y = pull/push and
/// det C = (det Y)^(-1/3).
template <class Number>
SymmetricTensor2<Number> WrinkleSearch<Number>::make_natural_metric() const
{
  using std::exp;
  using std::log;
  const Number inverse = 1. / twin_.push;
  const Tensor Y = {inverse * twin_.pull.xx, inverse * twin_.pull.yy,
                    inverse * twin_.pull.xy};
  const Number det = exp(-(1. / 3.) * log(compute_determinant(Y)));
  return compute_inverse(Tensor{det * Y.xx, det * Y.yy, det * Y.xy});
}

template <class Number>
SymmetricTensor2<Number>
WrinkleSearch<Number>::make_step(const Tensor& metric,
                                 Mask<Number>& converged) const
{
  using std::sqrt;
  Tensor T;
  Matrix3<Number> D;
  evaluate(metric, T, D);
  const Tensor e =
      multiply(compute_inverse(add_wrinkle_stiffness(D, stiffness_)), T);
  const Tensor change = {-2. * e.xx, -2. * e.yy, -e.xy};
  const Number moved =
      contract(change, sandwich(compute_inverse(metric), change));
  converged = is_less(moved, Number(tolerance * tolerance));
  const Number factor =
      1. / sqrt(get_larger_number<Number>(4. * moved, Number(1.)));
  return add_scaled(metric, factor, change);
}

template <class Number>
void WrinkleSearch<Number>::find_both_directions(const Mask<Number>& wanted,
                                                 Wrinkles<Number>& wrinkles)
{
  Tensor metric = make_natural_metric();
  Tensor fine = metric;
  Mask<Number> active = wanted;
  for (unsigned int i = 0; i < most_iterations && any(active); ++i)
  {
    const Mask<Number> within =
        is_within_limits(elastomer_, metric, internal_, field_);
    Mask<Number> converged;
    const Tensor next = make_step(metric, converged);
    const Mask<Number> advances = active & within;
    const Tensor back = combine(Number(.5), metric, Number(.5), fine);
    fine = choose(advances, metric, fine);
    metric = choose(advances, next, choose(active, back, metric));
    active = active & !(within & converged);
  }
  const Tensor E = add_scaled(metric, Number(-1.), C_);
  const Number trace = E.xx + E.yy;
  const Mask<Number> is_wider =
      is_less(Number(-1e-9 * trace * trace), compute_determinant(E)) &
      is_less(Number(0.), trace);
  const Mask<Number> found = wanted & is_wider & is_bounded(metric) & (!active);
  wrinkles.slack = found;
  wrinkles.metric = choose(found, metric, wrinkles.metric);
  wrinkles.amplitude = select(found, Number(0.), wrinkles.amplitude);
  wrinkles.tension = select(found, Number(0.), wrinkles.tension);
  wrinkles.admissible = found | (wrinkles.admissible & (!wanted));
}
} // namespace taut::material
