#pragma once

#include <string>

namespace taut::io
{
enum class FolderUse
{
  fresh,   ///< must not hold a run
  replace, ///< the files of an old run are removed
  resume   ///< must hold a checkpoint
};

/// Where the output of a run goes, as absolute or relative paths.
struct OutputFolder
{
  std::string path;
  /// Whether the files of a finished run are on the disk before it ends. Runs
  /// that take less time than the disk may do without.
  bool wait_for_disk = true;

  std::string get(const std::string& name) const
  {
    return path + "/" + name;
  }
  std::string parameters() const
  {
    return get("parameters.prm");
  }
  std::string history() const
  {
    return get("history.csv");
  }
  std::string events() const
  {
    return get("events.csv");
  }
  std::string summary() const
  {
    return get("run.json");
  }
  std::string log() const
  {
    return get("log.txt");
  }
  std::string checkpoint() const
  {
    return get("checkpoint");
  }
};

/// Errors: BadInput if the folder holds another run, or has no checkpoint to
/// resume.
void check_folder(const OutputFolder& folder, FolderUse use);

/// Makes the checked folder ready, on one rank. Errors: BadInput if it cannot
/// be made or written.
void prepare_folder(const OutputFolder& folder, FolderUse use);
} // namespace taut::io
