#pragma once

#include <taut/io/run_results.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

/// What the coordinator of a study and its workers tell each other, as lines of
/// JSON.
namespace taut::io
{
/// One case for a worker.
struct CaseJob
{
  unsigned int number = 0;
  std::string case_file;
  std::string command = "run";
  std::vector<std::string> overrides;
  /// Of the run; empty if it leaves none.
  std::string folder;
  /// Goes on from the checkpoint in the folder, if that is possible.
  bool resume = false;
  std::vector<study::ResultRequest> results;
};

/// A result that no case can have.
struct ResultMistake
{
  unsigned int result = 0;
  std::string message;
};

/// How a case ended.
struct CaseOutcome
{
  unsigned int number = 0;
  /// completed, event, interrupted, failed or refused.
  std::string status;
  std::string reason;
  std::optional<double> time_reached; ///< (s)
  double seconds = 0;                 ///< of wall time
  /// One per result of the study; none if the case was not completed.
  std::vector<ResultValue> results;
  std::optional<ResultMistake> mistake;

  /// Completed, or ended by an event that the case declares fatal.
  bool is_done() const
  {
    return status == "completed" || status == "event";
  }
};

/// By number of the case.
using CaseOutcomes = std::map<unsigned int, CaseOutcome>;

std::string write_line(const CaseJob& job);
std::string write_line(const CaseOutcome& outcome);
/// Errors: std::runtime_error if the text is no such line.
CaseJob read_job(const std::string& line);
CaseOutcome read_outcome(const std::string& line);
} // namespace taut::io
