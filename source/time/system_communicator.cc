#include "system_communicator.h"

namespace taut::time
{
namespace
{
template <class Number>
Number reduce(Number value, MPI_Datatype type, MPI_Op operation,
              const Communicator& communicator)
{
  if (communicator.is_parallel())
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, type, operation, communicator.get());
  return value;
}
} // namespace

Communicator::Communicator(const MPI_Comm communicator)
    : communicator_(communicator)
{
  int initialized = 0;
  MPI_Initialized(&initialized);
  if (initialized == 0)
    return;
  MPI_Comm_rank(communicator_, &rank_);
  MPI_Comm_size(communicator_, &n_ranks_);
}

long long Communicator::sum(const long long value) const
{
  return reduce(value, MPI_LONG_LONG, MPI_SUM, *this);
}

double Communicator::sum(const double value) const
{
  return reduce(value, MPI_DOUBLE, MPI_SUM, *this);
}

double Communicator::max(const double value) const
{
  return reduce(value, MPI_DOUBLE, MPI_MAX, *this);
}

int Communicator::max(const int value) const
{
  return reduce(value, MPI_INT, MPI_MAX, *this);
}

std::string Communicator::share(const std::string& message) const
{
  if (!is_parallel())
    return message;
  const int speaker =
      reduce(message.empty() ? n_ranks_ : rank_, MPI_INT, MPI_MIN, *this);
  if (speaker == n_ranks_)
    return message;
  std::string shared = message;
  int length = static_cast<int>(shared.size());
  MPI_Bcast(&length, 1, MPI_INT, speaker, communicator_);
  shared.resize(static_cast<std::size_t>(length));
  MPI_Bcast(shared.data(), length, MPI_CHAR, speaker, communicator_);
  return shared;
}
} // namespace taut::time
