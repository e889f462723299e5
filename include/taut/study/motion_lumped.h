#pragma once

#include <taut/lumped/lyapunov.h>
#include <taut/study/case.h>
#include <taut/study/motion_track.h>

#include <optional>
#include <string>
#include <vector>

namespace taut::study
{
/// What only a lumped model tells of the motion of its case: it is cheap enough
/// to be followed twice.

/// The largest Lyapunov exponent (1/s) from Case::motion's `from` to `end`,
/// over whole periods of the drive. None for a film or if it cannot be
/// measured, which then is in `notes`.
std::optional<lumped::LyapunovExponent>
measure_lyapunov(const Case& run_case, double end,
                 std::vector<std::string>& notes);

/// How long (s) a run from another start within 1e-10 and with a tenth of the
/// tolerance stays within a hundredth of the range of `track`. None for a film
/// or if that run fails.
std::optional<double> find_reproducible_end(const Case& run_case,
                                            const MotionTrack& track);
} // namespace taut::study
