#include "python_script.h"

#include <taut/base/exceptions.h>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

extern char** environ;

namespace taut::app
{
namespace
{
constexpr const char* without_python =
    "there is no python3 with matplotlib; install it by `apt install "
    "python3-matplotlib`, or name another Python in TAUT_PYTHON";

/// The program's exit code; -1 if it could not be started.
int run_program(std::vector<std::string> words)
{
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t child;
  int status = 0;
  if (posix_spawnp(&child, pointers[0], nullptr, nullptr, pointers.data(),
                   environ) != 0)
    return -1;
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status))
    return -1;
  return WEXITSTATUS(status);
}

/// Whether the interpreter is there and finds matplotlib, without running it.
bool has_matplotlib(const std::string& python)
{
  return run_program({python, "-c",
                      "import importlib.util as i, sys; "
                      "sys.exit(i.find_spec('matplotlib') is None)"}) == 0;
}

std::string find_python()
{
  if (const char* wanted = std::getenv("TAUT_PYTHON"))
    return has_matplotlib(wanted) ? wanted : "";
  for (const char* python : {"python3", "/usr/bin/python3"})
    if (has_matplotlib(python))
      return python;
  return "";
}
} // namespace

std::string run_plot_script(const std::string& script,
                            const std::vector<std::string>& arguments)
{
  const std::string python = find_python();
  if (python.empty())
    return std::string("no plots: ") + without_python;
  const std::string file = std::filesystem::path(TAUT_POSTPROCESS) / script;
  std::vector<std::string> words = {python, "-B", file};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const int code = run_program(words);
  if (code == 0)
    return "";
  return fmt::format("no plots: {} {} ended with code {}", python, file, code);
}

int run_script(const std::string& script,
               const std::vector<std::string>& arguments)
{
  const std::string python = find_python();
  if (python.empty())
    throw BadInput(without_python);
  std::vector<std::string> words = {
      python, "-B", std::filesystem::path(TAUT_POSTPROCESS) / script};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const int code = run_program(words);
  if (code < 0)
    throw std::runtime_error(python + " could not run " + script);
  return code;
}
} // namespace taut::app
