#include <taut/base/exceptions.h>
#include <taut/io/declarations.h>
#include <taut/io/files.h>
#include <taut/io/study_file.h>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <sstream>

#include <boost/algorithm/string.hpp>

namespace taut::io
{
namespace
{
using namespace study;

/// A study with one section of every kind.
const char* const study_prototype = R"(
set Case = case.prm
subsection Vary NAME
end
subsection Set NAME
end
subsection Result NAME
end
)";

void declare_top(Section section, StudyDescription& study)
{
  section.optional("Title", study.title, text("any text"),
                   "what is studied, for reports");
  section.required("Case", study.case_file,
                   text("a .prm or .json, counted from the study file"),
                   "the case file that is run with other values");
  section.optional("Command", study.command, one_of({"run", "modes"}),
                   "what is done with each case");
  section.optional("Combine", study.combine,
                   choice<Combine>({{"grid", Combine::grid},
                                    {"together", Combine::together}}),
                   "all combinations of the values, the last variable running "
                   "fastest, or the i-th values of all variables");
  section.optional("Folder", study.folder,
                   text("a name with {variable}, {expression} and {case}, the "
                        "number of the case"),
                   "folder of each case inside cases; if empty the names and "
                   "values of the variables");
  section.optional("Keep folders", study.keep_folders, yes_no(),
                   "whether each case leaves the folder of a run, or only its "
                   "row in study.csv");
  section.optional("Plot", study.plot,
                   text("a Python script, counted from the study file"),
                   "is called with the study's folder at the end");
}

void declare_variable(Section& section, VariableDraft& variable)
{
  section.optional("Values", variable.list,
                   text("values as the case file holds them, separated by "
                        "commas, or by ';' if they hold commas"),
                   "the values");
  section.optional("Range", variable.range,
                   optionally(three_numbers(any(), "of the key"), "none"),
                   "in place of Values: from, to and how many");
  section.optional("Spacing", variable.spacing,
                   choice<Spacing>({{"linear", Spacing::linear},
                                    {"logarithmic", Spacing::logarithmic}}),
                   "of the numbers in the range");
  section.optional("Key", variable.key, text("Section/Key, or empty"),
                   "the key of the case that takes the value; if empty only "
                   "expressions use it");
  section.optional("Unit", variable.unit, text("any text"),
                   "for the header of study.csv, 1 if dimensionless");
}

void declare_setting(Section& section, SweepSetting& setting)
{
  section.required("Key", setting.key, text("Section/Key"),
                   "a further key of the case");
  section.required("Value", setting.value,
                   text("a value in which {expression} is calculated from the "
                        "variables and {variable} is its text"),
                   "what it is set to");
}

void declare_result(Section& section, SweepResult& result)
{
  section.required("Of", result.of,
                   text("a column of history.csv, event NAME, or a path in "
                        "run.json such as motion/class"),
                   "where the column of study.csv comes from");
  section.optional("Statistic", result.statistic,
                   choice<Statistic>(get_statistic_words()),
                   "of a column: start to time of maximum, the mean over time, "
                   "the amplitude half of maximum less minimum; of an event "
                   "its first time or the value then");
  section.optional("From", result.from, text("a time in s or an {expression}"),
                   "only rows from this time on count; all if empty");
  section.optional("To", result.to, text("a time in s or an {expression}"),
                   "only rows up to this time count; all if empty");
  section.optional("Unit", result.unit, text("any text"),
                   "for the header of study.csv; if empty that of the column");
}

/// The values in a list; a ';' at the end shows that one value holds commas.
std::vector<std::string> split_values(const std::string& list)
{
  const bool by_semicolon = list.find(';') != std::string::npos;
  std::vector<std::string> values;
  boost::split(values, list,
               [by_semicolon](const char c)
               { return c == (by_semicolon ? ';' : ','); });
  for (std::string& value : values)
    value = tidy(value);
  if (by_semicolon && values.back().empty())
    values.pop_back();
  return values;
}

std::vector<std::string> read_range(const VariableDraft& variable)
{
  const auto [from, to, count] = *variable.range;
  const double most = 1e7;
  if (count != std::floor(count) || count > most)
    throw BadInput(fmt::format("a range is 'from, to, how many', and {} is no "
                               "whole number up to {}",
                               count, most));
  return make_range(from, to, count < 1 ? 0 : static_cast<unsigned int>(count),
                    variable.spacing);
}

std::vector<std::string> read_values(const CaseText& text,
                                     const VariableDraft& variable)
{
  const SectionPath section = {"Vary " + variable.name};
  if (variable.range && !variable.list.empty())
    text.refuse(section, "Range", "a variable has either Values or a Range");
  if (variable.range)
    try
    {
      return read_range(variable);
    }
    catch (const BadInput& problem)
    {
      text.refuse(section, "Range", problem.message());
    }
  if (variable.list.empty())
    text.refuse(section, "Values",
                "the variable has no values: give Values or a Range");
  const auto values = split_values(variable.list);
  for (const std::string& value : values)
    if (value.empty())
      text.refuse(section, "Values", "a value is missing in the list");
  return values;
}

void check_result(const CaseText& text, const SweepResult& result)
{
  const bool of_event = boost::starts_with(result.of, "event ");
  const bool event_statistic = result.statistic == Statistic::time ||
                               result.statistic == Statistic::value;
  if (of_event != event_statistic)
    text.refuse({"Result " + result.name}, "Statistic",
                of_event ? "an event has the statistics time and value alone"
                         : "the statistics time and value are those of an "
                           "event: 'event NAME'");
}

std::string make_absolute(const std::string& study_file,
                          const std::string& file)
{
  namespace fs = std::filesystem;
  return (fs::absolute(study_file).parent_path() / file).lexically_normal();
}

bool changes_cases(const Parameter& parameter)
{
  const bool is_top = parameter.section.empty();
  if (is_top && (parameter.key == "Title" || parameter.key == "Plot" ||
                 parameter.key == "Case"))
    return false;
  return is_top || !boost::starts_with(parameter.section[0], "Result ");
}

StudyIdentity make_identity(const Declarations& all,
                            const std::string& case_file)
{
  StudyIdentity identity;
  for (const Parameter& parameter : all.parameters())
  {
    const std::string value = all.get_text(parameter);
    if (changes_cases(parameter) && value != parameter.default_text)
      identity.parameters[join(parameter.section, parameter.key)] = value;
  }
  identity.case_content = read_file(case_file);
  return identity;
}

void set_files(Declarations& all, const CaseText& text, StudyDescription& study)
{
  study.file = text.file();
  study.case_file = make_absolute(text.file(), study.case_file);
  all.set_text({}, "Case", study.case_file);
  if (!std::filesystem::is_regular_file(study.case_file))
    text.refuse({}, "Case",
                fmt::format("there is no file {}", study.case_file));
  if (study.plot.empty())
    return;
  study.plot = make_absolute(text.file(), study.plot);
  all.set_text({}, "Plot", study.plot);
  if (!std::filesystem::is_regular_file(study.plot))
    text.refuse({}, "Plot", fmt::format("there is no file {}", study.plot));
}
} // namespace

