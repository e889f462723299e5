#include "resonator_motion.h"

#include <algorithm>
#include <cmath>

namespace taut::lumped
{
ResonatorMotion::ResonatorMotion(const Resonator& resonator)
    : resonator_(resonator), frozen_(resonator)
{
}

void ResonatorMotion::begin_segment(const double begin, const double end,
                                    double*)
{
  begin_ = begin;
  end_ = end;
}

double ResonatorMotion::get_voltage(const double time) const
{
  const Signal& voltage = resonator_.voltage;
  return (time < end_ ? voltage.value(time) : voltage.value_before(time)) /
         resonator_.voltage_unit;
}

double ResonatorMotion::get_voltage_rate(const double time) const
{
  const double inside = std::min(time, std::nextafter(end_, begin_));
  return resonator_.voltage.rate(inside) / resonator_.voltage_unit;
}

QuasiStaticMotion::QuasiStaticMotion(const Resonator& resonator)
    : ResonatorMotion(resonator)
{
}

void QuasiStaticMotion::begin_segment(const double begin, const double end,
                                      double* const y)
{
  ResonatorMotion::begin_segment(begin, end, y);
  frozen_.freeze(y);
  guess_ = frozen_.find_balance(get_voltage(begin));
}

double QuasiStaticMotion::balance(const double voltage,
                                  const double* const internal)
{
  frozen_.freeze(internal);
  return guess_ = frozen_.find_balance(voltage, guess_);
}

std::vector<double>
QuasiStaticMotion::make_state(const std::vector<double>& internal,
                              const ResonatorRunOptions&)
{
  return internal;
}

void QuasiStaticMotion::compute_rate(const double time, const double* const y,
                                     double* const rate)
{
  const double stretch_1a = balance(get_voltage(time), y);
  frozen_.compute_rates(stretch_1a, rate);
}

ResonatorRow QuasiStaticMotion::observe(const double time,
                                        const double* const y)
{
  const double voltage = get_voltage(time);
  const double stretch_1a = balance(voltage, y);
  return make_row(frozen_, time, voltage, stretch_1a, y);
}

std::vector<ResonatorWatch> QuasiStaticMotion::get_watches() const
{
  return {{ResonatorFailure::loss_of_tension_1, ResonatorPlace::a_and_b},
          {ResonatorFailure::loss_of_tension_2, ResonatorPlace::a},
          {ResonatorFailure::loss_of_tension_2, ResonatorPlace::b},
          {ResonatorFailure::breakdown, ResonatorPlace::a}};
}

void QuasiStaticMotion::compute_watches(const double time,
                                        const double* const y,
                                        double* const values)
{
  const double voltage = get_voltage(time);
  const double stretch_1a = balance(voltage, y);
  const auto a = frozen_.respond_a(stretch_1a, voltage);
  const auto b = frozen_.respond_b(stretch_1a);
  // B carries the same force without the cancellation of A's electric stress.
  values[0] = b.stress_1;
  values[1] = a.stress_2;
  values[2] = b.stress_2;
  values[3] =
      resonator_.strength - voltage * stretch_1a * resonator_.pre_stretch_2;
}

InertialMotion::InertialMotion(const Resonator& resonator)
    : ResonatorMotion(resonator), alpha_(resonator.get_alpha()),
      dissipated_(2 + resonator.n_internal()), work_(dissipated_ + 1)
{
}

double InertialMotion::compute_charge(const double stretch_1a,
                                      const double voltage) const
{
  const double area = stretch_1a * resonator_.pre_stretch_2;
  return voltage * area * area;
}

void InertialMotion::begin_segment(const double begin, const double end,
                                   double* const y)
{
  ResonatorMotion::begin_segment(begin, end, y);
  if (started_)
  {
    // A jump of the voltage meets a resonator that stands still meanwhile.
    const double before =
        resonator_.voltage.value_before(begin) / resonator_.voltage_unit;
    const double after = get_voltage(begin);
    y[work_] += (after - before) * compute_charge(y[0], (after + before) / 2);
  }
  started_ = true;
}

std::vector<double>
InertialMotion::make_state(const std::vector<double>& internal,
                           const ResonatorRunOptions& options)
{
  frozen_.freeze(internal.data());
  const double voltage =
      resonator_.voltage.value(options.start_time) / resonator_.voltage_unit;
  const double balance = frozen_.find_balance(voltage);
  std::vector<double> y = {balance + options.displacement, options.velocity};
  y.insert(y.end(), internal.begin(), internal.end());
  y.resize(work_ + 1, 0.);
  return y;
}

void InertialMotion::compute_rate(const double time, const double* const y,
                                  double* const rate)
{
  frozen_.freeze(y + 2);
  const double voltage = get_voltage(time);
  rate[0] = y[1];
  rate[1] = alpha_ * (frozen_.respond_b(y[0]).stress_1 -
                      frozen_.respond_a(y[0], voltage).stress_1);
  frozen_.compute_rates(y[0], rate + 2);
  rate[dissipated_] = frozen_.compute_dissipation(y[0]);
  rate[work_] = compute_charge(y[0], voltage) * get_voltage_rate(time);
}

ResonatorRow InertialMotion::observe(const double time, const double* const y)
{
  frozen_.freeze(y + 2);
  ResonatorRow row = make_row(frozen_, time, get_voltage(time), y[0], y + 2);
  const double acceleration = alpha_ * (row.stress_1b - row.stress_1a);
  row.velocity = y[1];
  row.force_1a += resonator_.inertia_a * acceleration;
  row.force_1b -= resonator_.inertia_b * resonator_.length_ratio * acceleration;
  row.kinetic_energy = y[1] * y[1] / (2 * alpha_);
  row.dissipated_energy = y[dissipated_];
  row.voltage_work = y[work_];
  return row;
}

std::vector<ResonatorWatch> InertialMotion::get_watches() const
{
  return {{ResonatorFailure::loss_of_tension_1, ResonatorPlace::a},
          {ResonatorFailure::loss_of_tension_1, ResonatorPlace::b},
          {ResonatorFailure::loss_of_tension_2, ResonatorPlace::a},
          {ResonatorFailure::loss_of_tension_2, ResonatorPlace::b},
          {ResonatorFailure::breakdown, ResonatorPlace::a}};
}

void InertialMotion::compute_watches(const double time, const double* const y,
                                     double* const values)
{
  frozen_.freeze(y + 2);
  const double voltage = get_voltage(time);
  const auto a = frozen_.respond_a(y[0], voltage);
  const auto b = frozen_.respond_b(y[0]);
  values[0] = a.stress_1;
  values[1] = b.stress_1;
  values[2] = a.stress_2;
  values[3] = b.stress_2;
  values[4] = resonator_.strength - voltage * y[0] * resonator_.pre_stretch_2;
}
} // namespace taut::lumped
