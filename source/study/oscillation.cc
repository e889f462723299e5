#include <taut/study/oscillation.h>

#include <algorithm>
#include <cmath>

namespace taut::study
{
namespace
{
double interpolate(const double t0, const double v0, const double t1,
                   const double v1, const double t)
{
  return v0 + (v1 - v0) * (t - t0) / (t1 - t0);
}

double compute_largest_swing(const std::vector<double>& values,
                             const double mean)
{
  double largest = 0;
  for (const double value : values)
    largest = std::max(largest, std::abs(value - mean));
  return largest;
}

/// Times of the last crossing of the mean on every way from below the band to
/// above it.
std::vector<double> find_upward(const std::vector<double>& times,
                                const std::vector<double>& values,
                                const double mean, const double band)
{
  std::vector<double> crossings;
  bool below = false;
  double crossing = times.front();
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    if (i > 0 && values[i - 1] < mean && values[i] >= mean)
      crossing =
          interpolate(values[i - 1], times[i - 1], values[i], times[i], mean);
    if (values[i] < mean - band)
      below = true;
    else if (values[i] > mean + band && below)
    {
      crossings.push_back(crossing);
      below = false;
    }
  }
  return crossings;
}
} // namespace

double compute_mean(const std::vector<double>& times,
                    const std::vector<double>& values, const double begin,
                    const double end)
{
  double sum = 0;
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    const double a = std::max(begin, times[i - 1]);
    const double b = std::min(end, times[i]);
    if (b <= a)
      continue;
    const auto at = [&](const double t) {
      return interpolate(times[i - 1], values[i - 1], times[i], values[i], t);
    };
    sum += (b - a) * (at(a) + at(b)) / 2;
  }
  return sum / (end - begin);
}

double compute_mean(const std::vector<double>& times,
                    const std::vector<double>& values,
                    const Oscillation& oscillation)
{
  const auto mean = [&](const std::array<double, 2>& span)
  { return compute_mean(times, values, span[0], span[1]); };
  return (mean(oscillation.rises) + mean(oscillation.falls)) / 2;
}

Oscillation measure_oscillation(const std::vector<double>& times,
                                const std::vector<double>& values,
                                const double smallest)
{
  if (times.size() < 3)
    return {};
  std::vector<double> mirrored = values;
  for (double& value : mirrored)
    value = -value;
  // The mean over whole periods and the crossings that bound them depend on
  // each other.
  constexpr unsigned int rounds = 5;
  Oscillation result;
  result.mean = compute_mean(times, values, (times.front() + times.back()) / 2,
                             times.back());
  for (unsigned int round = 0; round < rounds; ++round)
  {
    const double largest = compute_largest_swing(values, result.mean);
    if (!(largest > smallest))
      return {};
    const double band = 0.05 * largest;
    const auto up = find_upward(times, values, result.mean, band);
    const auto down = find_upward(times, mirrored, -result.mean, band);
    if (up.size() < 2)
      return {};
    result.rises = {up.front(), up.back()};
    result.falls = down.size() < 2
                       ? result.rises
                       : std::array<double, 2>{down.front(), down.back()};
    result.frequency =
        double(up.size() - 1) / (result.rises[1] - result.rises[0]);
    result.mean = compute_mean(times, values, result);
  }
  return result;
}
} // namespace taut::study
