#include <taut/io/csv_file.h>
#include <taut/io/study_table.h>
#include <taut/io/versions.h>

#include <nlohmann/json.hpp>

namespace taut::io
{
namespace
{
using Json = nlohmann::ordered_json;

std::string make_header(const std::string& name, const std::string& unit)
{
  return unit.empty() ? name : name + " [" + unit + "]";
}

/// As the study says, or as the first case that has the result.
std::string find_result_unit(const StudyState& state, const std::size_t result)
{
  const std::string& given = state.study.results[result].unit;
  if (!given.empty())
    return given;
  for (const auto& [number, outcome] : state.outcomes)
    if (result < outcome.results.size() &&
        !outcome.results[result].unit.empty())
      return outcome.results[result].unit;
  return "";
}

std::vector<std::string> make_headers(const StudyState& state)
{
  std::vector<std::string> headers = {"case [1]"};
  for (const study::SweepVariable& variable : state.study.variables)
    headers.push_back(make_header(variable.name, variable.unit));
  for (std::size_t i = 0; i < state.study.results.size(); ++i)
    headers.push_back(
        make_header(state.study.results[i].name, find_result_unit(state, i)));
  for (const char* name :
       {"time reached [s]", "seconds [s]", "status", "reason", "folder"})
    headers.emplace_back(name);
  return headers;
}

std::string get_folder(const StudyState& state, const study::StudyCase& item)
{
  return state.study.keep_folders ? "cases/" + item.folder : "";
}

std::vector<std::string> make_row(const StudyState& state,
                                  const study::StudyCase& item,
                                  const CaseOutcome& outcome)
{
  std::vector<std::string> row = {std::to_string(item.number)};
  row.insert(row.end(), item.values.begin(), item.values.end());
  for (std::size_t i = 0; i < state.study.results.size(); ++i)
    row.push_back(i < outcome.results.size() ? outcome.results[i].text : "");
  row.push_back(outcome.time_reached ? to_field(*outcome.time_reached) : "");
  row.push_back(to_field(outcome.seconds));
  row.push_back(outcome.status);
  row.push_back(outcome.reason);
  row.push_back(get_folder(state, item));
  return row;
}

Json make_variables(const StudyState& state)
{
  Json variables = Json::array();
  for (const study::SweepVariable& variable : state.study.variables)
    variables.push_back({{"name", variable.name},
                         {"unit", variable.unit},
                         {"key", variable.key},
                         {"values", variable.values}});
  return variables;
}

Json make_results(const StudyState& state)
{
  Json results = Json::array();
  for (std::size_t i = 0; i < state.study.results.size(); ++i)
  {
    const study::SweepResult& result = state.study.results[i];
    results.push_back({{"name", result.name},
                       {"unit", find_result_unit(state, i)},
                       {"of", result.of},
                       {"statistic", study::to_text(result.statistic)},
                       {"from", result.from},
                       {"to", result.to}});
  }
  return results;
}

/// Cases without results, and why.
Json make_failures(const StudyState& state)
{
  Json failures = Json::array();
  for (const study::StudyCase& item : state.cases)
  {
    const auto outcome = state.outcomes.find(item.number);
    if (outcome != state.outcomes.end() && !outcome->second.is_done())
      failures.push_back({{"case", item.number},
                          {"status", outcome->second.status},
                          {"reason", outcome->second.reason},
                          {"folder", get_folder(state, item)}});
  }
  return failures;
}
} // namespace

StudyCounts count_outcomes(const StudyState& state)
{
  StudyCounts counts;
  counts.total = state.cases.size();
  for (const auto& [number, outcome] : state.outcomes)
  {
    counts.done += outcome.is_done() ? 1 : 0;
    counts.failed += outcome.status == "failed" ? 1 : 0;
    counts.refused += outcome.status == "refused" ? 1 : 0;
    counts.interrupted += outcome.status == "interrupted" ? 1 : 0;
  }
  return counts;
}

std::string make_study_table(const StudyState& state)
{
  std::string table = make_csv_line(make_headers(state));
  for (const study::StudyCase& item : state.cases)
  {
    const auto outcome = state.outcomes.find(item.number);
    if (outcome != state.outcomes.end())
      table += make_csv_line(make_row(state, item, outcome->second));
  }
  return table;
}

std::string make_study_json(const StudyState& state, const bool interrupted,
                            const double seconds)
{
  const StudyCounts counts = count_outcomes(state);
  Json object;
  object["title"] = state.study.title;
  object["status"] = interrupted ? "interrupted" : "completed";
  object["cases"] = {{"total", counts.total},
                     {"done", counts.done},
                     {"failed", counts.failed},
                     {"refused", counts.refused},
                     {"interrupted", counts.interrupted}};
  object["seconds"] = seconds;
  object["command"] = state.study.command;
  object["case_file"] = state.study.case_file;
  object["variables"] = make_variables(state);
  object["results"] = make_results(state);
  object["not_done"] = make_failures(state);
  object["versions"] = get_versions();
  const int indent = 2;
  return object.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}
} // namespace taut::io
