#include <taut/base/exceptions.h>
#include <taut/io/run_log.h>

#include <fmt/format.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <unistd.h>

#include <cstdio>

namespace taut::io
{
namespace
{
using namespace std::chrono_literals;

/// Messages of this level do not reach a terminal, which has its own line.
constexpr auto progress_level = spdlog::level::debug;

std::unique_ptr<spdlog::logger> make_logger(const std::string& file,
                                            const bool on_terminal)
{
  auto console = std::make_shared<spdlog::sinks::stdout_sink_st>();
  console->set_pattern("%v");
  console->set_level(on_terminal ? spdlog::level::info : progress_level);
  std::shared_ptr<spdlog::sinks::basic_file_sink_st> log;
  try
  {
    log = std::make_shared<spdlog::sinks::basic_file_sink_st>(file);
  }
  catch (const spdlog::spdlog_ex& error)
  {
    throw BadInput(error.what(), file, 0, "");
  }
  log->set_pattern("%Y-%m-%d %H:%M:%S  %v");
  auto logger = std::make_unique<spdlog::logger>(
      "taut", spdlog::sinks_init_list{console, log});
  logger->set_level(progress_level);
  logger->flush_on(progress_level);
  return logger;
}

std::string to_clock(const double seconds)
{
  const long whole = static_cast<long>(seconds);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60,
                     whole % 60);
}
} // namespace

RunLog::RunLog(const std::string& file)
    : on_terminal_(isatty(STDOUT_FILENO) != 0),
      logger_(make_logger(file, on_terminal_)), started_(Clock::now())
{
}

RunLog::~RunLog()
{
  clear_line();
}

void RunLog::clear_line()
{
  if (line_shown_)
    std::fputs("\r\x1b[K", stdout);
  line_shown_ = false;
}

void RunLog::say(const std::string& text)
{
  clear_line();
  logger_->info(text);
}

void RunLog::set_interval(const double begin, const double end)
{
  begin_ = begin;
  end_ = end;
  started_ = Clock::now();
}

std::string RunLog::make_line(const time::Step& step,
                              const time::IntegratorStatistics& statistics,
                              const double balance_relative)
{
  const double share =
      end_ > begin_ ? (step.end() - begin_) / (end_ - begin_) : 1;
  const double elapsed =
      std::chrono::duration<double>(Clock::now() - started_).count();
  // The first steps are tiny and say nothing of the pace.
  const std::string left =
      share > 0.01 ? "  " + to_clock(elapsed * (1 - share) / share) + " left"
                   : "";
  return fmt::format(
      "t = {:.6g} s ({:.1f} %)  step {:.2e} s  order {}  Newton "
      "{}  energy balance {:.1e}{}",
      step.end(), 100 * share, step.end() - step.start(), step.order(),
      statistics.newton_iterations - newton_before_, balance_relative, left);
}

void RunLog::report(const time::Step& step,
                    const time::IntegratorStatistics& statistics,
                    const double balance_relative)
{
  report([&] { return make_line(step, statistics, balance_relative); });
  newton_before_ = statistics.newton_iterations;
}

void RunLog::report(const std::function<std::string()>& make_line)
{
  const auto now = Clock::now();
  const bool show = on_terminal_ && now - last_shown_ > 100ms;
  const bool log = now - last_logged_ > 1s;
  const std::string line = show || log ? make_line() : "";
  if (log)
  {
    logger_->log(progress_level, line);
    last_logged_ = now;
  }
  if (show)
  {
    std::fputs(("\r" + line + "\x1b[K").c_str(), stdout);
    std::fflush(stdout);
    line_shown_ = true;
    last_shown_ = now;
  }
}
} // namespace taut::io
