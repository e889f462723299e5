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

Oscillation measure_oscillation(const std::vector<double>& times,
                                const std::vector<double>& values,
                                const double smallest)
{
  Oscillation result;
  if (times.size() < 3)
    return result;
  // The mean over whole periods and the crossings that bound them depend on
  // each other.
  constexpr unsigned int rounds = 5;
  double mean = compute_mean(times, values, (times.front() + times.back()) / 2,
                             times.back());
  for (unsigned int round = 0; round < rounds; ++round)
  {
    const double largest = compute_largest_swing(values, mean);
    if (!(largest > smallest))
      return {};
    const auto crossings = find_upward(times, values, mean, 0.05 * largest);
    if (crossings.size() < 2)
      return {};
    result.begin = crossings.front();
    result.end = crossings.back();
    result.frequency =
        double(crossings.size() - 1) / (result.end - result.begin);
    mean = compute_mean(times, values, result.begin, result.end);
  }
  result.mean = mean;
  return result;
}
} // namespace taut::study
