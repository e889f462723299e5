#include <taut/study/section.h>
#include <taut/study/spectrum.h>

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <mutex>

namespace taut::study
{
namespace
{
const double two_pi = 2 * std::acos(-1.);

/// FFTW plans one transform at a time.
std::mutex& get_planner()
{
  static std::mutex planner;
  return planner;
}

/// sum_j x_j exp(-2 pi i j k / n) for k up to n / 2.
std::vector<std::complex<double>> transform(std::vector<double>& samples)
{
  std::vector<std::complex<double>> result(samples.size() / 2 + 1);
  std::unique_lock<std::mutex> lock(get_planner());
  const fftw_plan plan = fftw_plan_dft_r2c_1d(
      int(samples.size()), samples.data(),
      reinterpret_cast<fftw_complex*>(result.data()), FFTW_ESTIMATE);
  lock.unlock();
  fftw_execute(plan);
  lock.lock();
  fftw_destroy_plan(plan);
  return result;
}

/// n values at even times, the last of which comes before the end, so that
/// they repeat after the length of the track.
std::vector<double> sample_evenly(const MotionTrack& track)
{
  const std::size_t n = track.size();
  const double begin = track.times.front();
  const double step = (track.times.back() - begin) / double(n);
  std::vector<double> times;
  for (std::size_t i = 0; i < n; ++i)
    times.push_back(begin + step * double(i));
  return resample(track, times).values;
}

/// Less the mean under the window, times the window; returns its sum.
double apply_window(std::vector<double>& samples)
{
  const std::size_t n = samples.size();
  std::vector<double> window;
  double sum = 0, weighted = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    window.push_back((1 - std::cos(two_pi * double(i) / double(n))) / 2);
    sum += window[i];
    weighted += window[i] * samples[i];
  }
  for (std::size_t i = 0; i < n; ++i)
    samples[i] = window[i] * (samples[i] - weighted / sum);
  return sum;
}

/// Hann's window seen d steps beside a line, over its height.
double get_leakage(const double d)
{
  const double x = two_pi / 2 * d;
  if (std::abs(x) < 1e-6)
    return 1;
  return std::sin(x) / (x * (1 - d * d));
}
} // namespace

Spectrum compute_spectrum(const MotionTrack& track)
{
  if (track.size() < 8)
    return {};
  auto samples = sample_evenly(track);
  const double sum = apply_window(samples);
  const auto coefficients = transform(samples);
  const double length = track.times.back() - track.times.front();
  Spectrum spectrum;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
  {
    const bool unpaired = k == 0 || 2 * k == samples.size();
    spectrum.frequencies.push_back(double(k) / length);
    spectrum.amplitudes.push_back((unpaired ? 1 : 2) *
                                  std::abs(coefficients[k]) / sum);
  }
  return spectrum;
}

SpectrumLine find_highest_line(const Spectrum& spectrum)
{
  const auto& a = spectrum.amplitudes;
  if (a.size() < 3)
    return {};
  const auto k =
      std::size_t(std::max_element(a.begin() + 1, a.end() - 1) - a.begin());
  if (!(a[k] > 0))
    return {};
  // Between two neighbours the ratio of Hann's window tells the place.
  const bool right = a[k + 1] > a[k - 1];
  const double ratio = (right ? a[k + 1] : a[k - 1]) / a[k];
  const double shift = std::clamp((2 * ratio - 1) / (ratio + 1), -0.5, 0.5);
  const double step = spectrum.frequencies[1];
  return {spectrum.frequencies[k] + (right ? shift : -shift) * step,
          a[k] / get_leakage(shift)};
}

double compute_line(const MotionTrack& track, const double frequency)
{
  // The mean adds nothing over whole periods but would add its round-off.
  const double mean = compute_time_mean(track);
  MotionTrack cosine, sine;
  for (std::size_t i = 0; i < track.size(); ++i)
  {
    const double w = two_pi * frequency, t = track.times[i];
    const double value = track.values[i] - mean, rate = track.velocities[i];
    const double c = std::cos(w * t), s = std::sin(w * t);
    cosine.add({t, value * c, rate * c - w * value * s});
    sine.add({t, value * s, rate * s + w * value * c});
  }
  return 2 * std::hypot(compute_time_mean(cosine), compute_time_mean(sine));
}
} // namespace taut::study
