#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/study/motion.h>
#include <taut/study/section.h>

#include <algorithm>
#include <cmath>

namespace taut::study
{
Motion analyse_motion(const MotionTrack& track,
                      const MotionDescription& description,
                      const std::optional<lumped::LyapunovExponent>& lyapunov)
{
  MotionEvidence evidence;
  evidence.track = cut_before(track, description.from);
  if (evidence.track.size() == 0)
    throw BadInput(
        "the run ended before From = " + number_text(description.from) +
        " s, so that nothing of its motion is left");
  evidence.is_driven = description.period > 0;
  evidence.section =
      evidence.is_driven
          ? make_strobe(evidence.track, description.period)
          : make_crossings(evidence.track, compute_time_mean(evidence.track));
  evidence.whole_size = compute_half_range(track);
  evidence.lyapunov = lyapunov;
  Motion motion;
  motion.of = description.of;
  motion.from = track.times.front() > description.from ? track.times.front()
                                                       : description.from;
  motion.verdict = classify_motion(evidence, description.tolerance);
  motion.lyapunov = lyapunov;
  motion.spectrum = compute_spectrum(evidence.track);
  motion.highest_line = find_highest_line(motion.spectrum);
  motion.section = std::move(evidence.section);
  return motion;
}

double find_reproducible_end(const MotionTrack& track, const MotionTrack& twin)
{
  const double allowed = 0.01 * compute_half_range(track);
  double end = track.times.front();
  for (std::size_t row = 0; row < track.size(); ++row)
  {
    if (row >= twin.size() ||
        !(std::abs(twin.values[row] - track.values[row]) <= allowed))
      return end;
    end = track.times[row];
  }
  return end;
}
} // namespace taut::study
