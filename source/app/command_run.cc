#include <taut/io/film_model.h>
#include <taut/io/first_rank.h>
#include <taut/io/folder_output.h>
#include <taut/io/interrupt.h>
#include <taut/io/versions.h>
#include <taut/study/run_demes.h>
#include <taut/study/run_resonator.h>

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "commands.h"
#include "exit_codes.h"

namespace taut::app
{
namespace
{
using Clock = std::chrono::steady_clock;

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

/// A failure before the first step counts as one of the run.
study::RunSummary make_failed(const std::exception& error)
{
  study::RunSummary summary;
  summary.status = study::Status::failed;
  summary.reason = error.what();
  return summary;
}

/// One call of the command.
class RunCommand
{
public:
  RunCommand(const RunArguments& arguments, const MPI_Comm communicator)
      : communicator_(communicator), began_(Clock::now()),
        folder_(get_run_folder(arguments)), use_(get_use(arguments)),
        case_file_(io::read_case_file(arguments.case_file, arguments.overrides))
  {
  }

  int run()
  {
    read_folder();
    return case_file_.content.model == "film" ? run_film() : run_lumped();
  }

private:
  /// Of the folder before anything is written into it.
  void read_folder()
  {
    stored_ = io::on_first_rank(communicator_,
                                [&]
                                {
                                  io::check_folder(folder_, use_);
                                  return use_ == io::FolderUse::resume
                                             ? io::read_checkpoint(
                                                   folder_.checkpoint())
                                             : io::StoredRun();
                                });
    if (use_ == io::FolderUse::resume)
      io::check_parameters(stored_, case_file_);
  }

  io::FolderOutput open_output()
  {
    io::on_first_rank(communicator_,
                      [&]
                      {
                        io::prepare_folder(folder_, use_);
                        return true;
                      });
    return use_ == io::FolderUse::resume
               ? io::FolderOutput(folder_, case_file_, communicator_,
                                  stored_.progress)
               : io::FolderOutput(folder_, case_file_, communicator_);
  }

  int run_film()
  {
    const study::Case& film_case = case_file_.content;
    const bool resume = use_ == io::FolderUse::resume;
    io::FilmModel model(film_case, communicator_, resume ? &stored_ : nullptr);
    io::FolderOutput output = open_output();
    return finish(output,
                  [&]
                  {
                    std::optional<study::Checkpoint> checkpoint;
                    if (resume)
                      checkpoint = restore(model.structure());
                    else
                      model.adapt(film_case);
                    greet(output, model);
                    return study::run_film(film_case, model.structure(), output,
                                           checkpoint);
                  });
  }

  int run_lumped()
  {
    if (use_ == io::FolderUse::resume)
      throw BadInput("a lumped run takes no checkpoints: start it anew with "
                     "--overwrite",
                     case_file_.content.file, 0, "");
    io::FolderOutput output = open_output();
    const study::Case& lumped_case = case_file_.content;
    const auto run =
        lumped_case.model == "demes" ? study::run_demes : study::run_resonator;
    return finish(output, [&] { return run(lumped_case, output); });
  }

  study::Checkpoint restore(const structure::Structure& structure)
  {
    return io::name_case_in_errors(
        case_file_.content, [&] { return restore_state(stored_, structure); });
  }

  void greet(io::FolderOutput& output, io::FilmModel& model) const
  {
    output.say(fmt::format(
        "taut {}: {}\n{} cells, {} free unknowns, {} rank(s), BLAS {}",
        io::get_taut_version(), case_file_.content.device.title,
        model.triangulation().n_global_active_cells(),
        model.structure().n_free_global(),
        dealii::Utilities::MPI::n_mpi_processes(communicator_),
        io::get_versions()["BLAS"]));
    if (use_ == io::FolderUse::resume)
      output.say(fmt::format("going on from t = {:.6g} s, step {}",
                             stored_.progress.time, stored_.progress.steps));
  }

  template <typename Function>
  int finish(io::FolderOutput& output, const Function& calculate)
  {
    io::catch_interrupts();
    study::RunSummary summary;
    try
    {
      summary = io::name_case_in_errors(case_file_.content, calculate);
    }
    catch (const SolverFailed& error)
    {
      summary = make_failed(error);
    }
    catch (const StepRejected& error)
    {
      summary = make_failed(error);
    }
    summary.timings["total"] =
        std::chrono::duration<double>(Clock::now() - began_).count();
    for (const std::string& note : summary.notes)
      output.say("note: " + note);
    output.finish(summary);
    return get_run_code(summary.status);
  }

  const MPI_Comm communicator_;
  const Clock::time_point began_;
  const io::OutputFolder folder_;
  const io::FolderUse use_;
  const io::CaseFile case_file_;
  /// Empty unless the run is resumed.
  io::StoredRun stored_;
};
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
        { return RunCommand(*arguments, communicator).run(); };
      });
}
} // namespace taut::app
