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

/// The modes as lines for the user.
std::string describe(const study::ModesReport& report)
{
  std::string text = fmt::format(
      "modes about the state at t = {:.6g} s, which is {}:", report.time,
      report.stable ? "stable" : "unstable");
  for (std::size_t i = 0; i < report.modes.size(); ++i)
  {
    const auto& mode = report.modes[i];
    text += fmt::format("\n{:4}  {:12.6g} Hz", i + 1, mode.frequency());
    if (mode.square < 0)
      text += fmt::format("  unstable, omega^2 = {:.6g} 1/s^2", mode.square);
    if (std::abs(mode.damping_ratio) > 1e-9)
      text += fmt::format("  damping ratio {:.3g}", mode.damping_ratio);
  }
  return text;
}

study::RunSummary find_modes(const io::CaseFile& case_file,
                             const io::OutputFolder& folder,
                             io::FilmModel* model, io::FolderOutput& output)
{
  const study::Case& content = case_file.content;
  if (!model)
    return study::run_lumped_modes(content, output);
  model->adapt(content);
  return study::run_film_modes(content, model->structure(), output,
                               [&](const study::ModeShapes& shapes)
                               { io::write_mode_shapes(folder.path, shapes); });
}

/// What goes wrong on the way is told by the summary.
study::RunSummary try_to_find(const io::CaseFile& case_file,
                              const io::OutputFolder& folder,
                              io::FilmModel* model, io::FolderOutput& output)
{
  study::RunSummary failed;
  failed.status = study::Status::failed;
  try
  {
    return io::name_case_in_errors(
        case_file.content,
        [&] { return find_modes(case_file, folder, model, output); });
  }
  catch (const SolverFailed& error)
  {
    failed.reason = error.what();
  }
  catch (const StepRejected& error)
  {
    failed.reason = error.what();
  }
  return failed;
}

void tell(const study::RunSummary& summary, io::FolderOutput& output)
{
  if (summary.modes)
    output.say(describe(*summary.modes));
  for (const std::string& note : summary.notes)
    output.say("note: " + note);
  output.finish(summary);
}

int run_modes(const ModesArguments& arguments, const MPI_Comm communicator)
{
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const io::OutputFolder folder = get_modes_folder(arguments);
  const auto use =
      arguments.overwrite ? io::FolderUse::replace : io::FolderUse::fresh;
  const io::CaseFile case_file =
      io::read_case_file(arguments.case_file, arguments.overrides);
  const auto on_first = [&](const auto& function)
  {
    io::on_first_rank(communicator,
                      [&]
                      {
                        function();
                        return true;
                      });
  };
  on_first([&] { io::check_folder(folder, use); });
  std::unique_ptr<io::FilmModel> model;
  if (case_file.content.model == "film")
    model = std::make_unique<io::FilmModel>(case_file.content, communicator);
  on_first([&] { io::prepare_folder(folder, use); });
  io::FolderOutput output(folder, case_file, communicator);
  io::catch_interrupts();
  auto summary = try_to_find(case_file, folder, model.get(), output);
  summary.timings["total"] =
      std::chrono::duration<double>(Clock::now() - began).count();
  if (summary.modes)
    on_first(
        [&] { io::write_mode_table(folder.get("modes.csv"), *summary.modes); });
  tell(summary, output);
  return get_modes_code(summary);
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
