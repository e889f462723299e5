#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/lumped/resonator_statics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

#include "row_times.h"
#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace taut::lumped
{
namespace
{
/// The relaxed states of a resonator, one for each stretch of A: the voltage
/// that balances it follows from the stretch without iteration.
class RelaxedPath
{
public:
  explicit RelaxedPath(const Resonator& resonator)
      : resonator_(resonator), ground_(make_ground(resonator)), frozen_(ground_)
  {
  }

  double find_stretch(const double voltage) const
  {
    return frozen_.find_balance(voltage);
  }

  /// V* from s_1A(V* = 0) - V*^2 lambda_1A lambda_2^2 = s_1B.
  double compute_voltage(const double stretch_1a) const
  {
    const double excess = frozen_.respond_a(stretch_1a, 0).stress_1 -
                          frozen_.respond_b(stretch_1a).stress_1;
    return std::sqrt(std::max(0., excess) / stretch_1a) /
           resonator_.pre_stretch_2;
  }

  ResonatorRow make_row(const double voltage, const double stretch_1a) const
  {
    const double stretch_1b = resonator_.get_stretch_1b(stretch_1a);
    std::vector<double> internal;
    for (std::size_t m = 0; m < resonator_.networks.size(); ++m)
      internal.insert(internal.end(), {stretch_1a, resonator_.pre_stretch_2,
                                       stretch_1b, resonator_.pre_stretch_2});
    FrozenResonator relaxed(resonator_);
    relaxed.freeze(internal.data());
    return lumped::make_row(relaxed, 0, voltage, stretch_1a, internal.data());
  }

  ResonatorRow make_row(const double stretch_1a) const
  {
    return make_row(compute_voltage(stretch_1a), stretch_1a);
  }

private:
  static Resonator make_ground(const Resonator& resonator)
  {
    validate(resonator);
    Resonator ground = resonator;
    ground.networks.clear();
    return ground;
  }

  const Resonator& resonator_;
  Resonator ground_;
  FrozenResonator frozen_;
};

/// lambda_1A where lambda_1B = lambda_2^(-1/2), so that s_1 = 0.
double compute_slack_stretch(const Resonator& resonator)
{
  return resonator.pre_stretch_1 +
         (resonator.pre_stretch_1 - 1 / std::sqrt(resonator.pre_stretch_2)) /
             resonator.length_ratio;
}

struct Margin
{
  ResonatorFailure failure;
  ResonatorPlace place;
  double (*value)(const ResonatorRow&);
};

const std::array<Margin, 4> margins = {
    {{ResonatorFailure::loss_of_tension_1, ResonatorPlace::a_and_b,
      [](const ResonatorRow& row) { return row.stress_1b; }},
     {ResonatorFailure::loss_of_tension_2, ResonatorPlace::a,
      [](const ResonatorRow& row) { return row.stress_2a; }},
     {ResonatorFailure::loss_of_tension_2, ResonatorPlace::b,
      [](const ResonatorRow& row) { return row.stress_2b; }},
     {ResonatorFailure::breakdown, ResonatorPlace::a,
      [](const ResonatorRow& row) { return row.breakdown_margin; }}}};

/// The state in which the margin falls to zero between two stretches of A.
ResonatorRow locate(const RelaxedPath& path, const Margin& margin,
                    const double begin, const double end)
{
  std::uintmax_t iterations = 100;
  const auto value = [&](const double stretch)
  { return margin.value(path.make_row(stretch)); };
  return path.make_row(boost::math::tools::toms748_solve(
                           value, begin, end,
                           boost::math::tools::eps_tolerance<double>(),
                           iterations)
                           .second);
}

/// The failure with the smallest stretch of A in (begin, end], if any.
std::optional<ResonatorEvent> find_first_failure(const RelaxedPath& path,
                                                 const double begin,
                                                 const double end)
{
  const auto before = path.make_row(begin);
  const auto after = path.make_row(end);
  std::optional<ResonatorEvent> first;
  for (const auto& margin : margins)
  {
    if (!(margin.value(before) > 0 && margin.value(after) <= 0))
      continue;
    const auto row = locate(path, margin, begin, end);
    if (!first || row.stretch_1a < first->row.stretch_1a)
      first = {margin.failure, margin.place, false, row};
  }
  return first;
}

/// Up to where relaxed states are searched for failures: beyond loss of
/// tension, or close to the Gent limit, where the voltage grows without bound.
double compute_path_end(const Resonator& resonator)
{
  const auto limit =
      FrozenStrip(resonator, Strip::a).compute_admissible_interval().second;
  return std::min(compute_slack_stretch(resonator) * (1 + 1e-9),
                  limit * (1 - 1e-12));
}

/// When a voltage of either sign first reaches the limit between two times at
/// the second of which it has.
double find_crossing(const std::function<double(double)>& get_voltage,
                     const double limit, double before, double after)
{
  const auto reached = [&](const double time)
  { return std::abs(get_voltage(time)) >= limit; };
  if (reached(before))
    return before;
  const auto bracket = boost::math::tools::bisect(
      [&](const double time) { return reached(time) ? 1. : -1.; }, before,
      after, boost::math::tools::eps_tolerance<double>());
  return bracket.second;
}
} // namespace

ResonatorRow find_relaxed_state(const Resonator& resonator,
                                const double voltage)
{
  const RelaxedPath path(resonator);
  return path.make_row(voltage, path.find_stretch(voltage));
}

ResonatorEvent find_static_failure(const Resonator& resonator)
{
  const RelaxedPath path(resonator);
  const double start = resonator.pre_stretch_1;
  const auto unloaded = path.make_row(start);
  for (const auto& margin : margins)
    if (!(margin.value(unloaded) > 0))
      return {margin.failure, margin.place, true, unloaded};
  const double length = compute_path_end(resonator) - start;
  const int pieces = 50;
  for (int piece = 0; piece < pieces; ++piece)
    if (const auto failure =
            find_first_failure(path, start + length * piece / pieces,
                               start + length * (piece + 1) / pieces))
      return *failure;
  throw SolverFailed("no static failure was found up to the Gent limit");
}

ResonatorRun run_static(const Resonator& resonator,
                        const ResonatorRunOptions& options)
{
  validate(options);
  const auto get_voltage = [&](const double time)
  { return resonator.voltage.value(time) / resonator.voltage_unit; };
  ResonatorRun run;
  run.failure = find_static_failure(resonator);
  const double limit = run.failure->row.voltage;
  double before = options.start_time;
  for (const double time : make_row_times(options.start_time, options.end_time,
                                          options.output_times))
  {
    const double voltage = get_voltage(time);
    if (run.failure->at_start || std::abs(voltage) >= limit)
    {
      run.failure->row.time = find_crossing(get_voltage, limit, before, time);
      run.rows.push_back(run.failure->row);
      run.events.push_back(*run.failure);
      return run;
    }
    run.rows.push_back(find_relaxed_state(resonator, voltage));
    run.rows.back().time = before = time;
  }
  run.failure.reset();
  return run;
}

double compute_slack_voltage(const Resonator& resonator)
{
  validate(resonator);
  const double square_1 = std::pow(compute_slack_stretch(resonator), 2);
  const double square_2 = resonator.pre_stretch_2 * resonator.pre_stretch_2;
  const double limit = resonator.gent_limit;
  const double margin =
      limit - square_1 - square_2 - 1 / (square_1 * square_2) + 3;
  if (!(margin > 0))
    throw BadInput("strip A reaches its Gent limit J_lim = " +
                   number_text(limit) + " before the tension is lost");
  return std::sqrt(resonator.equilibrium_fraction * limit *
                   (1 - 1 / (square_1 * square_1 * square_2)) /
                   (margin * square_2));
}

std::vector<TuningPoint>
compute_tuning(const Resonator& resonator, const double voltage,
               const std::vector<double>& pre_stretches_1,
               const std::vector<double>& pre_stretches_2)
{
  std::vector<TuningPoint> points;
  Resonator stretched = resonator;
  for (const double pre_stretch_1 : pre_stretches_1)
    for (const double pre_stretch_2 : pre_stretches_2)
    {
      stretched.pre_stretch_1 = pre_stretch_1;
      stretched.pre_stretch_2 = pre_stretch_2;
      TuningPoint point{pre_stretch_1, pre_stretch_2, 0, {}};
      const auto failure = find_static_failure(stretched);
      if (failure.at_start || failure.row.voltage <= voltage)
        point.failure = failure.failure;
      else
        point.shift = find_relaxed_state(stretched, voltage).frequency -
                      find_relaxed_state(stretched, 0).frequency;
      points.push_back(point);
    }
  return points;
}
} // namespace taut::lumped
