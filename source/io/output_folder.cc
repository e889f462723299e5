#include <taut/base/exceptions.h>
#include <taut/io/output_folder.h>

#include <unistd.h>

#include <filesystem>

namespace taut::io
{
namespace
{
namespace fs = std::filesystem;

bool holds_run(const OutputFolder& folder)
{
  for (const std::string& trace :
       {folder.summary(), folder.history(), folder.checkpoint()})
    if (fs::exists(trace))
      return true;
  return false;
}

void remove_run(const OutputFolder& folder)
{
  for (const char* name :
       {"parameters.prm", "history.csv", "events.csv", "fields.pvd", "fields",
        "run.json", "section.csv", "spectrum.csv", "response.csv", "modes.csv",
        "log.txt", "checkpoint", "compare.json", "compare.csv", "compare.png",
        "compare.svg", "pictures", "open_in_paraview.py", "report.html"})
    fs::remove_all(folder.get(name));
}

void create(const std::string& path)
{
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path) || access(path.c_str(), W_OK) != 0)
    throw BadInput("the output folder cannot be made or written: choose "
                   "another with -o",
                   path, 0, "");
}
} // namespace

void check_folder(const OutputFolder& folder, const FolderUse use)
{
  if (use == FolderUse::resume && !fs::exists(folder.get("checkpoint/state")))
    throw BadInput("there is no checkpoint to resume from", folder.path, 0, "");
  if (use == FolderUse::fresh && holds_run(folder))
    throw BadInput("the output folder holds another run: go on with it by "
                   "--resume, replace it by --overwrite or choose another "
                   "folder with -o",
                   folder.path, 0, "");
}

void prepare_folder(const OutputFolder& folder, const FolderUse use)
{
  create(folder.path);
  if (use == FolderUse::replace)
    remove_run(folder);
  // What it says is no longer true.
  if (use == FolderUse::resume)
    fs::remove(folder.summary());
}
} // namespace taut::io
