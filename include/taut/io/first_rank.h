#pragma once

#include <taut/base/exceptions.h>

#include <deal.II/base/mpi.h>

#include <string>

namespace taut::io
{
/// What a rank tells the others: a result, or why there is none.
template <typename Result>
struct Answer
{
  Result result{};
  bool refused = false;
  std::string message, file, key;
  unsigned int line = 0;

  template <typename Archive>
  void serialize(Archive& archive, const unsigned int)
  {
    archive& result& refused& message& file& key& line;
  }
};

/// Calls function() on the first rank alone and gives its result on all.
/// Collective. Errors: a BadInput of the function reaches every rank.
template <typename Function>
auto on_first_rank(const MPI_Comm communicator, const Function& function)
{
  Answer<decltype(function())> answer;
  if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    try
    {
      answer.result = function();
    }
    catch (const BadInput& error)
    {
      answer.refused = true;
      answer.message = error.message();
      answer.file = error.file();
      answer.line = error.line();
      answer.key = error.key();
    }
  answer = dealii::Utilities::MPI::broadcast(communicator, answer, 0);
  if (answer.refused)
    throw BadInput(answer.message, answer.file, answer.line, answer.key);
  return answer.result;
}
} // namespace taut::io
