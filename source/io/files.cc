#include <taut/base/exceptions.h>
#include <taut/io/files.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace taut::io
{
namespace
{
[[noreturn]] void fail(const std::string& file)
{
  throw std::runtime_error("cannot write " + file + ": " +
                           std::strerror(errno));
}

void write_down(const int descriptor, const std::string& content,
                const std::string& file, const bool wait_for_disk)
{
  std::size_t written = 0;
  while (written < content.size())
  {
    const ssize_t count =
        write(descriptor, content.data() + written, content.size() - written);
    if (count < 0 && errno != EINTR)
      fail(file);
    if (count > 0)
      written += count;
  }
  if (wait_for_disk && fsync(descriptor) != 0)
    fail(file);
}
} // namespace

std::string read_file(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file) || !stream)
    throw BadInput("the file is missing or cannot be read", file, 0, "");
  return {std::istreambuf_iterator<char>(stream), {}};
}

void replace_file(const std::string& file, const std::string& content,
                  const bool wait_for_disk)
{
  const std::string beside = file + ".new";
  const int descriptor =
      open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0)
    fail(beside);
  try
  {
    write_down(descriptor, content, beside, wait_for_disk);
  }
  catch (...)
  {
    close(descriptor);
    throw;
  }
  if (close(descriptor) != 0)
    fail(beside);
  std::filesystem::rename(beside, file);
}
} // namespace taut::io
