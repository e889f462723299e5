#pragma once

#include <string>

/// Files that are whole whenever someone looks at them.
namespace taut::io
{
/// The content of `file`. Errors: BadInput if it is missing or unreadable.
std::string read_file(const std::string& file);

/// Writes `content` beside `file`, down to the disk, and renames: a process
/// that dies in between leaves the old file. Without waiting for the disk, a
/// machine that dies may leave neither. Errors: std::runtime_error.
void replace_file(const std::string& file, const std::string& content,
                  bool wait_for_disk = true);
} // namespace taut::io
