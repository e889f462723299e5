#include <taut/study/motion_class.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "motion_text.h"

namespace taut::study
{
namespace
{
constexpr std::size_t least_per_class = 4;
constexpr std::size_t most_repeated = 16;
constexpr std::size_t most_compared = 8;
constexpr std::size_t least_points = 24;
constexpr std::size_t least_for_test = 100;
constexpr double settled_change = 0.75;

/// A point of a section without units.
using SectionCoordinates = std::array<double, 2>;
using SectionPoints = std::vector<SectionCoordinates>;

double get_half_range(const std::vector<double>& values)
{
  const auto [lowest, highest] =
      std::minmax_element(values.begin(), values.end());
  return values.empty() ? 0 : (*highest - *lowest) / 2;
}

SectionPoints make_section_points(const MotionEvidence& evidence)
{
  const MotionTrack& section = evidence.section;
  const double size = compute_half_range(evidence.track);
  const double speed = get_half_range(evidence.track.velocities);
  SectionPoints points;
  if (evidence.is_driven)
  {
    for (std::size_t k = 0; k < section.size(); ++k)
      points.push_back(
          {section.values[k] / size, section.velocities[k] / speed});
    return points;
  }
  if (section.size() < 2)
    return points;
  const double mean_time = (section.times.back() - section.times.front()) /
                           double(section.size() - 1);
  for (std::size_t k = 1; k < section.size(); ++k)
    points.push_back({section.velocities[k] / speed,
                      (section.times[k] - section.times[k - 1]) / mean_time});
  return points;
}

/// Largest extent of points first, first + n, ...
double measure_extent(const SectionPoints& points, const std::size_t first,
                      const std::size_t n)
{
  double extent = 0;
  for (const std::size_t i : {0, 1})
  {
    double lowest = points[first][i], highest = lowest;
    for (std::size_t k = first; k < points.size(); k += n)
    {
      lowest = std::min(lowest, points[k][i]);
      highest = std::max(highest, points[k][i]);
    }
    extent = std::max(extent, highest - lowest);
  }
  return extent;
}

/// Of the second half of the section, the widest class of every n-th point.
double measure_spread(const SectionPoints& points, const std::size_t n)
{
  double spread = 0;
  for (std::size_t i = 0; i < n; ++i)
    spread = std::max(spread, measure_extent(points, points.size() / 2 + i, n));
  return spread;
}

SectionCoordinates compute_section_mean(const SectionPoints& points,
                                        const std::size_t begin,
                                        const std::size_t end)
{
  SectionCoordinates mean{};
  for (std::size_t k = begin; k < end; ++k)
    for (const std::size_t i : {0, 1})
      mean[i] += points[k][i] / double(end - begin);
  return mean;
}

/// From the third to the last quarter of the section, per point; both have a
/// multiple of n points.
double measure_drift(const SectionPoints& points, const std::size_t n)
{
  const std::size_t size = points.size() / 4 / n * n;
  if (size == 0)
    return std::numeric_limits<double>::quiet_NaN();
  const std::size_t end = points.size();
  const auto before = compute_section_mean(points, end - 2 * size, end - size);
  const auto after = compute_section_mean(points, end - size, end);
  return std::max(std::abs(after[0] - before[0]),
                  std::abs(after[1] - before[1])) /
         double(size);
}

/// Root mean square of |x_(k+n) - x_k| over k from begin to end.
double measure_returns(const SectionPoints& points, const std::size_t n,
                       const std::size_t begin, const std::size_t end)
{
  double sum = 0;
  for (std::size_t k = begin; k < end; ++k)
    sum += std::pow(points[k + n][0] - points[k][0], 2) +
           std::pow(points[k + n][1] - points[k][1], 2);
  return std::sqrt(sum / double(end - begin));
}

/// The returns after n points in the last third of those from `first` on, and
/// by which factor they change from the first third; both thirds have a
/// multiple of `whole` points.
struct Returns
{
  double last = 0;
  double change = 1;
};

Returns compare_returns(const SectionPoints& points, const std::size_t first,
                        const std::size_t n, const std::size_t whole)
{
  const std::size_t end = points.size() - n;
  const std::size_t third = (end - first) / 3 / whole * whole;
  if (third == 0)
    return {};
  Returns returns;
  returns.last = measure_returns(points, n, end - third, end);
  returns.change =
      returns.last / measure_returns(points, n, first, first + third);
  return returns;
}

bool is_stationary(const Returns& returns)
{
  return returns.change >= settled_change &&
         returns.change <= 1 / settled_change;
}

/// Of the returns that repeat best.
Returns find_closest_returns(const SectionPoints& points)
{
  Returns closest = compare_returns(points, 0, 1, 1);
  for (std::size_t n = 2; n <= most_compared; ++n)
  {
    const Returns returns = compare_returns(points, 0, n, 1);
    if (returns.last < closest.last)
      closest = returns;
  }
  return closest;
}

bool is_at_rest(const MotionEvidence& evidence, const double tolerance)
{
  const auto& times = evidence.track.times;
  const double quarter = (times.back() - times.front()) / 4;
  const MotionTrack last = cut_before(evidence.track, times.back() - quarter);
  const auto extremes = find_extremes(last);
  const double round_off =
      1e-9 * std::max(std::abs(extremes[0]), std::abs(extremes[1]));
  return compute_half_range(last) <=
         std::max(tolerance * evidence.whole_size, round_off);
}

double get_mean_interval(const MotionTrack& section)
{
  return (section.times.back() - section.times.front()) /
         double(section.size() - 1);
}

/// Whether the n points stay apart. Those of a spiral into a single point turn
/// by nearly an n-th of a circle each and approach each other.
bool is_kept_apart(const SectionPoints& points, const std::size_t n)
{
  return n == 1 ||
         is_stationary(compare_returns(points, points.size() / 2, 1, n));
}

/// Whether the section repeats; then the verdict is complete.
bool find_period(const MotionEvidence& evidence, const SectionPoints& points,
                 const double tolerance, MotionVerdict& verdict)
{
  const std::size_t window = points.size() - points.size() / 2;
  for (std::size_t n = 1; n <= most_repeated && n * least_per_class <= window;
       ++n)
  {
    const double spread = measure_spread(points, n);
    if (n == 1)
    {
      verdict.spread = spread;
      verdict.drift = measure_drift(points, n);
    }
    if (spread > tolerance || !is_kept_apart(points, n))
      continue;
    verdict.spread = spread;
    verdict.drift = measure_drift(points, n);
    verdict.motion_class = MotionClass::periodic;
    verdict.period_number = static_cast<unsigned int>(n);
    verdict.period = double(n) * get_mean_interval(evidence.section);
    verdict.reason = "the section repeats after " + std::to_string(n) +
                     (n == 1 ? " point" : " points") + ", within " +
                     show_number(tolerance) + " of the motion";
    return true;
  }
  return false;
}

void judge_by_lyapunov(const lumped::LyapunovExponent& exponent,
                       MotionVerdict& verdict)
{
  const double margin = 3 * exponent.uncertainty;
  const std::string text = "the largest Lyapunov exponent is " +
                           show_number(exponent.value) + " 1/s";
  if (exponent.value < -margin)
    verdict.reason = text + ", so that it will settle";
  else if (exponent.value > margin)
  {
    verdict.motion_class = MotionClass::irregular;
    verdict.reason = text;
  }
  else
  {
    verdict.motion_class = MotionClass::quasi_periodic;
    verdict.reason = text + ", which is none, and the section does not repeat";
  }
}

void judge_by_section(const SectionPoints& points, MotionVerdict& verdict)
{
  if (points.size() < least_for_test)
  {
    verdict.reason = "the section does not repeat, and its " +
                     std::to_string(points.size()) +
                     " points are too few to tell why: 100 are needed";
    return;
  }
  std::vector<double> series;
  for (const auto& point : points)
    series.push_back(point[0]);
  verdict.irregularity = test_irregularity(series);
  const bool irregular = verdict.irregularity > 0.5;
  verdict.motion_class =
      irregular ? MotionClass::irregular : MotionClass::quasi_periodic;
  verdict.reason = "the section does not repeat, and the 0-1 test gives " +
                   show_number(verdict.irregularity);
}

/// p(n) and q(n) of the 0-1 test.
std::array<std::vector<double>, 2> make_walk(const std::vector<double>& series,
                                             const double c)
{
  std::array<std::vector<double>, 2> walk;
  double p = 0, q = 0;
  for (std::size_t j = 0; j < series.size(); ++j)
  {
    p += series[j] * std::cos(double(j + 1) * c);
    q += series[j] * std::sin(double(j + 1) * c);
    walk[0].push_back(p);
    walk[1].push_back(q);
  }
  return walk;
}

/// Of the numbers 1, 2, ... with the values.
double compute_correlation(const std::vector<double>& values)
{
  const auto n = double(values.size());
  double mean = 0;
  for (const double value : values)
    mean += value / n;
  double both = 0, square = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double place = double(i) - (n - 1) / 2;
    both += place * (values[i] - mean);
    square += (values[i] - mean) * (values[i] - mean);
  }
  const double places = n * (n * n - 1) / 12;
  return square > 0 ? both / std::sqrt(places * square) : 0;
}

/// The growth of the walk's mean square displacement at one frequency.
double test_frequency(const std::vector<double>& series, const double mean,
                      const double c)
{
  const auto [p, q] = make_walk(series, c);
  const std::size_t steps = series.size() / 10, size = series.size() - steps;
  std::vector<double> displacement;
  for (std::size_t n = 1; n <= steps; ++n)
  {
    double sum = 0;
    for (std::size_t j = 0; j < size; ++j)
      sum += (p[j + n] - p[j]) * (p[j + n] - p[j]) +
             (q[j + n] - q[j]) * (q[j + n] - q[j]);
    displacement.push_back(sum / double(size) -
                           mean * mean * (1 - std::cos(double(n) * c)) /
                               (1 - std::cos(c)));
  }
  return compute_correlation(displacement);
}
} // namespace

