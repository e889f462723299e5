#include "worker.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <boost/algorithm/string.hpp>

extern char** environ;

namespace taut::app
{
namespace
{
[[noreturn]] void fail(const std::string& what)
{
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

struct Pipe
{
  Pipe()
  {
    // Workers must not hold the ends of each other's pipes.
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
      fail("no pipe for a worker");
  }
  std::array<int, 2> ends{};
  int read_end() const
  {
    return ends[0];
  }
  int write_end() const
  {
    return ends[1];
  }
};

/// A worker is the only rank of its own MPI world: what mpirun or this process
/// say about theirs must not reach it. Its libraries compute on one core.
std::vector<std::string> make_environment()
{
  std::vector<std::string> all;
  for (char** entry = environ; *entry; ++entry)
  {
    const std::string text = *entry;
    const bool is_foreign = boost::starts_with(text, "OMPI_") ||
                            boost::starts_with(text, "PMIX_") ||
                            boost::starts_with(text, "ORTE_") ||
                            boost::starts_with(text, "OMP_NUM_THREADS=") ||
                            boost::starts_with(text, "OPENBLAS_NUM_THREADS=");
    if (!is_foreign)
      all.push_back(text);
  }
  all.insert(all.end(),
             {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
              "OMPI_MCA_btl=self", "OMPI_MCA_ess_singleton_isolated=1",
              "OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1"});
  return all;
}

std::vector<char*> get_pointers(std::vector<std::string>& words)
{
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// The last lines that say something, as one.
std::string shorten(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    if (!boost::trim_copy(line).empty())
      lines.push_back(boost::trim_copy(line));
  const std::size_t shown = 3;
  if (lines.size() > shown)
    lines.erase(lines.begin(), lines.end() - shown);
  return boost::algorithm::join(lines, " / ");
}

bool read_into(const int descriptor, std::string& text)
{
  std::array<char, 65536> buffer;
  const ssize_t count = read(descriptor, buffer.data(), buffer.size());
  if (count > 0)
    text.append(buffer.data(), count);
  return count > 0 || (count < 0 && errno == EINTR);
}
} // namespace

Worker::Worker()
{
  const Pipe input, answers, errors;
  input_ = input.write_end();
  answers_ = answers.read_end();
  errors_ = errors.read_end();
  start(input.read_end(), answers.write_end(), errors.write_end());
  close(input.read_end());
  close(answers.write_end());
  close(errors.write_end());
  if (process_ < 0)
    throw std::runtime_error("no worker can be started");
}

void Worker::start(const int input, const int answers, const int errors)
{
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null",
                                   O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, answers, answer_descriptor);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // Ctrl-C reaches the coordinator alone, which passes it on once: a second
  // signal ends a run without its checkpoint.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::vector<std::string> words = {"taut", "work", std::to_string(getpid())};
  std::vector<std::string> environment = make_environment();
  if (posix_spawn(&process_, "/proc/self/exe", &actions, &attributes,
                  get_pointers(words).data(),
                  get_pointers(environment).data()) != 0)
    process_ = -1;
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
}

Worker::~Worker()
{
  close_input();
  if (process_ > 0)
  {
    // MPI tidies up its own files.
    const int patience = 5000;
    pollfd watched{answers_, 0, 0};
    if (poll(&watched, 1, patience) <= 0)
      kill(process_, SIGKILL);
    wait_for_end();
  }
  close(answers_);
  close(errors_);
}

void Worker::send(const std::string& line)
{
  std::size_t written = 0;
  while (written < line.size())
  {
    const ssize_t count =
        write(input_, line.data() + written, line.size() - written);
    if (count < 0 && errno != EINTR)
      return;
    if (count > 0)
      written += count;
  }
}

void Worker::close_input()
{
  if (input_ >= 0)
    close(input_);
  input_ = -1;
}

void Worker::signal(const int number) const
{
  if (process_ > 0)
    kill(process_, number);
}

bool Worker::receive()
{
  return read_into(answers_, received_);
}

void Worker::receive_errors()
{
  const std::size_t most = 10000;
  if (!read_into(errors_, error_text_))
  {
    close(errors_);
    errors_ = -1;
  }
  if (error_text_.size() > most)
    error_text_.erase(0, error_text_.size() - most);
}

bool Worker::take_line(std::string& line)
{
  const std::size_t end = received_.find('\n');
  if (end == std::string::npos)
    return false;
  line = received_.substr(0, end);
  received_.erase(0, end + 1);
  return true;
}

int Worker::wait_for_end()
{
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR)
  {
  }
  process_ = -1;
  return status;
}

std::string Worker::describe_end()
{
  close_input();
  const int status = wait_for_end();
  while (errors_ >= 0)
    receive_errors();
  std::string text =
      WIFSIGNALED(status)
          ? fmt::format("its process was ended by signal {} ({})",
                        WTERMSIG(status), strsignal(WTERMSIG(status)))
          : fmt::format("its process ended with code {}", WEXITSTATUS(status));
  const std::string said = shorten(error_text_);
  return said.empty() ? text : text + ": " + said;
}
} // namespace taut::app
