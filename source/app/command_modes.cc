#include <taut/io/film_model.h>
#include <taut/io/first_rank.h>
#include <taut/io/folder_output.h>
#include <taut/io/interrupt.h>
#include <taut/io/modes_writer.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>

#include "commands.h"
#include "exit_codes.h"

namespace taut::app
{
namespace
{
struct ModesArguments
{
  std::string case_file;
  std::string folder;
  std::vector<std::string> overrides;
  bool overwrite = false;
};

io::OutputFolder get_modes_folder(const ModesArguments& arguments)
{
  namespace fs = std::filesystem;
  if (!arguments.folder.empty())
    return {arguments.folder};
  return {"results/modes_" + fs::path(arguments.case_file).stem().string()};
}

int get_modes_code(const study::RunSummary& summary)
{
  switch (summary.status)
  {
  case study::Status::completed:
    return done;
  case study::Status::event:
    // About a start, what came later does not matter.
    return summary.modes ? done : fatal_event;
  case study::Status::interrupted:
    return interrupted;
  default:
    return solver_failed;
  }
}

int run_modes(const ModesArguments& arguments, const MPI_Comm communicator)
{
  const auto began = Clock::now();
  const auto use =
      arguments.overwrite ? io::FolderUse::replace : io::FolderUse::fresh;
  return get_modes_code(run_case(
      io::read_case_file(arguments.case_file, arguments.overrides), Task::modes,
      get_modes_folder(arguments), use, communicator, began));
}
} // namespace

void add_modes(CLI::App& program, Action& chosen)
{
  auto* command = program.add_subcommand(
      "modes", "Find the vibration modes about a state of a case");
  const auto arguments = std::make_shared<ModesArguments>();
  command->add_option("CASE", arguments->case_file, "a .prm or .json")
      ->required();
  command->add_option("-o,--output", arguments->folder,
                      "folder of the results; results/modes_<name of the "
                      "case> if none");
  command->add_option("--set", arguments->overrides,
                      "'Section/Key = value' in place of the file's");
  command->add_flag("--overwrite", arguments->overwrite,
                    "replace the run in the folder");
  command->callback(
      [&chosen, arguments]
      {
        chosen = [arguments](const MPI_Comm communicator)
        { return run_modes(*arguments, communicator); };
      });
}
} // namespace taut::app
