#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/io/csv_file.h>
#include <taut/io/interrupt.h>
#include <taut/io/run_results.h>
#include <taut/lumped/resonator_run.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include <boost/algorithm/string.hpp>
#include <nlohmann/json.hpp>

namespace taut::io
{
namespace
{
using Json = nlohmann::ordered_json;

const char* const event_prefix = "event ";

ResultValue compute_event_result(const RecordedRun& run,
                                 const study::ResultRequest& request,
                                 const std::vector<std::string>& known)
{
  const std::string name =
      boost::trim_copy(request.of.substr(std::string(event_prefix).size()));
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw BadInput("the case has no event '" + name + "'; " +
                   suggest(name, known));
  const bool wants_time = request.statistic == study::Statistic::time;
  ResultValue result{"", wants_time ? "s" : ""};
  for (const RecordedEvent& event : run.events)
    if ((event.name == name || event.kind == name) &&
        event.time >= request.from && event.time <= request.to)
    {
      result.text = to_field(wants_time ? event.time : event.value);
      break;
    }
  return result;
}

bool is_time(const study::Statistic statistic)
{
  return statistic == study::Statistic::time_of_minimum ||
         statistic == study::Statistic::time_of_maximum;
}

ResultValue compute_column_result(const RecordedRun& run,
                                  const std::size_t column,
                                  const study::ResultRequest& request)
{
  std::vector<double> times, values;
  for (const std::vector<double>& row : run.rows)
  {
    times.push_back(row[0]);
    values.push_back(row[column]);
  }
  const auto value = study::compute_statistic(times, values, request);
  return {value && std::isfinite(*value) ? to_field(*value) : "",
          is_time(request.statistic) ? "s" : run.columns[column].unit};
}

/// The member `name` of an object or an array; null if there is none.
const Json* find_member(const Json& parent, const std::string& name)
{
  const bool is_index =
      !name.empty() && name.size() < 10 &&
      std::all_of(name.begin(), name.end(),
                  [](const unsigned char c) { return std::isdigit(c) != 0; });
  if (parent.is_object() && parent.contains(name))
    return &parent[name];
  if (parent.is_array() && is_index && std::stoul(name) < parent.size())
    return &parent[std::stoul(name)];
  return nullptr;
}

std::string to_text(const Json& value, const std::string& path)
{
  if (value.is_null())
    return "";
  if (value.is_string())
    return value.get<std::string>();
  if (value.is_number())
    return to_field(value.get<double>());
  if (value.is_boolean())
    return value.dump();
  throw BadInput(
      "'" + path + "' of run.json is no single value: add " +
      (value.is_array() ? "/0 or another index" : "the name of a member"));
}

/// What might have been meant by a name that is neither.
[[noreturn]] void refuse_name(const RecordedRun& run, const Json& summary,
                              const std::string& name)
{
  std::vector<std::string> known;
  for (const study::Column& column : run.columns)
    known.push_back(column.name);
  for (const auto& member : summary.items())
    known.push_back(member.key());
  throw BadInput("'" + name +
                 "' is neither a column of history.csv nor in run.json; " +
                 suggest(name, known));
}

/// Only the first part of a path must exist: what a run finds out about itself
/// differs from case to case. A run that an event has stopped may not have come
/// to what it should find out.
ResultValue compute_summary_result(const RecordedRun& run,
                                   const study::ResultRequest& request)
{
  const Json summary = Json::parse(run.read_summary());
  std::vector<std::string> parts;
  boost::split(parts, request.of, [](const char c) { return c == '/'; });
  if (!find_member(summary, parts[0]))
  {
    if (summary.at("status") == "event")
      return {};
    refuse_name(run, summary, request.of);
  }
  if (request.statistic != study::Statistic::final)
    throw BadInput("'" + request.of +
                   "' of run.json is one value and takes no statistic");
  const Json* value = &summary;
  for (const std::string& part : parts)
    if (value)
      value = find_member(*value, part);
  return {value ? to_text(*value, request.of) : "", ""};
}
} // namespace

void RecordingOutput::begin(const std::vector<study::Column>& columns)
{
  run_.columns = columns;
  PassingOutput::begin(columns);
}

void RecordingOutput::write_row(const std::vector<double>& row)
{
  run_.rows.push_back(row);
  PassingOutput::write_row(row);
}

void RecordingOutput::write_event(const study::EventRecord& event)
{
  run_.events.push_back({event.name, event.kind, event.time, event.value});
  PassingOutput::write_event(event);
}

bool RecordingOutput::interrupted()
{
  return has_next() ? PassingOutput::interrupted() : was_interrupted();
}

std::vector<std::string> get_event_names(const study::Case& run_case)
{
  using lumped::ResonatorFailure;
  if (run_case.model == "demes")
    return {"film pushes"};
  if (run_case.model == "resonator")
    return {lumped::to_text(ResonatorFailure::loss_of_tension_1),
            lumped::to_text(ResonatorFailure::loss_of_tension_2),
            lumped::to_text(ResonatorFailure::breakdown)};
  std::vector<std::string> names;
  for (const structure::EventDescription& event : run_case.device.events)
    names.push_back(event.name);
  if (run_case.procedure.analysis == structure::Analysis::continuation)
    for (const char* kind :
         {"limit_point", "bifurcation", "branch_switch", "landing"})
      names.emplace_back(kind);
  return names;
}

ResultValue compute_result(const RecordedRun& run,
                           const study::ResultRequest& request,
                           const std::vector<std::string>& events)
{
  if (boost::starts_with(request.of, event_prefix))
    return compute_event_result(run, request, events);
  const auto column = std::find_if(run.columns.begin(), run.columns.end(),
                                   [&](const study::Column& candidate)
                                   { return candidate.name == request.of; });
  if (column != run.columns.end())
    return compute_column_result(run, column - run.columns.begin(), request);
  return compute_summary_result(run, request);
}
} // namespace taut::io
