#include "result_folder.h"

#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace taut::app
{
namespace
{
namespace fs = std::filesystem;

/// A run that was killed early has written only the first of these.
bool holds_results(const fs::path& folder)
{
  const char* const traces[] = {"parameters.prm", "history.csv", "fields.pvd",
                                "run.json",       "modes.csv",   "study.csv"};
  return std::any_of(std::begin(traces), std::end(traces),
                     [&](const char* name)
                     { return fs::exists(folder / name); });
}

/// Names of the folders with results beside `folder`.
std::vector<std::string> list_neighbours(const fs::path& folder)
{
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(
           folder.parent_path().empty() ? "." : folder.parent_path(), error))
    if (entry.is_directory(error) && holds_results(entry.path()))
      names.push_back(entry.path().filename());
  return names;
}

/// Of a path as the user wrote it, without a slash at its end.
std::string suggest_neighbour(const fs::path& folder)
{
  const std::string nearest =
      nearest_name(folder.filename(), list_neighbours(folder));
  if (nearest.empty())
    return "";
  return "; did you mean '" + (folder.parent_path() / nearest).string() + "'?";
}
} // namespace

void check_result_folder(const std::string& folder)
{
  if (fs::is_directory(folder) && holds_results(folder))
    return;
  fs::path path = fs::path(folder).lexically_normal();
  if (path.filename().empty())
    path = path.parent_path();
  const std::string problem =
      fs::is_directory(folder)
          ? "is not the folder of a run, of modes or of a study"
          : "there is no such folder";
  throw BadInput(problem + suggest_neighbour(path), folder, 0, "");
}
} // namespace taut::app
