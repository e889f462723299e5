#include <taut/io/first_rank.h>

#include <memory>

#include "commands.h"
#include "python_script.h"
#include "result_folder.h"

namespace taut::app
{
namespace
{
struct ReportArguments
{
  std::string folder;
  std::string output;
  bool without_pictures = false;
};

std::vector<std::string> make_words(const ReportArguments& arguments)
{
  std::vector<std::string> words = {arguments.folder};
  if (!arguments.output.empty())
    words.push_back("--output=" + arguments.output);
  if (arguments.without_pictures)
    words.push_back("--no-pictures");
  return words;
}
} // namespace

void add_report(CLI::App& program, Action& chosen)
{
  auto* command = program.add_subcommand(
      "report", "Write one HTML page about a run or a study");
  const auto arguments = std::make_shared<ReportArguments>();
  command
      ->add_option("DIR", arguments->folder,
                   "folder of a run, a comparison, of modes or a study; it may "
                   "have failed or been killed")
      ->required();
  command->add_option("-o,--output", arguments->output,
                      "the file; DIR/report.html if none");
  command->add_flag("--no-pictures", arguments->without_pictures,
                    "do not draw pictures that are not there yet");
  command->callback(
      [&chosen, arguments]
      {
        chosen = [arguments](const MPI_Comm communicator)
        {
          return io::on_first_rank(communicator,
                                   [&]
                                   {
                                     check_result_folder(arguments->folder);
                                     return run_script("report.py",
                                                       make_words(*arguments));
                                   });
        };
      });
}
} // namespace taut::app
