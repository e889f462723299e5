#include <taut/base/exceptions.h>
#include <taut/study/motion.h>
#include <taut/study/motion_flow.h>
#include <taut/study/motion_lumped.h>

#include <algorithm>
#include <cmath>

namespace taut::study
{
namespace
{
/// A model that runs from the start to the end of its case in one piece.
bool has_flow(const Case& run_case)
{
  return run_case.model != "film" &&
         run_case.procedure.analysis == structure::Analysis::transient;
}

/// Whole periods, in even parts of at most one period each.
lumped::LyapunovOptions make_options(const MotionDescription& motion,
                                     const double begin, const double end)
{
  constexpr double least = 400;
  lumped::LyapunovOptions options;
  options.begin = begin;
  options.end = end;
  options.intervals = static_cast<unsigned int>(least);
  const double periods =
      motion.period > 0 ? std::floor((end - begin) / motion.period * (1 + 1e-9))
                        : 0;
  if (periods < 1)
    return options;
  options.end = begin + periods * motion.period;
  options.intervals = static_cast<unsigned int>(
      periods * std::max(1., std::ceil(least / periods)));
  return options;
}

std::vector<double> disturb(std::vector<double> state,
                            const std::vector<double>& scales)
{
  constexpr double disturbance = 1e-10;
  for (std::size_t i = 0; i < state.size(); ++i)
    state[i] += disturbance * scales[i];
  return state;
}
} // namespace

std::optional<lumped::LyapunovExponent>
measure_lyapunov(const Case& run_case, const double end,
                 std::vector<std::string>& notes)
{
  if (!has_flow(run_case))
    return std::nullopt;
  const MotionDescription& motion = *run_case.motion;
  const double start = run_case.procedure.start_time;
  const double begin = std::max(start, motion.from);
  FlowOptions as_exact_as_possible;
  as_exact_as_possible.of = motion.of;
  as_exact_as_possible.tolerance_factor = 0;
  try
  {
    const auto flow = make_flow(run_case, as_exact_as_possible);
    auto options = make_options(motion, begin, end);
    options.scales = flow->get_scales();
    const auto state =
        flow->follow(flow->make_start(start), start, begin, {}, nullptr);
    return lumped::compute_lyapunov(
        [&](const std::vector<double>& from, const double t0, const double t1)
        { return flow->follow(from, t0, t1, {}, nullptr); },
        state, options);
  }
  catch (const SolverFailed& failure)
  {
    notes.push_back(std::string("There is no Lyapunov exponent: ") +
                    failure.what() + ".");
    return std::nullopt;
  }
}

std::optional<double> find_reproducible_end(const Case& run_case,
                                            const MotionTrack& track)
{
  if (!has_flow(run_case))
    return std::nullopt;
  FlowOptions options;
  options.of = run_case.motion->of;
  options.tolerance_factor = 0.1;
  try
  {
    const auto flow = make_flow(run_case, options);
    const double start = run_case.procedure.start_time;
    MotionTrack twin;
    flow->follow(disturb(flow->make_start(start), flow->get_scales()), start,
                 track.times.back(), track.times, &twin);
    return find_reproducible_end(track, twin);
  }
  catch (const SolverFailed&)
  {
    return std::nullopt;
  }
}
} // namespace taut::study
