#pragma once

#include <sys/types.h>

#include <string>

namespace taut::app
{
/// Where a worker writes its answers; its standard output is nobody's.
constexpr int answer_descriptor = 3;
/// The first line that it writes.
constexpr const char* ready_line = "ready";

/// A process of this program that computes cases (`taut work`): jobs go to its
/// standard input, a line each.
class Worker
{
public:
  /// Errors: std::runtime_error if no process can be started.
  Worker();
  /// Closes the input, waits a while for the end of the process and ends it if
  /// it does not come.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Does nothing if the process has ended.
  void send(const std::string& line);
  /// No more jobs follow: the worker ends after the one it has.
  void close_input();
  /// Passes a signal on.
  void signal(int number) const;

  /// What to wait for until there is an answer or an error message.
  int answers() const
  {
    return answers_;
  }
  int errors() const
  {
    return errors_;
  }

  /// Takes what has come. False if the process has closed its answers.
  bool receive();
  /// Keeps what has come for describe_end.
  void receive_errors();
  /// Whether `line` got the next whole answer.
  bool take_line(std::string& line);

  /// Waits for the end of the process and says how it ended.
  std::string describe_end();

private:
  void start(int input, int answers, int errors);
  int wait_for_end();

  pid_t process_ = -1;
  int input_ = -1, answers_ = -1, errors_ = -1;
  std::string received_, error_text_;
};
} // namespace taut::app
