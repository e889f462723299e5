#include "study_run.h"

#include <taut/base/exceptions.h>
#include <taut/io/files.h>
#include <taut/io/interrupt.h>
#include <taut/io/parameters.h>
#include <taut/io/run_log.h>
#include <taut/io/study_journal.h>
#include <taut/io/study_table.h>

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>

#include "exit_codes.h"
#include "python_script.h"

namespace taut::app
{
namespace
{
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

double get_seconds_since(const Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string to_clock(const double seconds)
{
  const long whole = static_cast<long>(seconds);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60,
                     whole % 60);
}

/// One study while it is computed.
class StudyRun
{
public:
  StudyRun(const io::StudyFile& study, const StudyOptions& options,
           WorkerPool& pool)
      : study_(study), folder_{options.folder}, pool_(pool),
        cases_(study.cases), journal_(open_journal(options)),
        log_(folder_.log()), outcomes_(journal_.outcomes())
  {
    io::replace_file(folder_.parameters(), study.effective_parameters);
    forget(options.retry_failed);
  }

  int run()
  {
    io::catch_interrupts();
    update_results();
    collect_missing();
    try
    {
      compute_missing();
    }
    catch (...)
    {
      write_tables();
      throw;
    }
    return finish();
  }

private:
  io::StudyJournal open_journal(const StudyOptions& options) const
  {
    io::prepare_folder(folder_, options.overwrite);
    return {folder_, study_};
  }

  io::StudyState get_state() const
  {
    return {study_.content, cases_, outcomes_};
  }

  void forget(bool failed);
  void update_results();
  bool update_results(const study::StudyCase& item, io::CaseOutcome& outcome);
  void collect_missing();
  void compute_missing();
  void give_jobs();
  void take(const WorkerReport& report);
  io::CaseOutcome make_dead(const WorkerReport& report) const;
  void check_results(const io::CaseOutcome& outcome) const;
  void record(const io::CaseOutcome& outcome);
  void report_progress();
  void write_tables();
  int finish();
  void plot();

