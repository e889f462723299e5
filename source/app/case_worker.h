#pragma once

#include <taut/io/case_text.h>
#include <taut/io/study_messages.h>

#include <mpi.h>

#include <map>
#include <string>

namespace taut::app
{
/// Computes the cases of studies one after another.
class CaseWorker
{
public:
  explicit CaseWorker(MPI_Comm communicator) : communicator_(communicator) {}

  /// Whatever goes wrong with the case is in the outcome.
  io::CaseOutcome compute(const io::CaseJob& job);

private:
  void compute(const io::CaseJob& job, io::CaseOutcome& outcome);
  const io::CaseText& get_text(const std::string& file);

  const MPI_Comm communicator_;
  /// Case files by name, each read once.
  std::map<std::string, io::CaseText> texts_;
};
} // namespace taut::app
