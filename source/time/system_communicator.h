#pragma once

#include <mpi.h>

#include <string>

namespace taut::time
{
/// The few reductions that the solvers need. Works without MPI_Init as one
/// rank, so that a lumped model needs no MPI.
class Communicator
{
public:
  explicit Communicator(MPI_Comm communicator);

  /// More than one rank.
  bool is_parallel() const
  {
    return n_ranks_ > 1;
  }
  MPI_Comm get() const
  {
    return communicator_;
  }
  long long sum(long long value) const;
  double sum(double value) const;
  double max(double value) const;
  int max(int value) const;
  /// The message of the lowest rank whose own one is not empty.
  std::string share(const std::string& message) const;

private:
  MPI_Comm communicator_;
  int rank_ = 0;
  int n_ranks_ = 1;
};
} // namespace taut::time
