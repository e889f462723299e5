#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/study/sweep.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>

#include "sweep_number.h"
#include "sweep_template.h"

namespace taut::study
{
namespace
{
const char* const case_name = "case";

[[noreturn]] void refuse(const StudyDescription& study, const unsigned int line,
                         const std::string& key, const std::string& message)
{
  throw BadInput(message, study.file, line, key);
}

bool is_number(const std::string& text)
{
  double value;
  return read_number(text, value);
}

bool has_numbers(const SweepVariable& variable)
{
  return std::all_of(variable.values.begin(), variable.values.end(), is_number);
}

void check_variables(const StudyDescription& study)
{
  for (const SweepVariable& variable : study.variables)
  {
    const std::string section = "Vary " + variable.name;
    if (!is_variable_name(variable.name) || variable.name == case_name)
      refuse(study, variable.source_line, section,
             fmt::format("'{}' cannot name a variable: allowed are letters, "
                         "digits and underscores, no digit first, and no "
                         "function, constant or '{}', the number of the case",
                         variable.name, case_name));
    if (variable.values.empty())
      refuse(study, variable.source_line, section, "the variable has no value");
    if (study.combine == Combine::together &&
        variable.values.size() != study.variables[0].values.size())
      refuse(study, variable.source_line, section,
             fmt::format("'{}' has {} values, but '{}' has {}: variables that "
                         "are combined together need as many",
                         variable.name, variable.values.size(),
                         study.variables[0].name,
                         study.variables[0].values.size()));
  }
}

/// Names of columns that a table has anyway.
const std::vector<std::string> own_columns = {
    case_name, "time reached", "seconds", "status", "reason", "folder"};

void check_columns(const StudyDescription& study)
{
  std::vector<std::string> columns = own_columns;
  for (const SweepVariable& variable : study.variables)
    columns.push_back(variable.name);
  for (const SweepResult& result : study.results)
  {
    if (std::find(columns.begin(), columns.end(), result.name) != columns.end())
      refuse(study, result.source_line, "Result " + result.name,
             fmt::format("the table has another column '{}'", result.name));
    columns.push_back(result.name);
  }
}

void check_keys_once(const StudyDescription& study)
{
  std::map<std::string, std::string> owners;
  const auto claim = [&](const std::string& key, const std::string& section,
                         const unsigned int line)
  {
    const auto [owner, is_new] = owners.emplace(key, section);
    if (!is_new)
      refuse(study, line, section + "/Key",
             fmt::format("the key '{}' is given by '{}', too", key,
                         owner->second));
  };
  for (const SweepVariable& variable : study.variables)
    if (!variable.key.empty())
      claim(variable.key, "Vary " + variable.name, variable.source_line);
  for (const SweepSetting& setting : study.settings)
    claim(setting.key, "Set " + setting.name, setting.source_line);
}

/// What of a study is filled with the values of each case.
class Cases
{
public:
  explicit Cases(const StudyDescription& study) : study_(study)
  {
    names_.texts.emplace_back(case_name);
    names_.numbers.emplace_back(case_name);
    for (const SweepVariable& variable : study.variables)
    {
      names_.texts.push_back(variable.name);
      if (has_numbers(variable))
        names_.numbers.push_back(variable.name);
    }
    for (const SweepSetting& setting : study.settings)
      settings_.push_back(make(setting.value, setting.source_line,
                               "Set " + setting.name + "/Value"));
    for (const SweepResult& result : study.results)
      for (const auto& [text, key] : get_parts(result))
        results_.push_back(make(text, result.source_line,
                                "Result " + result.name + "/" + key));
    if (!study.folder.empty())
      folder_ = make(study.folder, 0, "Folder");
  }

  StudyCase fill(unsigned int number,
                 const std::vector<std::string>& values) const;

private:
  struct Part
  {
    Template text;
    unsigned int line;
    std::string key;
  };

  static std::vector<std::pair<std::string, const char*>>
  get_parts(const SweepResult& result)
  {
    return {{result.of, "Of"}, {result.from, "From"}, {result.to, "To"}};
  }

  template <typename Function>
  auto name_in_errors(const Function& function, const unsigned int line,
                      const std::string& key) const
  {
    try
    {
      return function();
    }
    catch (const BadInput& problem)
    {
      refuse(study_, line, key, problem.message());
    }
  }

  Part make(const std::string& text, const unsigned int line,
            const std::string& key) const
  {
    return name_in_errors(
        [&] {
          return Part{Template(text, names_), line, key};
        },
        line, key);
  }

  std::string fill(const Part& part, const TemplateValues& values) const
  {
    return name_in_errors(
        [&]
        {
          try
          {
            return part.text.fill(values);
          }
          catch (const BadInput& problem)
          {
            throw BadInput("case " + values.texts[0] + ": " +
                           problem.message());
          }
        },
        part.line, part.key);
  }

  double read_time(const Part& part, const TemplateValues& values,
                   double otherwise) const;
  std::vector<ResultRequest> fill_results(const TemplateValues& values) const;
  std::string make_folder(const TemplateValues& values) const;

