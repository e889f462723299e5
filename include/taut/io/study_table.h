#pragma once

#include <taut/io/study_messages.h>
#include <taut/study/sweep.h>

#include <string>
#include <vector>

namespace taut::io
{
/// What is known of a study at some moment.
struct StudyState
{
  const study::StudyDescription& study;
  const std::vector<study::StudyCase>& cases;
  const CaseOutcomes& outcomes;
};

struct StudyCounts
{
  std::size_t total = 0, done = 0, failed = 0, refused = 0, interrupted = 0;
};
StudyCounts count_outcomes(const StudyState& state);

/// The text of study.csv: a row for each case that has ended, in their order.
/// Columns: `case [1]`, the variables, the results, `time reached [s]`,
/// `seconds [s]`, status, reason, folder. What a case does not have is empty.
std::string make_study_table(const StudyState& state);

/// The text of study.json: title, status (completed or interrupted), counts,
/// seconds, command, variables with their values, results, the cases that
/// failed or were refused with their reasons, versions.
std::string make_study_json(const StudyState& state, bool interrupted,
                            double seconds);
} // namespace taut::io
