#include <taut/base/exceptions.h>
#include <taut/io/comparison_demes_writer.h>
#include <taut/io/comparison_writer.h>
#include <taut/io/files.h>
#include <taut/io/film_model.h>
#include <taut/io/first_rank.h>
#include <taut/io/folder_output.h>
#include <taut/io/interrupt.h>

#include <filesystem>
#include <memory>

#include "commands.h"
#include "exit_codes.h"
#include "python_script.h"

namespace taut::app
{
namespace
{
struct CompareArguments
{
  std::string case_file;
  std::string folder;
  std::vector<std::string> overrides;
  bool overwrite = false;
};

io::OutputFolder get_comparison_folder(const CompareArguments& arguments)
{
  namespace fs = std::filesystem;
  if (!arguments.folder.empty())
    return {arguments.folder};
  return {"results/compare_" + fs::path(arguments.case_file).stem().string()};
}

/// Of either kind of comparison.
template <class Comparison>
void write_files(const io::OutputFolder& folder, const Comparison& comparison,
                 io::FolderOutput& output)
{
  io::replace_file(folder.get("compare.json"),
                   io::make_comparison_json(comparison));
  io::write_comparison_table(folder.get("compare.csv"), comparison);
  const std::string problem = run_plot_script("plot_compare.py", {folder.path});
  output.say(problem.empty()
                 ? "plots in " + folder.get("compare.png") + " and compare.svg"
                 : problem);
}

int get_comparison_code(const study::Status status)
{
  switch (status)
  {
  case study::Status::failed:
    return solver_failed;
  case study::Status::interrupted:
    return interrupted;
  default:
    // A failure of the device is what a comparison is about.
    return done;
  }
}

/// A case by finite elements beside the resonator it stands for.
struct ResonatorModels
{
  study::ResonatorEquivalent equivalent;

  ResonatorModels(const study::Case& film_case, const fe::MeshData& mesh)
      : equivalent(study::make_resonator_equivalent(film_case, mesh))
  {
  }
  study::Case make_observed(const study::Case& film_case) const
  {
    return study::make_observed_case(film_case, equivalent);
  }
  study::Comparison run(const study::Case& film_case,
                        structure::Structure& structure,
                        study::RunOutput& output) const
  {
    return study::compare_models(film_case, equivalent, structure, output);
  }
};

/// A case by finite elements beside the DEMES of one angle.
struct DemesModels
{
  study::DemesEquivalent equivalent;

  DemesModels(const study::Case& film_case, const fe::MeshData& mesh)
      : equivalent(study::make_demes_equivalent(film_case, mesh))
  {
  }
  study::Case make_observed(const study::Case& film_case) const
  {
    return study::make_observed_demes_case(film_case);
  }
  study::DemesComparison run(const study::Case& film_case,
                             structure::Structure& structure,
                             study::RunOutput& output) const
  {
    return study::compare_demes_models(film_case, equivalent, structure,
                                       output);
  }
};

template <class Models>
int compare(const CompareArguments& arguments, const io::CaseFile& case_file,
            const MPI_Comm communicator)
{
  const study::Case& film_case = case_file.content;
  const Models models(
      film_case, io::read_shared_mesh(film_case.device.mesh, communicator));
  io::CaseFile observed = case_file;
  observed.content = models.make_observed(film_case);
  io::FilmModel model(observed.content, communicator);
  const io::OutputFolder folder = get_comparison_folder(arguments);
  io::on_first_rank(communicator,
                    [&]
                    {
                      io::prepare_folder(folder, arguments.overwrite
                                                     ? io::FolderUse::replace
                                                     : io::FolderUse::fresh);
                      return true;
                    });
  io::FolderOutput output(folder, observed, communicator);
  io::catch_interrupts();
  model.adapt(observed.content);
  const auto comparison = io::name_case_in_errors(
      film_case,
      [&] { return models.run(film_case, model.structure(), output); });
  output.finish(comparison.film_summary);
  output.say(io::describe_comparison(comparison));
  if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    write_files(folder, comparison, output);
  return get_comparison_code(comparison.film_summary.status);
}

int compare(const CompareArguments& arguments, const MPI_Comm communicator)
{
  const auto case_file =
      io::read_case_file(arguments.case_file, arguments.overrides);
  if (case_file.content.demes_comparison)
  {
    study::check_comparable_demes(case_file.content);
    return compare<DemesModels>(arguments, case_file, communicator);
  }
  study::check_comparable(case_file.content);
  return compare<ResonatorModels>(arguments, case_file, communicator);
}
} // namespace

void add_compare(CLI::App& program, Action& chosen)
{
  auto* command = program.add_subcommand(
      "compare", "Run a film case by finite elements and as a lumped model, "
                 "and show the differences");
  const auto arguments = std::make_shared<CompareArguments>();
  command
      ->add_option("CASE", arguments->case_file,
                   "a .prm or .json with a section Comparison")
      ->required();
  command->add_option("-o,--output", arguments->folder,
                      "folder of the results; results/compare_<name of the "
                      "case> if none");
  command->add_option("--set", arguments->overrides,
                      "'Section/Key = value' in place of the file's");
  command->add_flag("--overwrite", arguments->overwrite,
                    "replace the results in the folder");
  command->callback(
      [&chosen, arguments]
      {
        chosen = [arguments](const MPI_Comm communicator)
        { return compare(*arguments, communicator); };
      });
}
} // namespace taut::app
