#pragma once

#include <taut/time/integrate.h>

#include <spdlog/logger.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace taut::io
{
/// What a run says: on standard output and, with the time of day, in log.txt.
/// A terminal shows the progress on one line that is rewritten; anything else
/// gets a line of its own, at most one a second, like log.txt.
class RunLog
{
public:
  /// Adds to `file`. Errors: BadInput if it cannot be written.
  explicit RunLog(const std::string& file);
  ~RunLog();

  void say(const std::string& text);

  /// `begin` and `end` of the run (s).
  void set_interval(double begin, double end);
  void report(const time::Step& step,
              const time::IntegratorStatistics& statistics,
              double balance_relative);
  /// Shows make_line() as the progress where it is time for a new line.
  void report(const std::function<std::string()>& make_line);

private:
  using Clock = std::chrono::steady_clock;
  std::string make_line(const time::Step& step,
                        const time::IntegratorStatistics& statistics,
                        double balance_relative);
  void clear_line();

  const bool on_terminal_;
  std::unique_ptr<spdlog::logger> logger_;
  double begin_ = 0, end_ = 0;
  long newton_before_ = 0;
  bool line_shown_ = false;
  Clock::time_point started_, last_shown_{}, last_logged_{};
};
} // namespace taut::io
