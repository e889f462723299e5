#pragma once

#include <taut/study/comparison_demes.h>

#include <string>

namespace taut::io
{
/// The text of compare.json: quantities (list of name, unit,
/// max_relative_difference, rms_relative_difference, time_of_max) against the
/// arc and, "... (elastica)", against the elastica; models (list of name; rest:
/// voltage, angle, chord, stretch, relaxed_frequency, instantaneous_frequency;
/// driven: the same or null; oscillation: frequency and the mean angle, chord
/// and stretch of the run; of lumped models film_difference: that of the film's
/// rest angle, chord, stretch and measured frequency, over the model's);
/// compared_until (s), events (film, arc), film_status, lumped_demes (its
/// parameters, SI units), ignored (what the lumped models do not know) and
/// notes. SI units, frequencies in Hz; null where there is no number.
std::string make_comparison_json(const study::DemesComparison& comparison);

/// compare.csv: `time [s],voltage [V]` and for angle, chord and stretch their
/// history in every model, `name model [unit]`; empty where a model has ended
/// before. Errors as CsvFile.
void write_comparison_table(const std::string& file,
                            const study::DemesComparison& comparison);

/// What a user reads first: rest and frequency of every model, the differences
/// over the run and what the lumped models ignore.
std::string describe_comparison(const study::DemesComparison& comparison);
} // namespace taut::io
