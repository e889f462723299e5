#include "case_run.h"

#include <taut/io/film_model.h>
#include <taut/io/first_rank.h>
#include <taut/io/folder_output.h>
#include <taut/io/interrupt.h>
#include <taut/io/modes_writer.h>
#include <taut/io/versions.h>
#include <taut/study/modes.h>
#include <taut/study/run_demes.h>
#include <taut/study/run_resonator.h>

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace taut::app
{
namespace
{
/// A failure before the first step counts as one of the run.
study::RunSummary make_failed(const std::exception& error)
{
  study::RunSummary summary;
  summary.status = study::Status::failed;
  summary.reason = error.what();
  return summary;
}

/// Calls calculate() with the time from `began` on in its summary.
template <typename Function>
study::RunSummary attempt(const study::Case& run_case,
                          const Clock::time_point began,
                          const Function& calculate)
{
  study::RunSummary summary;
  try
  {
    summary = io::name_case_in_errors(run_case, calculate);
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
      std::chrono::duration<double>(Clock::now() - began).count();
  return summary;
}

study::RunSummary run_lumped_case(const study::Case& lumped_case,
                                  const Task task, study::RunOutput& output)
{
  if (task == Task::modes)
    return study::run_lumped_modes(lumped_case, output);
  return lumped_case.model == "demes"
             ? study::run_demes(lumped_case, output)
             : study::run_resonator(lumped_case, output);
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

/// One run into a folder.
class CaseRun
{
public:
  CaseRun(const io::CaseFile& case_file, const Task task,
          const io::OutputFolder& folder, const io::FolderUse use,
          const MPI_Comm communicator, const Clock::time_point began,
          io::RecordedRun* record)
      : communicator_(communicator), began_(began), folder_(folder), use_(use),
        case_file_(case_file), task_(task), record_(record)
  {
  }

  study::RunSummary run()
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

  study::RunSummary run_film()
  {
    const study::Case& film_case = case_file_.content;
    const bool resume = use_ == io::FolderUse::resume;
    io::FilmModel model(film_case, communicator_, resume ? &stored_ : nullptr);
    io::FolderOutput output = open_output();
    return finish(output,
                  [&](study::RunOutput& all)
                  {
                    std::optional<study::Checkpoint> checkpoint;
                    if (resume)
                      checkpoint = restore(model.structure());
                    else
                      model.adapt(film_case);
                    greet(output, model);
                    return task_ == Task::modes
                               ? find_modes(model.structure(), all)
                               : study::run_film(film_case, model.structure(),
                                                 all, checkpoint);
                  });
  }

  study::RunSummary find_modes(structure::Structure& structure,
                               study::RunOutput& output) const
  {
    return study::run_film_modes(case_file_.content, structure, output,
                                 [this](const study::ModeShapes& shapes) {
                                   io::write_mode_shapes(folder_.path, shapes);
                                 });
  }

  study::RunSummary run_lumped()
  {
    if (use_ == io::FolderUse::resume)
      throw BadInput("a lumped run takes no checkpoints: start it anew with "
                     "--overwrite",
                     case_file_.content.file, 0, "");
    io::FolderOutput output = open_output();
    return finish(output, [&](study::RunOutput& all)
                  { return run_lumped_case(case_file_.content, task_, all); });
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
  study::RunSummary finish(io::FolderOutput& output, const Function& calculate)
  {
    io::catch_interrupts();
    std::optional<io::RecordingOutput> recording;
    if (record_)
      recording.emplace(*record_, &output);
    study::RunOutput& all =
        recording ? static_cast<study::RunOutput&>(*recording) : output;
    const auto summary =
        attempt(case_file_.content, began_, [&] { return calculate(all); });
    if (summary.modes)
      write_modes(*summary.modes, output);
    for (const std::string& note : summary.notes)
      output.say("note: " + note);
    output.finish(summary);
    return summary;
  }

  void write_modes(const study::ModesReport& modes, io::FolderOutput& output)
  {
    io::on_first_rank(communicator_,
                      [&]
                      {
                        io::write_mode_table(folder_.get("modes.csv"), modes);
                        return true;
                      });
    output.say(describe(modes));
  }

  const MPI_Comm communicator_;
  const Clock::time_point began_;
  const io::OutputFolder& folder_;
  const io::FolderUse use_;
  const io::CaseFile& case_file_;
  const Task task_;
  io::RecordedRun* record_;
  /// Empty unless the run is resumed.
  io::StoredRun stored_;
};
} // namespace

study::RunSummary run_case(const io::CaseFile& case_file, const Task task,
                           const io::OutputFolder& folder,
                           const io::FolderUse use, const MPI_Comm communicator,
                           const Clock::time_point began,
                           io::RecordedRun* record)
{
  return CaseRun(case_file, task, folder, use, communicator, began, record)
      .run();
}

study::RunSummary run_case_in_memory(const io::CaseFile& case_file,
                                     const Task task,
                                     const MPI_Comm communicator,
                                     io::RecordedRun& record)
{
  const study::Case& content = case_file.content;
  io::RecordingOutput output(record);
  std::optional<io::FilmModel> model;
  if (content.model == "film")
    model.emplace(content, communicator);
  io::catch_interrupts();
  return attempt(content, Clock::now(),
                 [&]
                 {
                   if (!model)
                     return run_lumped_case(content, task, output);
                   model->adapt(content);
                   if (task == Task::modes)
                     return study::run_film_modes(
                         content, model->structure(), output,
                         [](const study::ModeShapes&) {});
                   return study::run_film(content, model->structure(), output);
                 });
}
} // namespace taut::app
