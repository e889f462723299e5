#include <taut/io/first_rank.h>

#include <memory>

#include "commands.h"
#include "python_script.h"
#include "result_folder.h"

namespace taut::app
{
namespace
{
/// As they are given on: options with their words, flags alone.
struct RenderArguments
{
  std::string folder;
  std::string field, times, frames, mode, size, view, output;
  bool animation = false;
};

std::vector<std::string> make_words(const RenderArguments& arguments)
{
  std::vector<std::string> words = {arguments.folder};
  const std::pair<const char*, const std::string&> options[] = {
      {"--field", arguments.field},   {"--times", arguments.times},
      {"--frames", arguments.frames}, {"--mode", arguments.mode},
      {"--size", arguments.size},     {"--view", arguments.view},
      {"--output", arguments.output}};
  for (const auto& [name, value] : options)
    if (!value.empty())
      words.push_back(std::string(name) + "=" + value);
  if (arguments.animation)
    words.push_back("--animation");
  return words;
}

void add_options(CLI::App& command, RenderArguments& arguments)
{
  command
      .add_option("DIR", arguments.folder,
                  "folder of a run, a comparison or of modes")
      ->required();
  command.add_option("--field", arguments.field,
                     "what colours the device: a field of its .vtu, such as "
                     "stress_1; the true field if there are electrodes, else "
                     "the larger stress, of modes their shape");
  auto* times = command.add_option(
      "--times", arguments.times,
      "times of the stills in s, or numbers of modes: 0,0.1,0.5");
  command
      .add_option("--frames", arguments.frames,
                  "how many stills, evenly over the run; 4 if none")
      ->excludes(times);
  command.add_flag("--animation", arguments.animation,
                   "also an animation of the run, or of a mode");
  command.add_option("--mode", arguments.mode,
                     "which mode is animated; 1 if none");
  command.add_option("--size", arguments.size,
                     "width x height in pixels; 1200x800 if none");
  command.add_option("--view", arguments.view,
                     "top, front, side, oblique, or azimuth,elevation in "
                     "degrees; as suits the device if none");
  command.add_option("-o,--output", arguments.output,
                     "folder of the pictures; DIR/pictures if none");
}
} // namespace

void add_render(CLI::App& program, Action& chosen)
{
  auto* command = program.add_subcommand(
      "render", "Draw stills and an animation of a run by ParaView");
  const auto arguments = std::make_shared<RenderArguments>();
  add_options(*command, *arguments);
  command->callback(
      [&chosen, arguments]
      {
        chosen = [arguments](const MPI_Comm communicator)
        {
          return io::on_first_rank(communicator,
                                   [&]
                                   {
                                     check_result_folder(arguments->folder);
                                     return run_script("render.py",
                                                       make_words(*arguments));
                                   });
        };
      });
}
} // namespace taut::app
