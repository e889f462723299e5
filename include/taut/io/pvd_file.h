#pragma once

#include <map>
#include <string>
#include <vector>

namespace taut::io
{
/// A time (s) and its files, by the number of the part that they hold.
struct PvdFrame
{
  double time;
  std::map<unsigned int, std::string> parts;
};

/// ParaView's list of the frames of a run. Frames that follow each other with
/// the same time stay apart: the parts of a frame are listed in their order.
/// Errors: BadInput if the file cannot be read as such.
std::vector<PvdFrame> read_pvd(const std::string& file);

/// The content of the file. Times keep all of their digits.
std::string make_pvd(const std::vector<PvdFrame>& frames);
} // namespace taut::io
