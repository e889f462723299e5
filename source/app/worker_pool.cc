#include "worker_pool.h"

#include <poll.h>

#include <algorithm>
#include <csignal>
#include <stdexcept>

namespace taut::app
{
WorkerPool::~WorkerPool()
{
  for (Member& member : members_)
  {
    if (!member.worker)
      continue;
    member.worker->close_input();
    if (member.job)
      member.worker->signal(SIGTERM);
  }
}

bool WorkerPool::has_room() const
{
  return members_.size() < size_ ||
         std::any_of(members_.begin(), members_.end(),
                     [](const Member& member) { return !member.job; });
}

bool WorkerPool::is_busy() const
{
  return std::any_of(members_.begin(), members_.end(),
                     [](const Member& member)
                     { return member.job.has_value(); });
}

void WorkerPool::give(const std::size_t job, const std::string& line)
{
  auto member =
      std::find_if(members_.begin(), members_.end(),
                   [](const Member& candidate) { return !candidate.job; });
  if (member == members_.end())
  {
    members_.push_back({std::make_unique<Worker>(), std::nullopt, false});
    member = members_.end() - 1;
  }
  member->job = job;
  member->worker->send(line);
}

void WorkerPool::collect(Member& member, std::vector<WorkerReport>& reports)
{
  const bool is_open = member.worker->receive();
  std::string line;
  while (member.worker->take_line(line))
  {
    if (!member.ready)
      member.ready = line == ready_line;
    else if (member.job)
    {
      reports.push_back({*member.job, line, ""});
      member.job.reset();
    }
  }
  if (!is_open)
    bury(member, reports);
}

void WorkerPool::bury(Member& member, std::vector<WorkerReport>& reports)
{
  const std::string end = member.worker->describe_end();
  member.worker.reset();
  if (!member.ready)
    throw std::runtime_error("the workers do not start: " + end);
  if (member.job)
    reports.push_back({*member.job, std::nullopt, end});
}

std::vector<WorkerReport> WorkerPool::wait(const int milliseconds)
{
  std::vector<pollfd> watched;
  for (const Member& member : members_)
    for (const int descriptor :
         {member.worker->answers(), member.worker->errors()})
      watched.push_back({descriptor, POLLIN, 0});
  std::vector<WorkerReport> reports;
  if (poll(watched.data(), watched.size(), milliseconds) <= 0)
    return reports;
  for (std::size_t i = 0; i < members_.size(); ++i)
  {
    if (watched[2 * i + 1].revents != 0)
      members_[i].worker->receive_errors();
    if (watched[2 * i].revents != 0)
      collect(members_[i], reports);
  }
  members_.erase(std::remove_if(members_.begin(), members_.end(),
                                [](const Member& member)
                                { return !member.worker; }),
                 members_.end());
  return reports;
}

void WorkerPool::signal(const int number) const
{
  for (const Member& member : members_)
    member.worker->signal(number);
}
} // namespace taut::app