  const StudyDescription& study_;
  TemplateNames names_;
  std::vector<Part> settings_, results_;
  std::optional<Part> folder_;
};

double Cases::read_time(const Part& part, const TemplateValues& values,
                        const double otherwise) const
{
  const std::string text = fill(part, values);
  double time = otherwise;
  if (!text.empty() && !read_number(text, time))
    refuse(study_, part.line, part.key,
           fmt::format("'{}' is no time: a number in s or an {{expression}} is "
                       "allowed",
                       text));
  return time;
}

std::vector<ResultRequest>
Cases::fill_results(const TemplateValues& values) const
{
  std::vector<ResultRequest> requests;
  for (std::size_t i = 0; i < study_.results.size(); ++i)
  {
    ResultRequest request;
    request.of = fill(results_[3 * i], values);
    request.statistic = study_.results[i].statistic;
    request.from = read_time(results_[3 * i + 1], values, request.from);
    request.to = read_time(results_[3 * i + 2], values, request.to);
    requests.push_back(request);
  }
  return requests;
}

/// A name that no file system or shell stumbles over.
std::string make_plain(const std::string& text)
{
  std::string plain;
  for (const char c : text)
  {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                          std::string("._+-=,@").find(c) != std::string::npos;
    if (is_plain)
      plain += c;
    else if (!plain.empty() && plain.back() != '_')
      plain += '_';
  }
  return plain;
}

std::string Cases::make_folder(const TemplateValues& values) const
{
  if (folder_)
    return make_plain(fill(*folder_, values));
  std::string folder;
  for (std::size_t i = 0; i < study_.variables.size(); ++i)
    folder += (i == 0 ? "" : ",") + study_.variables[i].name + "=" +
              make_plain(values.texts[i + 1]);
  const std::size_t longest_name = 200;
  if (folder.empty() || folder.size() > longest_name)
    return "case_" + values.texts[0];
  return folder;
}

StudyCase Cases::fill(const unsigned int number,
                      const std::vector<std::string>& values) const
{
  StudyCase result;
  result.number = number;
  result.values = values;
  TemplateValues filling{{std::to_string(number)}, {double(number)}};
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const SweepVariable& variable = study_.variables[i];
    filling.texts.push_back(values[i]);
    double value;
    if (filling.numbers.size() < names_.numbers.size() &&
        names_.numbers[filling.numbers.size()] == variable.name &&
        read_number(values[i], value))
      filling.numbers.push_back(value);
    if (!variable.key.empty())
      result.keys.push_back({variable.key, values[i]});
  }
  for (std::size_t i = 0; i < settings_.size(); ++i)
    result.keys.push_back(
        {study_.settings[i].key, fill(settings_[i], filling)});
  result.results = fill_results(filling);
  result.folder = make_folder(filling);
  return result;
}

std::size_t count_cases(const StudyDescription& study)
{
  if (study.variables.empty())
    return 1;
  if (study.combine == Combine::together)
    return study.variables[0].values.size();
  return std::accumulate(study.variables.begin(), study.variables.end(),
                         std::size_t(1),
                         [](const std::size_t n, const SweepVariable& variable)
                         { return n * variable.values.size(); });
}

/// The values of the case with this index from 0.
std::vector<std::string> select_values(const StudyDescription& study,
                                       std::size_t index)
{
  std::vector<std::string> values(study.variables.size());
  for (std::size_t i = values.size(); i-- > 0;)
  {
    const auto& list = study.variables[i].values;
    values[i] = list[index % list.size()];
    if (study.combine == Combine::grid)
      index /= list.size();
  }
  return values;
}

void check_folders(const StudyDescription& study,
                   const std::vector<StudyCase>& cases)
{
  std::map<std::string, unsigned int> owners;
  for (const StudyCase& item : cases)
  {
    const auto [owner, is_new] = owners.emplace(item.folder, item.number);
    if (!is_new || item.folder.empty() || item.folder[0] == '.')
      refuse(study, 0, "Folder",
             is_new ? fmt::format("'{}' is no name of a folder", item.folder)
                    : fmt::format("the cases {} and {} have the same folder "
                                  "'{}': the pattern must name every variable "
                                  "(or {{case}}), and no value may be listed "
                                  "twice",
                                  owner->second, item.number, item.folder));
  }
}
} // namespace

std::vector<std::string> make_range(const double from, const double to,
                                    const unsigned int count,
                                    const Spacing spacing)
{
  if (count < 1)
    throw BadInput("a range of no values: the third number says how many");
  if (count > 1 && from == to)
    throw BadInput(fmt::format("an empty range: it begins and ends at {}",
                               number_text(from)));
  const bool logarithmic = spacing == Spacing::logarithmic;
  if (logarithmic && !(from * to > 0))
    throw BadInput("a logarithmic range cannot begin, end or pass at 0: both "
                   "ends must be above or below it");
  std::vector<std::string> values;
  for (unsigned int i = 0; i < count; ++i)
  {
    const double share = count == 1 ? 0 : double(i) / (count - 1);
    const double value = logarithmic ? from * std::pow(to / from, share)
                                     : from + share * (to - from);
    values.push_back(make_number_text(i + 1 == count && i > 0 ? to : value));
  }
  return values;
}

std::vector<StudyCase> expand(const StudyDescription& study)
{
  check_variables(study);
  check_columns(study);
  check_keys_once(study);
  const Cases all(study);
  std::vector<StudyCase> cases;
  const std::size_t n_cases = count_cases(study);
  for (std::size_t i = 0; i < n_cases; ++i)
    cases.push_back(all.fill(i + 1, select_values(study, i)));
  if (study.keep_folders)
    check_folders(study, cases);
  return cases;
}
} // namespace taut::study
