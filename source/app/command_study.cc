#include <taut/base/exceptions.h>
#include <taut/io/interrupt.h>
#include <taut/io/study_file.h>

#include <deal.II/base/mpi.h>

#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

#include "commands.h"
#include "exit_codes.h"
#include "study_run.h"

namespace taut::app
{
namespace
{
struct StudyArguments
{
  std::vector<std::string> study_files;
  std::string folder;
  std::vector<std::string> overrides;
  unsigned int jobs = std::max(1u, std::thread::hardware_concurrency());
  bool overwrite = false;
  bool retry_failed = false;
  bool dry_run = false;
};

/// Of one of the studies; several in one folder have folders of their own.
std::string get_study_folder(const StudyArguments& arguments,
                             const std::string& study_file)
{
  const std::string name = std::filesystem::path(study_file).stem();
  if (arguments.folder.empty())
    return "results/" + name;
  return arguments.study_files.size() == 1 ? arguments.folder
                                           : arguments.folder + "/" + name;
}

void list_cases(const io::StudyFile& study)
{
  const study::StudyDescription& content = study.content;
  for (const study::StudyCase& item : study.cases)
  {
    std::string line = std::to_string(item.number) + ":";
    for (std::size_t i = 0; i < item.values.size(); ++i)
      line +=
          fmt::format("  {} = {}", content.variables[i].name, item.values[i]);
    if (content.keep_folders)
      line += "  in " + item.folder;
    std::cout << line << '\n';
  }
}

int run_all(const StudyArguments& arguments,
            const std::vector<io::StudyFile>& studies)
{
  // A worker that has died is noticed when its answer does not come.
  std::signal(SIGPIPE, SIG_IGN);
  WorkerPool pool(arguments.jobs);
  int code = done;
  for (std::size_t i = 0; i < studies.size() && code != interrupted; ++i)
  {
    StudyOptions options;
    options.folder = get_study_folder(arguments, arguments.study_files[i]);
    options.overwrite = arguments.overwrite;
    options.retry_failed = arguments.retry_failed;
    const int own_code = run_study(studies[i], options, pool);
    code = own_code == done ? code : own_code;
  }
  return code;
}

int study(const StudyArguments& arguments, const MPI_Comm communicator)
{
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
    throw BadInput("a study starts its own processes: call it without mpirun "
                   "and choose how many by --jobs");
  std::vector<io::StudyFile> studies;
  for (const std::string& file : arguments.study_files)
    studies.push_back(io::read_study_file(file, arguments.overrides));
  if (!arguments.dry_run)
    return run_all(arguments, studies);
  for (const io::StudyFile& file : studies)
    list_cases(file);
  return done;
}
} // namespace

void add_study(CLI::App& program, Action& chosen)
{
  auto* command = program.add_subcommand(
      "study", "Run a case with many values of its keys, on all cores");
  const auto arguments = std::make_shared<StudyArguments>();
  command->add_option("STUDY", arguments->study_files, "a .prm or .json each")
      ->required();
  command->add_option("-o,--output", arguments->folder,
                      "folder of the results; results/<name of the study> if "
                      "none");
  command->add_option("--set", arguments->overrides,
                      "'Section/Key = value' in place of the study file's");
  command
      ->add_option("--jobs", arguments->jobs,
                   "how many cases are computed side by side; as many as "
                   "cores if not given")
      ->check(CLI::Range(1u, 10000u));
  command->add_flag("--overwrite", arguments->overwrite,
                    "replace the study in the folder; otherwise it goes on");
  command->add_flag("--retry-failed", arguments->retry_failed,
                    "compute cases again that failed");
  command->add_flag("--dry-run", arguments->dry_run,
                    "only list the cases with their values and folders");
  command->callback(
      [&chosen, arguments]
      {
        chosen = [arguments](const MPI_Comm communicator)
        { return study(*arguments, communicator); };
      });
}
} // namespace taut::app
