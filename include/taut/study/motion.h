#pragma once

#include <taut/study/case.h>
#include <taut/study/motion_class.h>
#include <taut/study/spectrum.h>

#include <optional>
#include <string>

namespace taut::study
{
/// What was found out about the motion of a run.
struct Motion
{
  /// Name and unit of the quantity.
  std::string of, unit;
  /// Name of its rate, empty if that is a derivative.
  std::string velocity;
  double from = 0; ///< what is before is the transient (s)
  MotionVerdict verdict;
  SpectrumLine highest_line;
  std::optional<lumped::LyapunovExponent> lyapunov; ///< (1/s)
  /// Whether a run with another start within 1e-10 and a tenth of the tolerance
  /// looks the same; none if nobody looked.
  std::optional<bool> reproducible;
  /// Until then the two differ by less than a hundredth of the motion (s).
  double reproducible_until = 0;
  MotionTrack section;
  Spectrum spectrum;
};

/// Section, spectrum and class of a track, all but `lyapunov` from it alone.
/// Errors: BadInput if nothing is left of it.
Motion analyse_motion(
    const MotionTrack& track, const MotionDescription& description,
    const std::optional<lumped::LyapunovExponent>& lyapunov = std::nullopt);

/// The last of its times before `twin`, a run at the same times, differs from
/// `track` by more than a hundredth of its half range; the end if it never
/// does.
double find_reproducible_end(const MotionTrack& track, const MotionTrack& twin);
} // namespace taut::study
