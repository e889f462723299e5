#pragma once

#include <taut/lumped/demes.h>

#include <vector>

namespace taut::lumped
{
/// The drive of a DEMES in dimensionless time, smooth within a segment. The
/// kinks of the signal are met exactly although their times are scaled.
class DemesDrive
{
public:
  /// The DEMES must outlive it.
  DemesDrive(const Demes& demes, double start, double end);

  /// Kinks between start and end, as tau.
  const std::vector<double>& get_kinks() const
  {
    return kinks_;
  }
  bool is_constant() const
  {
    return demes_.drive.is_constant();
  }

  /// Until the next call the times asked for lie in [begin, end].
  void begin_segment(double begin, double end);

  /// e; at the end of the segment its limit from the left.
  double value(double time) const;
  double rate(double time) const;

private:
  /// Time of the signal.
  double get_signal_time(double time) const;

  const Demes& demes_;
  std::vector<double> kinks_;
  std::vector<double> signal_kinks_;
  double end_ = 0;
  double signal_begin_ = 0;
  double signal_end_ = 0;
};
} // namespace taut::lumped
