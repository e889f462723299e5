#pragma once

#include <taut/study/comparison.h>

#include <string>

namespace taut::io
{
/// The text of compare.json: quantities (list of name, unit,
/// max_relative_difference, rms_relative_difference, time_of_max),
/// compared_until (s), events (film and lumped: lists of time, voltage, kind,
/// place, at_start; film_failure and lumped_failure: one of them or null;
/// failure_difference: time and voltage, relative, same_kind, same_place, or
/// null), film_status, lumped_resonator (its parameters, SI units) and ignored
/// (what the lumped model does not know).
std::string make_comparison_json(const study::Comparison& comparison);

/// compare.csv: `time [s],voltage [V]` and for every quantity its history in
/// both models, `name film [unit],name lumped [unit]`; empty where a model has
/// ended before. Errors as CsvFile.
void write_comparison_table(const std::string& file,
                            const study::Comparison& comparison);

/// What a user reads first: the differences, the failures and what the lumped
/// model ignores.
std::string describe_comparison(const study::Comparison& comparison);
} // namespace taut::io