void declare_sweep(Declarations& all, const CaseText& text, StudyDraft& draft)
{
  StudyDescription& study = draft.content;
  declare_top(all.section({}, "the study"), study);
  declare_list(all, text, {}, "Vary", "values that differ from case to case",
               draft.variables, declare_variable);
  declare_list(all, text, {}, "Set", "a further key of every case",
               study.settings, declare_setting);
  declare_list(all, text, {}, "Result", "a column of study.csv", study.results,
               declare_result);
}

void declare_any_sweep(Declarations& all, StudyDraft& draft)
{
  declare_sweep(all, CaseText::parse(study_prototype, "prototype.prm"), draft);
}

std::string find_difference(const StudyIdentity& then, const StudyIdentity& now)
{
  const auto get = [](const StudyIdentity& identity, const std::string& path)
  {
    const auto place = identity.parameters.find(path);
    return place == identity.parameters.end() ? "not given"
                                              : "'" + place->second + "'";
  };
  std::map<std::string, std::string> all = then.parameters;
  all.insert(now.parameters.begin(), now.parameters.end());
  for (const auto& parameter : all)
    if (get(then, parameter.first) != get(now, parameter.first))
      return fmt::format("'{}' was {} and is {}", parameter.first,
                         get(then, parameter.first), get(now, parameter.first));
  if (then.case_content == now.case_content)
    return "";
  std::istringstream before(then.case_content), after(now.case_content);
  std::string old_line, new_line;
  unsigned int line = 1;
  while (std::getline(before, old_line) && std::getline(after, new_line) &&
         old_line == new_line)
    ++line;
  return fmt::format("the case file has changed in line {}", line);
}

StudyFile read_study_file(const std::string& file,
                          const std::vector<std::string>& overrides)
{
  StudyFile result;
  result.text = CaseText::read(file);
  if (result.text.find({}, "Model"))
    result.text.refuse({}, "Model",
                       "this is a case, not a study of one: `taut "
                       "run` runs it");
  for (const std::string& option : overrides)
    result.text.override_entry(option);
  Declarations all;
  StudyDraft draft;
  declare_sweep(all, result.text, draft);
  all.assign(result.text);
  for (const VariableDraft& variable : draft.variables)
  {
    SweepVariable complete;
    complete.name = variable.name;
    complete.source_line = variable.source_line;
    complete.values = read_values(result.text, variable);
    complete.key = variable.key;
    complete.unit = variable.unit;
    draft.content.variables.push_back(complete);
  }
  for (const SweepResult& item : draft.content.results)
    check_result(result.text, item);
  set_files(all, result.text, draft.content);
  result.content = draft.content;
  result.identity = make_identity(all, result.content.case_file);
  result.case_text = CaseText::read(result.content.case_file);
  std::ostringstream effective;
  all.write(effective);
  result.effective_parameters = effective.str();
  set_cases(result);
  return result;
}
} // namespace taut::io
