#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

/// One number from a column of a run's history.
namespace taut::study
{
enum class Statistic
{
  start,
  final,
  minimum,
  maximum,
  mean,      ///< over time, by the trapezoidal rule
  amplitude, ///< half of maximum less minimum
  time_of_minimum,
  time_of_maximum,
  time, ///< of the first occurrence of an event
  value ///< at the first occurrence of an event
};

/// What is asked of a run.
struct ResultRequest
{
  /// A column of history.csv, `event NAME`, or a path in run.json.
  std::string of;
  Statistic statistic = Statistic::final;
  /// Only rows from `from` to `to` count (s).
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// The statistic of `values` at `times` (s) inside the window. Values that are
/// no numbers (NaN) do not count; none if no row is left, or for the statistics
/// of events.
std::optional<double> compute_statistic(const std::vector<double>& times,
                                        const std::vector<double>& values,
                                        const ResultRequest& request);

/// As a study file writes it: "time of minimum".
const std::vector<std::pair<std::string, Statistic>>& get_statistic_words();
std::string to_text(Statistic statistic);
} // namespace taut::study
