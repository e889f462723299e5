#include <taut/base/exceptions.h>
#include <taut/io/files.h>
#include <taut/io/study_journal.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace taut::io
{
namespace
{
using Json = nlohmann::ordered_json;

std::string write_identity(const StudyIdentity& identity)
{
  const Json object = {{"study", identity.parameters},
                       {"case_file", identity.case_content}};
  return object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// What the results of the lines below are.
std::string write_questions(const study::StudyDescription& study)
{
  Json questions = Json::array();
  for (const study::SweepResult& result : study.results)
    questions.push_back({{"name", result.name},
                         {"of", result.of},
                         {"statistic", study::to_text(result.statistic)},
                         {"from", result.from},
                         {"to", result.to}});
  return Json{{"results", questions}}.dump() + "\n";
}

/// A whole line but for its end, if it holds a JSON object; else null.
Json parse_line(const std::string& line)
{
  const Json object = Json::parse(line, nullptr, false);
  return object.is_object() ? object : Json();
}
} // namespace

StudyJournal::StudyJournal(const StudyFolder& folder, const StudyFile& study)
    : file_(folder.journal()), descriptor_(open_journal(folder))
{
  try
  {
    read(study);
    append(write_questions(study.content));
  }
  catch (...)
  {
    close(descriptor_);
    throw;
  }
}

StudyJournal::~StudyJournal()
{
  close(descriptor_);
}

void StudyJournal::read(const StudyFile& study)
{
  std::istringstream stream(read_file(file_));
  const std::string questions = write_questions(study.content);
  std::string line, asked;
  off_t whole = 0;
  bool has_identity = false;
  while (std::getline(stream, line) && !stream.eof())
  {
    const Json object = parse_line(line);
    if (object.contains("study"))
    {
      has_identity = true;
      const StudyIdentity then{object["study"], object.at("case_file")};
      const std::string difference = find_difference(then, study.identity);
      if (!difference.empty())
        throw BadInput("the folder holds another study: " + difference +
                           "; choose another folder with -o, or begin anew by "
                           "--overwrite",
                       file_, 0, "");
    }
    else if (object.contains("case"))
    {
      CaseOutcome outcome = read_outcome(line);
      if (asked != questions)
        outcome.results.clear();
      outcomes_[outcome.number] = outcome;
    }
    else if (object.contains("results"))
      asked = line + "\n";
    whole += static_cast<off_t>(line.size()) + 1;
  }
  if (ftruncate(descriptor_, whole) != 0)
    throw std::runtime_error("cannot write " + file_);
  if (!has_identity)
    append(write_identity(study.identity));
}

void StudyJournal::add(const CaseOutcome& outcome)
{
  append(write_line(outcome));
}

void StudyJournal::append(const std::string& line)
{
  // One call: whoever kills the process leaves the line whole or nearly so.
  if (write(descriptor_, line.data(), line.size()) !=
      static_cast<ssize_t>(line.size()))
    throw std::runtime_error("cannot write " + file_ + ": " +
                             std::strerror(errno));
}
} // namespace taut::io
