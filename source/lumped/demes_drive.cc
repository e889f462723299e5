#include "demes_drive.h"

#include <algorithm>
#include <cmath>

namespace taut::lumped
{
DemesDrive::DemesDrive(const Demes& demes, const double start, const double end)
    : demes_(demes), signal_kinks_(demes.drive.kinks(start * demes.time_unit,
                                                     end * demes.time_unit))
{
  for (const double kink : signal_kinks_)
    kinks_.push_back(kink / demes.time_unit);
}

void DemesDrive::begin_segment(const double begin, const double end)
{
  end_ = end;
  signal_begin_ = get_signal_time(begin);
  signal_end_ = get_signal_time(end);
}

double DemesDrive::get_signal_time(const double time) const
{
  const auto kink = std::lower_bound(kinks_.begin(), kinks_.end(), time);
  if (kink != kinks_.end() && *kink == time)
    return signal_kinks_[std::size_t(kink - kinks_.begin())];
  return time * demes_.time_unit;
}

double DemesDrive::value(const double time) const
{
  const double value =
      time < end_
          ? demes_.drive.value(std::max(signal_begin_, time * demes_.time_unit))
          : demes_.drive.value_before(signal_end_);
  return value / demes_.drive_unit;
}

double DemesDrive::rate(const double time) const
{
  const double inside = std::clamp(time * demes_.time_unit, signal_begin_,
                                   std::nextafter(signal_end_, signal_begin_));
  return demes_.drive.rate(inside) * demes_.time_unit / demes_.drive_unit;
}
} // namespace taut::lumped
