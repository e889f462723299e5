#include <taut/base/exceptions.h>
#include <taut/lumped/run_all.h>
#include <taut/study/response.h>

#include <algorithm>
#include <cmath>

#include "motion_text.h"
#include "response_run.h"

namespace taut::study
{
namespace
{
bool goes(const FrequencyResponseDescription& description, const bool upward)
{
  using Direction = FrequencyResponseDescription::Direction;
  return description.direction == Direction::both ||
         (description.direction == Direction::up) == upward;
}

/// Empty points, in the order of the response.
std::vector<ResponsePoint>
plan_points(const FrequencyResponseDescription& description)
{
  const auto frequencies = make_frequencies(description);
  std::vector<ResponsePoint> points;
  ResponsePoint point;
  point.is_upward = true;
  for (std::size_t i = 0; goes(description, true) && i < frequencies.size();
       ++i)
  {
    point.frequency = frequencies[i];
    points.push_back(point);
  }
  point.is_upward = false;
  for (std::size_t i = frequencies.size(); goes(description, false) && i > 0;
       --i)
  {
    point.frequency = frequencies[i - 1];
    points.push_back(point);
  }
  return points;
}

/// Differs by more than the sweep's own scatter.
bool differs(const ResponsePoint& up, const ResponsePoint& down,
             const double largest)
{
  return !(std::abs(up.amplitude - down.amplitude) <= 0.01 * largest);
}

std::vector<std::string>
describe_failures(const std::vector<ResponsePoint>& points)
{
  std::vector<std::string> notes;
  for (const ResponsePoint& point : points)
    if (std::isnan(point.amplitude))
      notes.push_back("At " + show_number(point.frequency) +
                      " Hz the device fails after " +
                      std::to_string(point.periods) + " periods.");
  return notes;
}

Table make_table(const std::vector<ResponsePoint>& points,
                 const std::string& unit)
{
  Table table;
  table.columns = {
      {"frequency", "Hz"}, {"direction", "1"},       {"mean", unit},
      {"minimum", unit},   {"maximum", unit},        {"amplitude", unit},
      {"rms", unit},       {"amplitude at f", unit}, {"amplitude at 2f", unit},
      {"lowest", unit},    {"highest", unit},        {"period number", "1"},
      {"settled", "1"},    {"periods", "1"},         {"reproducible", "1"}};
  for (const ResponsePoint& p : points)
    table.rows.push_back({p.frequency, p.is_upward ? 1. : -1., p.mean,
                          p.minimum, p.maximum, p.amplitude, p.rms,
                          p.first_amplitude, p.second_amplitude, p.lowest,
                          p.highest, double(p.period_number), double(p.settled),
                          double(p.periods), double(p.reproducible)});
  return table;
}
} // namespace

std::vector<double>
make_frequencies(const FrequencyResponseDescription& description)
{
  const double from = description.from, to = description.to;
  std::vector<double> frequencies;
  for (unsigned int i = 0; i < description.points; ++i)
  {
    const double share =
        description.points > 1 ? double(i) / (description.points - 1) : 0;
    frequencies.push_back(description.is_logarithmic
                              ? from * std::pow(to / from, share)
                              : from + share * (to - from));
  }
  return frequencies;
}

std::vector<ResponsePoint> compute_response(const Case& lumped_case)
{
  const auto& description = lumped_case.procedure.frequency_response;
  auto points = plan_points(description);
  const auto compute = [&](ResponsePoint& point, std::vector<double>& state)
  {
    point = compute_point(lumped_case, point.frequency, point.is_upward, state);
  };
  if (description.from_rest)
    lumped::run_all(points.size(),
                    [&](const std::size_t i)
                    {
                      std::vector<double> rest;
                      compute(points[i], rest);
                    });
  else
    lumped::run_all(points.size() / description.points,
                    [&](const std::size_t sweep)
                    {
                      std::vector<double> state;
                      for (unsigned int i = 0; i < description.points; ++i)
                        compute(points[sweep * description.points + i], state);
                    });
  return points;
}

std::vector<std::string> find_jumps(const std::vector<ResponsePoint>& points)
{
  std::vector<std::string> notes;
  double largest = 0;
  for (const ResponsePoint& point : points)
    largest = std::fmax(largest, point.amplitude);
  const std::size_t n = points.size() / 2;
  if (points.empty() || points.front().is_upward == points.back().is_upward)
    return notes;
  const auto get_pair = [&](const std::size_t i)
  { return differs(points[i], points[2 * n - 1 - i], largest); };
  for (std::size_t i = 0; i < n; ++i)
  {
    if (!get_pair(i))
      continue;
    const std::size_t first = i;
    while (i + 1 < n && get_pair(i + 1))
      ++i;
    notes.push_back("From " + show_number(points[first].frequency) + " to " +
                    show_number(points[i].frequency) +
                    " Hz the motion depends on whether the frequency rises or "
                    "falls: amplitude " +
                    show_number(points[first].amplitude) + " against " +
                    show_number(points[2 * n - 1 - first].amplitude) + " at " +
                    show_number(points[first].frequency) + " Hz.");
  }
  return notes;
}

RunSummary run_response(const Case& lumped_case, RunOutput& output)
{
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const auto flow = make_driven_flow(
      lumped_case, lumped_case.procedure.frequency_response.from);
  const auto points = compute_response(lumped_case);
  RunSummary summary;
  summary.tables["response"] = make_table(points, flow->get_unit());
  summary.columns = summary.tables["response"].columns;
  summary.final_row = summary.tables["response"].rows.back();
  output.begin(summary.columns);
  for (const auto& row : summary.tables["response"].rows)
    output.write_row(row);
  summary.notes = find_jumps(points);
  for (const std::string& failure : describe_failures(points))
    summary.notes.push_back(failure);
  summary.counters["points"] = double(points.size());
  summary.timings["total"] =
      std::chrono::duration<double>(Clock::now() - began).count();
  return summary;
}
} // namespace taut::study
