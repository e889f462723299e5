#pragma once

#include <taut/lumped/lyapunov.h>
#include <taut/study/motion_track.h>

#include <limits>
#include <optional>
#include <string>

namespace taut::study
{
/// What a motion has come to.
enum class MotionClass
{
  equilibrium,    ///< at rest
  periodic,       ///< repeats after n periods of the drive, or n swings
  quasi_periodic, ///< stays regular but never repeats
  irregular,      ///< neighbours separate
  transient       ///< has not settled, or too little of it is known
};

/// equilibrium, periodic, quasi-periodic, irregular or transient.
std::string to_text(MotionClass motion_class);

struct MotionVerdict
{
  MotionClass motion_class = MotionClass::transient;
  /// n of a periodic motion, else 0.
  unsigned int period_number = 0;
  /// Of a periodic motion (s), else NaN.
  double period = std::numeric_limits<double>::quiet_NaN();
  /// Widest extent of the points that should coincide, every n-th of the second
  /// half of the section (n = 1 unless periodic), over the motion's size.
  double spread = std::numeric_limits<double>::quiet_NaN();
  /// How far their mean moves from one period to the next, likewise.
  double drift = std::numeric_limits<double>::quiet_NaN();
  /// Of the 0-1 test, near 0 for regular and near 1 for irregular motions; NaN
  /// where it was not needed or there are too few points.
  double irregularity = std::numeric_limits<double>::quiet_NaN();
  /// Why, as a sentence.
  std::string reason;
};

/// What of a motion the verdict is found from.
struct MotionEvidence
{
  /// After the transient.
  MotionTrack track;
  /// Of it: stroboscopic, or where it passes its mean upwards.
  MotionTrack section;
  bool is_driven = false;
  /// Half the range of the whole run with its transient.
  double whole_size = 0;
  std::optional<lumped::LyapunovExponent> lyapunov;
};

/// In this order, with the tolerance epsilon and all lengths over half the
/// range of value and velocity after the transient:
/// - equilibrium: over the last quarter of the time half the range of the value
///   is below epsilon times that of the whole run;
/// - periodic: for the smallest n up to 16 all n classes of every n-th point of
///   the second half of the section have at least 4 points each and extend by
///   less than epsilon; for n > 1 the distances |x_(k+1) - x_k| must not change
///   as they do in a transient. Points are (value, velocity) of a strobe, or
///   (velocity, time since the last crossing) of a free motion;
/// - transient: fewer than 24 points, or the distances |x_(k+n) - x_k| of the n
///   (up to 8) that repeats best change from the first third of the section to
///   the last by more than a quarter in root mean square; or the largest
///   Lyapunov exponent is known and negative by three standard errors;
/// - irregular: that exponent is positive by three standard errors; without it,
///   the 0-1 test of the section's values (Gottwald and Melbourne, SIAM J.
///   Appl. Dyn. Syst. 8 (2009)) gives more than one half. It needs
///   100 points, below which the motion counts as transient;
/// - quasi-periodic: what remains.
MotionVerdict classify_motion(const MotionEvidence& evidence, double tolerance);

/// K of the 0-1 test: the median over 100 frequencies c of the correlation of n
/// with the mean square displacement after n steps of the walk
/// p(n) = sum x_j cos(j c), q(n) = sum x_j sin(j c), less its oscillating part.
/// Of a longer series the last 2000 values count.
double test_irregularity(const std::vector<double>& series);
} // namespace taut::study
