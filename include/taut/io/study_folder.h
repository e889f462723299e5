#pragma once

#include <string>

namespace taut::io
{
/// Where the output of a study goes.
struct StudyFolder
{
  std::string path;

  std::string get(const std::string& name) const
  {
    return path + "/" + name;
  }
  std::string journal() const
  {
    return get("journal.jsonl");
  }
  std::string table() const
  {
    return get("study.csv");
  }
  std::string summary() const
  {
    return get("study.json");
  }
  std::string parameters() const
  {
    return get("parameters.prm");
  }
  std::string log() const
  {
    return get("log.txt");
  }
  /// Of the run of a case.
  std::string get_case(const std::string& name) const
  {
    return get("cases/" + name);
  }
};

/// Makes the folder; with `overwrite`, an old study in it is removed. Errors:
/// BadInput if it cannot be made or written or holds a run, or if another
/// process is at work in it.
void prepare_folder(const StudyFolder& folder, bool overwrite);

/// Opens the journal for this process alone; to be closed by the caller.
/// Errors: BadInput if it cannot be written or another process has it.
int open_journal(const StudyFolder& folder);
} // namespace taut::io
