#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "worker.h"

namespace taut::app
{
/// What a worker has to tell about the job `job`.
struct WorkerReport
{
  std::size_t job = 0;
  /// None if the worker has died.
  std::optional<std::string> answer;
  /// How it died.
  std::string end;
};

/// Worker processes, each of which has one job at a time. They are started when
/// they are needed and live as long as the pool.
class WorkerPool
{
public:
  explicit WorkerPool(unsigned int size) : size_(size) {}
  /// Ends the workers; one that still has a job is asked to stop first.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Whether `give` may be called.
  bool has_room() const;
  /// Gives a line to a worker that has nothing to do; `job` comes back in the
  /// report. Errors: std::runtime_error if no worker can be started.
  void give(std::size_t job, const std::string& line);

  bool is_busy() const;

  /// Waits until something has happened, a signal has come or some time has
  /// passed. Errors: std::runtime_error if a worker ends before it is ready.
  std::vector<WorkerReport> wait(int milliseconds);

  /// Passes a signal on to all workers.
  void signal(int number) const;

private:
  struct Member
  {
    std::unique_ptr<Worker> worker;
    std::optional<std::size_t> job;
    bool ready = false;
  };
  void collect(Member& member, std::vector<WorkerReport>& reports);
  void bury(Member& member, std::vector<WorkerReport>& reports);

  std::size_t size_;
  std::vector<Member> members_;
};
} // namespace taut::app
