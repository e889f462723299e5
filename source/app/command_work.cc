#include <taut/io/interrupt.h>
#include <taut/io/study_messages.h>

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "case_worker.h"
#include "commands.h"
#include "exit_codes.h"
#include "worker.h"

namespace taut::app
{
namespace
{
void answer(const std::string& line)
{
  if (write(answer_descriptor, line.data(), line.size()) !=
      static_cast<ssize_t>(line.size()))
    throw std::runtime_error("nobody takes the results of a worker");
}

/// Whoever kills the coordinator must not leave a worker behind that goes on
/// writing into the folder of a case.
void die_with(const pid_t coordinator)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != coordinator)
    throw std::runtime_error("this command is for taut study alone");
}

int work(const pid_t coordinator, const MPI_Comm communicator)
{
  die_with(coordinator);
  io::catch_interrupts();
  CaseWorker worker(communicator);
  answer(std::string(ready_line) + "\n");
  for (std::string line; std::getline(std::cin, line);)
    answer(io::write_line(worker.compute(io::read_job(line))));
  return done;
}
} // namespace

void add_work(CLI::App& program, Action& chosen)
{
  // A group without a name is not shown.
  auto* command =
      program.add_subcommand("work", "Compute the cases of a study")->group("");
  const auto coordinator = std::make_shared<pid_t>(0);
  command->add_option("COORDINATOR", *coordinator, "a process")->required();
  command->callback(
      [&chosen, coordinator]
      {
        chosen = [coordinator](const MPI_Comm communicator)
        { return work(*coordinator, communicator); };
      });
}
} // namespace taut::app
