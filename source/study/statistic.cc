#include <taut/study/statistic.h>

#include <algorithm>
#include <cmath>

namespace taut::study
{
namespace
{
struct Point
{
  double time, value;
};

std::vector<Point> select(const std::vector<double>& times,
                          const std::vector<double>& values,
                          const ResultRequest& request)
{
  std::vector<Point> points;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (times[i] >= request.from && times[i] <= request.to &&
        !std::isnan(values[i]))
      points.push_back({times[i], values[i]});
  return points;
}

double compute_mean(const std::vector<Point>& points)
{
  double integral = 0, duration = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const double step = points[i].time - points[i - 1].time;
    integral += step * (points[i].value + points[i - 1].value) / 2;
    duration += step;
  }
  return duration > 0 ? integral / duration : points.front().value;
}
} // namespace

std::optional<double> compute_statistic(const std::vector<double>& times,
                                        const std::vector<double>& values,
                                        const ResultRequest& request)
{
  const std::vector<Point> points = select(times, values, request);
  if (points.empty())
    return std::nullopt;
  const auto is_less = [](const Point& a, const Point& b)
  { return a.value < b.value; };
  const auto least = std::min_element(points.begin(), points.end(), is_less);
  const auto most = std::max_element(points.begin(), points.end(), is_less);
  switch (request.statistic)
  {
  case Statistic::start:
    return points.front().value;
  case Statistic::final:
    return points.back().value;
  case Statistic::minimum:
    return least->value;
  case Statistic::maximum:
    return most->value;
  case Statistic::mean:
    return compute_mean(points);
  case Statistic::amplitude:
    return (most->value - least->value) / 2;
  case Statistic::time_of_minimum:
    return least->time;
  case Statistic::time_of_maximum:
    return most->time;
  default:
    return std::nullopt;
  }
}

const std::vector<std::pair<std::string, Statistic>>& get_statistic_words()
{
  static const std::vector<std::pair<std::string, Statistic>> words = {
      {"start", Statistic::start},
      {"final", Statistic::final},
      {"minimum", Statistic::minimum},
      {"maximum", Statistic::maximum},
      {"mean", Statistic::mean},
      {"amplitude", Statistic::amplitude},
      {"time of minimum", Statistic::time_of_minimum},
      {"time of maximum", Statistic::time_of_maximum},
      {"time", Statistic::time},
      {"value", Statistic::value}};
  return words;
}

std::string to_text(const Statistic statistic)
{
  for (const auto& [word, value] : get_statistic_words())
    if (value == statistic)
      return word;
  return "";
}
} // namespace taut::study