  const io::StudyFile& study_;
  const io::StudyFolder folder_;
  WorkerPool& pool_;
  const std::vector<study::StudyCase>& cases_;
  io::StudyJournal journal_;
  io::RunLog log_;
  io::CaseOutcomes outcomes_;
  /// Indices of the cases to compute, the next at the end.
  std::vector<std::size_t> missing_;
  /// Of this call.
  std::size_t computed_ = 0, reported_ = 0, to_compute_ = 0;
  /// Failures that the log names.
  std::size_t told_ = 0;
  bool stopping_ = false;
  const Clock::time_point began_ = Clock::now();
  Clock::time_point last_tables_ = began_;
};

/// Drops the outcomes of cases that are to be computed again.
void StudyRun::forget(const bool failed)
{
  for (auto outcome = outcomes_.begin(); outcome != outcomes_.end();)
  {
    const bool again = outcome->second.status == "interrupted" ||
                       (failed && !outcome->second.is_done());
    outcome = again ? outcomes_.erase(outcome) : std::next(outcome);
  }
}

/// The results of a case that was computed when the study asked for others.
/// False if they are not known without computing it again.
bool StudyRun::update_results(const study::StudyCase& item,
                              io::CaseOutcome& outcome)
{
  const io::OutputFolder folder{folder_.get_case(item.folder)};
  if (!study_.content.keep_folders ||
      !std::filesystem::exists(folder.summary()))
    return false;
  const auto case_file =
      io::make_case_file(study_.case_text, io::get_overrides(item), false);
  const io::RecordedRun run = io::read_run(folder);
  const auto events = io::get_event_names(case_file.content);
  for (std::size_t i = 0; i < item.results.size(); ++i)
    try
    {
      outcome.results.push_back(
          io::compute_result(run, item.results[i], events));
    }
    catch (const BadInput& problem)
    {
      outcome.mistake =
          io::ResultMistake{static_cast<unsigned int>(i), problem.message()};
      check_results(outcome);
    }
  return true;
}

void StudyRun::update_results()
{
  for (const study::StudyCase& item : cases_)
  {
    const auto outcome = outcomes_.find(item.number);
    if (outcome == outcomes_.end() || !outcome->second.is_done() ||
        outcome->second.results.size() == item.results.size())
      continue;
    outcome->second.results.clear();
    if (update_results(item, outcome->second))
      journal_.add(outcome->second);
    else
      outcomes_.erase(outcome);
  }
}

void StudyRun::collect_missing()
{
  for (std::size_t i = cases_.size(); i-- > 0;)
    if (outcomes_.count(cases_[i].number) == 0)
      missing_.push_back(i);
  to_compute_ = missing_.size();
  if (to_compute_ < cases_.size())
    log_.say(fmt::format("going on: {} of {} cases are there",
                         cases_.size() - to_compute_, cases_.size()));
}

void StudyRun::give_jobs()
{
  while (!missing_.empty() && pool_.has_room())
  {
    const std::size_t index = missing_.back();
    missing_.pop_back();
    const study::StudyCase& item = cases_[index];
    io::CaseJob job;
    job.number = item.number;
    job.case_file = study_.content.case_file;
    job.command = study_.content.command;
    job.overrides = io::get_overrides(item);
    if (study_.content.keep_folders)
      job.folder = folder_.get_case(item.folder);
    // A case that has failed begins anew.
    job.resume = journal_.outcomes().count(item.number) == 0 ||
                 journal_.outcomes().at(item.number).status == "interrupted";
    job.results = item.results;
    pool_.give(index, io::write_line(job));
  }
}

void StudyRun::compute_missing()
{
  while (pool_.is_busy() || (!missing_.empty() && !stopping_))
  {
    if (!stopping_)
      give_jobs();
    const int milliseconds = 200;
    for (const WorkerReport& report : pool_.wait(milliseconds))
      take(report);
    if (io::was_interrupted() && !stopping_)
    {
      log_.say("interrupted: waiting for checkpoints");
      pool_.signal(SIGTERM);
      stopping_ = true;
    }
    report_progress();
    if (Clock::now() - last_tables_ > 10s)
      write_tables();
  }
}

io::CaseOutcome StudyRun::make_dead(const WorkerReport& report) const
{
  io::CaseOutcome outcome;
  outcome.number = cases_[report.job].number;
  outcome.status = "failed";
  outcome.reason = report.end;
  return outcome;
}

void StudyRun::take(const WorkerReport& report)
{
  // Whoever dies of being asked to stop has not failed.
  if (!report.answer && stopping_)
    return;
  io::CaseOutcome outcome =
      report.answer ? io::read_outcome(*report.answer) : make_dead(report);
  const io::CaseOutcome asked = outcome;
  if (outcome.mistake)
  {
    outcome.mistake.reset();
    outcome.results.clear();
  }
  record(outcome);
  check_results(asked);
}

/// What the first finished case cannot have no case has.
void StudyRun::check_results(const io::CaseOutcome& outcome) const
{
  if (!outcome.mistake)
    return;
  const study::SweepResult& result =
      study_.content.results[outcome.mistake->result];
  study_.text.refuse({"Result " + result.name}, "Of",
                     fmt::format("case {}: {}; the cases that were computed "
                                 "are kept",
                                 outcome.number, outcome.mistake->message));
}

void StudyRun::record(const io::CaseOutcome& outcome)
{
  journal_.add(outcome);
  outcomes_[outcome.number] = outcome;
  ++computed_;
  const std::size_t most_told = 20;
  const bool has_failed =
      outcome.status == "failed" || outcome.status == "refused";
  if (has_failed && ++told_ <= most_told)
    log_.say(fmt::format("case {} ({}) {}: {}{}", outcome.number,
                         cases_[outcome.number - 1].folder, outcome.status,
                         outcome.reason,
                         told_ == most_told ? "\n(further ones are in "
                                              "study.csv)"
                                            : ""));
}

void StudyRun::report_progress()
{
  // Nothing new is no news, but on a terminal the time goes on.
  if (computed_ == reported_ && isatty(STDOUT_FILENO) == 0)
    return;
  log_.report(
      [&]
      {
        reported_ = computed_;
        const double seconds = get_seconds_since(began_);
        const double rate = double(computed_) / seconds;
        const auto counts = io::count_outcomes(get_state());
        std::string line =
            fmt::format("{} of {} cases", outcomes_.size(), counts.total);
        if (computed_ > 0)
          line += fmt::format("  {:.3g} a second  {} left", rate,
                              to_clock(double(to_compute_ - computed_) / rate));
        if (counts.failed + counts.refused > 0)
          line += fmt::format("  {} failed", counts.failed + counts.refused);
        return line;
      });
}

void StudyRun::write_tables()
{
  io::replace_file(folder_.table(), io::make_study_table(get_state()));
  io::replace_file(folder_.summary(),
                   io::make_study_json(get_state(), !missing_.empty(),
                                       get_seconds_since(began_)));
  last_tables_ = Clock::now();
}

void StudyRun::plot()
{
  if (study_.content.plot.empty())
    return;
  const std::string problem =
      run_plot_script(study_.content.plot, {folder_.path});
  if (!problem.empty())
    log_.say(problem);
}

int StudyRun::finish()
{
  write_tables();
  const auto counts = io::count_outcomes(get_state());
  std::string text = fmt::format("{} of {} done", counts.done, counts.total);
  if (counts.failed > 0)
    text += fmt::format(", {} failed", counts.failed);
  if (counts.refused > 0)
    text += fmt::format(", {} refused", counts.refused);
  const std::size_t left = counts.total - outcomes_.size() + counts.interrupted;
  if (left > 0)
    text += fmt::format(", {} interrupted: the same command goes on", left);
  log_.say(fmt::format("{}: see {}", text, folder_.table()));
  if (left > 0)
    return interrupted;
  plot();
  return counts.done == counts.total ? done : solver_failed;
}
} // namespace

int run_study(const io::StudyFile& study, const StudyOptions& options,
              WorkerPool& pool)
{
  return StudyRun(study, options, pool).run();
}
} // namespace taut::app
