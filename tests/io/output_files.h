// A folder for the output of a test, the same on all ranks.
#pragma once

#include <taut/io/first_rank.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <filesystem>
#include <string>

namespace taut::io::testing
{
inline bool is_first()
{
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
}

/// Vanishes with the object. Collective.
class SharedFolder
{
public:
  explicit SharedFolder(const std::string& name)
      : path_(on_first_rank(MPI_COMM_WORLD,
                            [&]
                            {
                              const auto folder =
                                  std::filesystem::temp_directory_path() /
                                  ("taut_" + name + "_" +
                                   std::to_string(getpid()));
                              std::filesystem::create_directories(folder);
                              return folder.string();
                            }))
  {
  }
  ~SharedFolder()
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::filesystem::remove_all(path_);
  }
  SharedFolder(const SharedFolder&) = delete;
  SharedFolder& operator=(const SharedFolder&) = delete;

  std::string get(const std::string& name) const
  {
    return path_ + "/" + name;
  }
  const std::string& path() const
  {
    return path_;
  }

private:
  std::string path_;
};
} // namespace taut::io::testing
