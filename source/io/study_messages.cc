#include <taut/io/study_messages.h>

#include <cmath>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace taut::io
{
namespace
{
using Json = nlohmann::ordered_json;

/// JSON has no infinite numbers: they are left out.
void put_finite(Json& object, const char* name, const double value)
{
  if (std::isfinite(value))
    object[name] = value;
}

Json to_json(const study::ResultRequest& request)
{
  Json object = {{"of", request.of},
                 {"statistic", study::to_text(request.statistic)}};
  put_finite(object, "from", request.from);
  put_finite(object, "to", request.to);
  return object;
}

study::ResultRequest read_request(const Json& object)
{
  study::ResultRequest request;
  request.of = object.at("of");
  for (const auto& [word, statistic] : study::get_statistic_words())
    if (object.at("statistic") == word)
      request.statistic = statistic;
  request.from = object.value("from", request.from);
  request.to = object.value("to", request.to);
  return request;
}

template <typename Read>
auto read_line(const std::string& line, const Read& read)
{
  try
  {
    return read(Json::parse(line));
  }
  catch (const Json::exception& error)
  {
    throw std::runtime_error("a line of a study cannot be read: " +
                             std::string(error.what()));
  }
}
} // namespace

std::string write_line(const CaseJob& job)
{
  Json object = {{"case", job.number},      {"file", job.case_file},
                 {"command", job.command},  {"overrides", job.overrides},
                 {"folder", job.folder},    {"resume", job.resume},
                 {"results", Json::array()}};
  for (const study::ResultRequest& request : job.results)
    object["results"].push_back(to_json(request));
  return object.dump() + "\n";
}

CaseJob read_job(const std::string& line)
{
  return read_line(line,
                   [](const Json& object)
                   {
                     CaseJob job;
                     job.number = object.at("case");
                     job.case_file = object.at("file");
                     job.command = object.at("command");
                     object.at("overrides").get_to(job.overrides);
                     job.folder = object.at("folder");
                     job.resume = object.at("resume");
                     for (const Json& request : object.at("results"))
                       job.results.push_back(read_request(request));
                     return job;
                   });
}

std::string write_line(const CaseOutcome& outcome)
{
  Json object = {{"case", outcome.number},
                 {"status", outcome.status},
                 {"reason", outcome.reason},
                 {"seconds", outcome.seconds},
                 {"results", Json::array()}};
  if (outcome.time_reached)
    put_finite(object, "time_reached", *outcome.time_reached);
  for (const ResultValue& result : outcome.results)
    object["results"].push_back({result.text, result.unit});
  if (outcome.mistake)
    object["mistake"] = {{"result", outcome.mistake->result},
                         {"message", outcome.mistake->message}};
  // A reason may quote bytes of a file that are no text.
  return object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

CaseOutcome read_outcome(const std::string& line)
{
  return read_line(line,
                   [](const Json& object)
                   {
                     CaseOutcome outcome;
                     outcome.number = object.at("case");
                     outcome.status = object.at("status");
                     outcome.reason = object.at("reason");
                     outcome.seconds = object.at("seconds");
                     if (object.contains("time_reached"))
                       outcome.time_reached =
                           object["time_reached"].get<double>();
                     for (const Json& result : object.at("results"))
                       outcome.results.push_back({result.at(0), result.at(1)});
                     if (object.contains("mistake"))
                       outcome.mistake =
                           ResultMistake{object["mistake"].at("result"),
                                         object["mistake"].at("message")};
                     return outcome;
                   });
}
} // namespace taut::io
