#pragma once

#include <string>

namespace taut::app
{
/// Errors: BadInput, with the nearest name, if `folder` is not one that `taut
/// run`, `compare`, `modes` or `study` has written.
void check_result_folder(const std::string& folder);
} // namespace taut::app
