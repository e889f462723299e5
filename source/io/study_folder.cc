#include <taut/base/exceptions.h>
#include <taut/io/study_folder.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

namespace taut::io
{
namespace
{
namespace fs = std::filesystem;

/// Not while another process writes it.
void remove_study(const StudyFolder& folder)
{
  const int journal = open_journal(folder);
  for (const char* name : {"study.csv", "study.json", "parameters.prm",
                           "log.txt", "cases", "journal.jsonl"})
    fs::remove_all(folder.get(name));
  close(journal);
}
} // namespace

void prepare_folder(const StudyFolder& folder, const bool overwrite)
{
  std::error_code error;
  fs::create_directories(folder.path, error);
  if (error || !fs::is_directory(folder.path) ||
      access(folder.path.c_str(), W_OK) != 0)
    throw BadInput("the output folder cannot be made or written: choose "
                   "another with -o",
                   folder.path, 0, "");
  for (const char* trace : {"run.json", "history.csv", "checkpoint"})
    if (fs::exists(folder.get(trace)))
      throw BadInput("the output folder holds a run: choose another with -o",
                     folder.path, 0, "");
  if (overwrite && fs::exists(folder.journal()))
    remove_study(folder);
}

int open_journal(const StudyFolder& folder)
{
  const std::string file = folder.journal();
  const int descriptor =
      open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0)
    throw BadInput("the journal cannot be opened", file, 0, "");
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0)
    return descriptor;
  close(descriptor);
  throw BadInput("another `taut study` is at work in this folder", folder.path,
                 0, "");
}
} // namespace taut::io