std::string to_text(const MotionClass motion_class)
{
  switch (motion_class)
  {
  case MotionClass::equilibrium:
    return "equilibrium";
  case MotionClass::periodic:
    return "periodic";
  case MotionClass::quasi_periodic:
    return "quasi-periodic";
  case MotionClass::irregular:
    return "irregular";
  case MotionClass::transient:
    break;
  }
  return "transient";
}

double test_irregularity(const std::vector<double>& series)
{
  constexpr std::size_t longest = 2000;
  constexpr int n_frequencies = 100;
  const std::vector<double> last(
      series.size() > longest ? series.end() - longest : series.begin(),
      series.end());
  double mean = 0;
  for (const double value : last)
    mean += value / double(last.size());
  // Between pi / 5 and 4 pi / 5, where few rational parts of a turn lie.
  std::vector<double> growth;
  for (int i = 0; i < n_frequencies; ++i)
    growth.push_back(test_frequency(
        last, mean, std::acos(-1.) * (0.2 + 0.6 * (i + 0.5) / n_frequencies)));
  std::nth_element(growth.begin(), growth.begin() + n_frequencies / 2,
                   growth.end());
  return growth[n_frequencies / 2];
}

MotionVerdict classify_motion(const MotionEvidence& evidence,
                              const double tolerance)
{
  MotionVerdict verdict;
  if (evidence.track.size() < 4)
  {
    verdict.reason = "there are fewer than 4 rows after the transient";
    return verdict;
  }
  if (is_at_rest(evidence, tolerance))
  {
    verdict.motion_class = MotionClass::equilibrium;
    verdict.reason = "in the last quarter of the time it moves by less than " +
                     show_number(tolerance) + " of the whole run's range";
    return verdict;
  }
  const SectionPoints points = make_section_points(evidence);
  if (find_period(evidence, points, tolerance, verdict))
    return verdict;
  if (points.size() < least_points)
  {
    verdict.reason = "the section has " + std::to_string(points.size()) +
                     " points, too few to tell more";
    return verdict;
  }
  const Returns returns = find_closest_returns(points);
  if (!is_stationary(returns))
    verdict.reason = "the distances between returns still change, by the "
                     "factor " +
                     show_number(returns.change) +
                     " from the first third of the section to the last";
  else if (evidence.lyapunov)
    judge_by_lyapunov(*evidence.lyapunov, verdict);
  else
    judge_by_section(points, verdict);
  return verdict;
}
} // namespace taut::study
