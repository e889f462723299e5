#pragma once

#include <taut/study/motion_track.h>

namespace taut::study
{
/// Times k * period (k integer) from `begin` to `end`, to a billionth of the
/// period at both ends.
std::vector<double> make_strobe_times(double period, double begin, double end);

/// The stroboscopic section of a track with the period of its drive: exact
/// where the track has a row, else from its cubic.
/// Errors: BadInput if the period is not positive.
MotionTrack make_strobe(const MotionTrack& track, double period);

/// Where a track passes a level upwards.
MotionTrack make_crossings(const MotionTrack& track, double level);

/// Mean over time of the cubics between the rows.
double compute_time_mean(const MotionTrack& track);
} // namespace taut::study
