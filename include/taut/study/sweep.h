#pragma once

#include <taut/structure/description.h>
#include <taut/study/statistic.h>

#include <string>
#include <vector>

/// A parameter study: one case file run over many values of its keys.
namespace taut::study
{
/// How the values of several variables make cases.
enum class Combine
{
  grid,    ///< all combinations, the last variable running fastest
  together ///< the i-th values of all variables
};

enum class Spacing
{
  linear,
  logarithmic
};

/// What differs from case to case.
struct SweepVariable : structure::Named
{
  /// Texts as the case file would hold them.
  std::vector<std::string> values;
  /// `Section/Key` of the case that takes the value; empty if none does.
  std::string key;
  std::string unit; ///< for tables; empty if the values are no numbers
};

/// A further key of the case. In its value, {expression} stands for the value
/// of a muParser expression in the variables and `case`, the number of the
/// case, and {variable} for the text of a variable.
struct SweepSetting : structure::Named
{
  std::string key;
  std::string value;
};

/// A number of a run that becomes a column of the study's table. In `of`,
/// `from` and `to`, braces mean what they do in a SweepSetting.
struct SweepResult : structure::Named
{
  /// A column of history.csv, `event NAME`, or a path in run.json.
  std::string of;
  Statistic statistic = Statistic::final;
  std::string from; ///< begin of the window (s); empty = of the run
  std::string to;   ///< its end (s)
  std::string unit; ///< empty = that of the column
};

struct StudyDescription
{
  std::string file;
  std::string title;
  std::string case_file; ///< as found from the study file
  std::string command = "run";
  Combine combine = Combine::grid;
  std::string folder; ///< pattern with braces; empty = the names and values
  bool keep_folders = true;
  std::string plot; ///< script, as found from the study file; may be empty
  std::vector<SweepVariable> variables;
  std::vector<SweepSetting> settings;
  std::vector<SweepResult> results;
};

/// A key of the case and the value that it takes.
struct KeyValue
{
  std::string key;
  std::string value;
};

struct StudyCase
{
  unsigned int number = 0; ///< from 1
  /// One text per variable.
  std::vector<std::string> values;
  /// First those of the variables that have a key, then the settings.
  std::vector<KeyValue> keys;
  std::string folder;
  std::vector<ResultRequest> results;
};

/// `count` numbers from `from` to `to`, with 15 significant digits. Errors:
/// BadInput for a count below 1, an interval without extent for more than one
/// number, and a logarithmic one that holds 0.
std::vector<std::string> make_range(double from, double to, unsigned int count,
                                    Spacing spacing);

/// All cases of a study in their order. Errors: BadInput, with the line of the
/// section that is wrong, for names that are none or not unique, variables
/// without values, lists of different lengths, expressions that cannot be read
/// or evaluated, and two cases with the same folder.
std::vector<StudyCase> expand(const StudyDescription& study);
} // namespace taut::study
