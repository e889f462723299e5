#include <filesystem>
#include <memory>

#include "case_run.h"
#include "commands.h"
#include "exit_codes.h"

namespace taut::app
{
namespace
{
struct RunArguments
{
  std::string case_file;
  std::string folder;
  std::vector<std::string> overrides;
  bool resume = false;
  bool overwrite = false;
};

io::FolderUse get_use(const RunArguments& arguments)
{
  if (arguments.resume)
    return io::FolderUse::resume;
  return arguments.overwrite ? io::FolderUse::replace : io::FolderUse::fresh;
}

io::OutputFolder get_run_folder(const RunArguments& arguments)
{
  namespace fs = std::filesystem;
  if (!arguments.folder.empty())
    return {arguments.folder};
  return {"results/" + fs::path(arguments.case_file).stem().string()};
}

int get_run_code(const study::Status status)
{
  switch (status)
  {
  case study::Status::completed:
    return done;
  case study::Status::event:
    return fatal_event;
  case study::Status::interrupted:
    return interrupted;
  default:
    return solver_failed;
  }
}

int run(const RunArguments& arguments, const MPI_Comm communicator)
{
  const auto began = Clock::now();
  const auto case_file =
      io::read_case_file(arguments.case_file, arguments.overrides);
  return get_run_code(run_case(case_file, Task::run, get_run_folder(arguments),
                               get_use(arguments), communicator, began)
                          .status);
}
} // namespace

void add_run(CLI::App& program, Action& chosen)
{
  auto* command =
      program.add_subcommand("run", "Run a case and write its results");
  const auto arguments = std::make_shared<RunArguments>();
  command->add_option("CASE", arguments->case_file, "a .prm or .json")
      ->required();
  command->add_option("-o,--output", arguments->folder,
                      "folder of the results; results/<name of the case> if "
                      "none");
  command->add_option("--set", arguments->overrides,
                      "'Section/Key = value' in place of the file's");
  auto* resume = command->add_flag("--resume", arguments->resume,
                                   "go on from the checkpoint in the folder");
  command
      ->add_flag("--overwrite", arguments->overwrite,
                 "replace the run in the folder")
      ->excludes(resume);
  command->callback(
      [&chosen, arguments]
      {
        chosen = [arguments](const MPI_Comm communicator)
        { return run(*arguments, communicator); };
      });
}
} // namespace taut::app
