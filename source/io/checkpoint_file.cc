#include <taut/base/exceptions.h>
#include <taut/io/checkpoint.h>
#include <taut/io/files.h>

#include <cstring>
#include <filesystem>
#include <sstream>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/crc.hpp>
#include <boost/serialization/map.hpp>

namespace taut::io
{
namespace
{
/// Changes with every change of StoredRun.
const std::string first_line = "taut checkpoint 2\n";

/// What follows the first line.
struct Seal
{
  std::uint64_t size;
  std::uint64_t checksum;
};

Seal make_seal(const std::string& content)
{
  boost::crc_32_type crc;
  crc.process_bytes(content.data(), content.size());
  return {content.size(), crc.checksum()};
}

std::string get_file(const std::string& folder)
{
  return folder + "/state";
}

/// The sealed content. Errors: BadInput if the seal is broken.
std::string open_seal(const std::string& bytes, const std::string& file)
{
  if (bytes.compare(0, first_line.size(), first_line) != 0)
    throw BadInput("this is no checkpoint of this version of Taut", file, 0,
                   "");
  Seal seal{};
  std::string content;
  if (bytes.size() >= first_line.size() + sizeof(seal))
  {
    std::memcpy(&seal, bytes.data() + first_line.size(), sizeof(seal));
    content = bytes.substr(first_line.size() + sizeof(seal));
  }
  const Seal found = make_seal(content);
  if (content.empty() || found.size != seal.size ||
      found.checksum != seal.checksum)
    throw BadInput("the checkpoint is cut off or damaged; start a new run",
                   file, 0, "");
  return content;
}
} // namespace

void write_checkpoint(const std::string& folder, const StoredRun& run)
{
  std::ostringstream stream;
  boost::archive::binary_oarchive(stream) << run;
  const std::string content = stream.str();
  const Seal seal = make_seal(content);
  std::filesystem::create_directories(folder);
  replace_file(
      get_file(folder),
      first_line +
          std::string(reinterpret_cast<const char*>(&seal), sizeof(seal)) +
          content);
}

StoredRun read_checkpoint(const std::string& folder)
{
  const std::string file = get_file(folder);
  std::istringstream stream(open_seal(read_file(file), file));
  StoredRun run;
  boost::archive::binary_iarchive(stream) >> run;
  return run;
}
} // namespace taut::io
